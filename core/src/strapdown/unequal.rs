//! Samples that do not all last the nominal interval: which windows have room for that, and how it is kept.
//!
//! A window stands for samples of one interval, and costs nothing more. [`Unequal`] is the same window
//! with room for what each sample's own interval differs by: `Strapdown<F, Unequal<H2B4A2>>` takes
//! samples of any length with `push_over`. As long as all last the nominal interval, its bits are the
//! window's own; a block with others is integrated on its real abscissae.

use super::body::BodyMotion;
use super::mechanization::{Mechanization, Rejected};
use super::window::{Behind, Window};
use crate::math::compensated::Pair;
use crate::math::real::Real;
use crate::sample::Increment;

/// A mechanization that takes samples of any length.
pub trait UnequalIntervals: Mechanization {
    /// Takes a sample of its own interval in seconds, above 0 s and at most 1 s; no row is read.
    fn push_over(
        &self,
        state: &mut Self::State,
        sample: Increment<Self::Real>,
        interval_s: Pair<Self::Real>,
    ) -> Result<(), Rejected>;
    /// The same, reading the rows that it completes.
    fn push_rows_over(
        &self,
        state: &mut Self::State,
        sample: Increment<Self::Real>,
        interval_s: Pair<Self::Real>,
        read: impl FnMut(u64, Self::Output),
    ) -> Result<(), Rejected>;
    /// The same, showing every step that it completes.
    fn push_blocks_over(
        &self,
        state: &mut Self::State,
        sample: Increment<Self::Real>,
        interval_s: Pair<Self::Real>,
        see: impl FnMut(u64, &Self::Body, &Self::Frame),
    ) -> Result<(), Rejected>;
}

/// How the intervals of the stored samples are kept: not at all, or one by one.
pub trait Intervals<R: Real>: Copy {
    /// All of them nominal.
    fn nominal() -> Self;
    /// What the stored samples' intervals exceed the nominal one by, s; nothing where none can.
    fn excess(&self) -> &[R];
    /// The same, to be written.
    fn excess_mut(&mut self) -> &mut [R];
    /// What an interval exceeds the nominal one by, rounded; what that drops goes to the next one.
    fn rounded(&mut self, excess_s: Pair<R>) -> R;
    /// Duration of the block that the gravity history belongs to, s; 0 if that is known by its samples.
    fn history_s(&self) -> R;
    /// Sets it.
    fn set_history(&mut self, time_s: R);
    /// Visits what is kept, by name.
    fn each(&mut self, visit: impl FnMut(&'static str, &mut R));
}

/// Every sample lasts the nominal interval.
#[derive(Clone, Copy, Debug, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Nominal;

impl<R: Real> Intervals<R> for Nominal {
    #[inline(always)]
    fn nominal() -> Self {
        Self
    }
    #[inline(always)]
    fn excess(&self) -> &[R] {
        &[]
    }
    #[inline(always)]
    fn excess_mut(&mut self) -> &mut [R] {
        &mut []
    }
    #[inline(always)]
    fn rounded(&mut self, _: Pair<R>) -> R {
        R::ZERO
    }
    #[inline(always)]
    fn history_s(&self) -> R {
        R::ZERO
    }
    #[inline(always)]
    fn set_history(&mut self, _: R) {}
    #[inline(always)]
    fn each(&mut self, _: impl FnMut(&'static str, &mut R)) {}
}

/// Samples of any length.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Kept<R, E> {
    excess: E,
    rest: R,
    history_s: R,
}

impl<R: Real, const N: usize> Intervals<R> for Kept<R, [R; N]> {
    #[inline]
    fn nominal() -> Self {
        Self { excess: [R::ZERO; N], rest: R::ZERO, history_s: R::ZERO }
    }
    #[inline(always)]
    fn excess(&self) -> &[R] {
        &self.excess
    }
    #[inline(always)]
    fn excess_mut(&mut self) -> &mut [R] {
        &mut self.excess
    }
    #[inline]
    fn rounded(&mut self, excess_s: Pair<R>) -> R {
        let exact = Pair::sum(excess_s.hi, excess_s.lo + self.rest);
        self.rest = exact.lo;
        exact.hi
    }
    #[inline(always)]
    fn history_s(&self) -> R {
        self.history_s
    }
    #[inline(always)]
    fn set_history(&mut self, time_s: R) {
        self.history_s = time_s;
    }
    #[inline]
    fn each(&mut self, mut visit: impl FnMut(&'static str, &mut R)) {
        for excess in &mut self.excess {
            visit("interval_excess", excess);
        }
        visit("interval_rest", &mut self.rest);
        visit("history_time", &mut self.history_s);
    }
}

/// A window with room for samples of any length.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Unequal<W>(pub W);

impl<W: Window> Window for Unequal<W> {
    const HISTORY: usize = W::HISTORY;
    const BLOCK: usize = W::BLOCK;
    const LOOKAHEAD: usize = W::LOOKAHEAD;
    const BESIDE: usize = W::BESIDE;
    const COEFFICIENTS: usize = W::COEFFICIENTS;
    const TERMS: usize = W::TERMS;
    const UNEQUAL: bool = true;
    type Samples<T: Copy> = W::Samples<T>;
    type Series<R: Real> = W::Series<R>;
    type Intervals<R: Real> = W::KeptIntervals<R>;
    type KeptIntervals<R: Real> = W::KeptIntervals<R>;

    #[inline]
    fn samples<T: Copy>(fill: T) -> Self::Samples<T> {
        W::samples(fill)
    }

    // One code for all frames and readers, here and below.
    #[inline(never)]
    fn integrate_behind<R: Real>(
        seen: &[Increment<R>],
        half_time_s: R,
        order: usize,
        two_float: bool,
    ) -> Option<Behind<R, Self::Series<R>>> {
        W::integrate_behind(seen, half_time_s, order, two_float)
    }

    #[inline(never)]
    fn integrate<R: Real>(
        samples: &[Increment<R>],
        half_time_s: R,
        order: usize,
        two_float: bool,
    ) -> Option<(BodyMotion<R>, Self::Series<R>)> {
        W::integrate(samples, half_time_s, order, two_float)
    }
}
