//! The intervals of the samples in a window: not stored, or stored one by one.

use crate::math::compensated::Pair;
use crate::math::real::Real;

/// Storage of the intervals of the stored samples: none, or one by one.
pub trait Intervals<R: Real>: Copy {
    /// All of them nominal.
    fn nominal() -> Self;
    /// The stored samples' intervals less the nominal one, s; empty if all are nominal.
    fn excess(&self) -> &[R];
    /// The same, to write.
    fn excess_mut(&mut self) -> &mut [R];
    /// An interval less the nominal one, rounded; the remainder is carried to the next one.
    fn rounded(&mut self, excess_s: Pair<R>) -> R;
    /// Duration of the block that the gravity history belongs to, s; 0 if its number of samples determines it.
    fn history_s(&self) -> R;
    /// Sets it.
    fn set_history(&mut self, time_s: R);
    /// Visits the stored numbers, by name.
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
