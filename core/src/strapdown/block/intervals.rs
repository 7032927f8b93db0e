//! The intervals of the samples in a window: not stored, or stored one by one.
//!
//! ```
//! use schuler::math::compensated::Pair;
//! use schuler::strapdown::block::intervals::{Intervals, Kept};
//!
//! // A third of a millisecond is no binary fraction: what is rounded off is carried to the next sample.
//! let third = Pair::new(1e-3_f64) * Pair::new(3.0).reciprocal();
//! let mut kept = Kept::<f64, [f64; 4]>::nominal();
//! let first = kept.rounded(third);
//! assert_eq!(first, third.hi);
//! assert_eq!(kept.excess(), [0.0; 4]);
//! ```

use crate::math::compensated::Pair;
use crate::math::real::Real;
use crate::record::Record;

/// Storage of the intervals of the stored samples: none, or one by one.
pub trait Intervals<R: Real>: Copy + Send {
    /// All of them nominal.
    fn nominal() -> Self;
    /// The stored samples' intervals less the nominal one, s; empty if all are nominal.
    fn excess(&self) -> &[R];
    /// An interval less the nominal one, rounded; the remainder is carried to the next one.
    fn rounded(&mut self, excess_s: Pair<R>) -> R;
    /// The same to write, with the duration of the block that the gravity history belongs to, s, which is 0 if
    /// its number of samples determines it. `None` if all are nominal.
    fn kept_mut(&mut self) -> Option<(&mut [R], &mut R)>;
    /// What is stored of a sample's interval: 0 if it is the nominal one, whose remainder is not used then.
    #[inline]
    fn over(&mut self, interval_s: Pair<R>, nominal_s: Pair<R>) -> R {
        let excess = interval_s - nominal_s;
        let nominal = excess.hi.is_within(R::ZERO) & excess.lo.is_within(R::ZERO);
        if nominal { R::ZERO } else { self.rounded(excess) }
    }
    /// The gravity history belongs to another path.
    #[inline]
    fn forget_history(&mut self) {
        if let Some((_, history_s)) = self.kept_mut() {
            *history_s = R::ZERO;
        }
    }
    /// Reads the stored numbers, as [`Record::record`] does.
    fn record_kept(&self, read: &mut impl FnMut(&'static str, u64))
    where
        R: Record;
    /// Writes the stored numbers, as [`Record::restore`] does.
    fn restore_kept(&mut self, write: &mut impl FnMut(&'static str, u64) -> u64)
    where
        R: Record;
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
    fn rounded(&mut self, _: Pair<R>) -> R {
        R::ZERO
    }
    #[inline(always)]
    fn kept_mut(&mut self) -> Option<(&mut [R], &mut R)> {
        None
    }
    #[inline(always)]
    fn record_kept(&self, _: &mut impl FnMut(&'static str, u64)) {}
    #[inline(always)]
    fn restore_kept(&mut self, _: &mut impl FnMut(&'static str, u64) -> u64) {}
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
    #[inline]
    fn rounded(&mut self, excess_s: Pair<R>) -> R {
        let exact = Pair::sum(excess_s.hi, excess_s.lo + self.rest);
        self.rest = exact.lo;
        exact.hi
    }
    #[inline(always)]
    fn kept_mut(&mut self) -> Option<(&mut [R], &mut R)> {
        Some((&mut self.excess, &mut self.history_s))
    }
    #[inline]
    fn record_kept(&self, read: &mut impl FnMut(&'static str, u64))
    where
        R: Record,
    {
        self.excess.record("interval_excess", read);
        self.rest.record("interval_rest", read);
        self.history_s.record("history_time", read);
    }
    #[inline]
    fn restore_kept(&mut self, write: &mut impl FnMut(&'static str, u64) -> u64)
    where
        R: Record,
    {
        self.excess.restore("interval_excess", write);
        self.rest.restore("interval_rest", write);
        self.history_s.restore("history_time", write);
    }
}
