//! Windows for samples that do not all last the nominal interval.
//!
//! A named window is for samples of one interval. [`Unequal`] is the same window with room for the intervals
//! of its samples: `Strapdown<F, Unequal<H2B4A2>>` takes samples of any length with `push_over`. As long as all
//! last the nominal interval, its bits are those of the window itself. A block with other samples is integrated
//! at its true abscissae.
//!
//! ```
//! use schuler::strapdown::block::unequal::Unequal;
//! use schuler::strapdown::block::window::{H2B4A2, Window};
//!
//! assert_eq!(Unequal::<H2B4A2>::SHAPE, H2B4A2::SHAPE);
//! ```

use super::body::BodyMotion;
use super::window::{Behind, Window};
use crate::math::real::Real;
use crate::sample::Increment;

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
    const STORED: usize = W::STORED;
    const UNEQUAL: bool = true;
    type Samples<T: Copy + Send> = W::Samples<T>;
    type Series<R: Real> = W::Series<R>;
    type Intervals<R: Real> = W::KeptIntervals<R>;
    type KeptIntervals<R: Real> = W::KeptIntervals<R>;

    #[inline]
    fn samples<T: Copy + Send>(fill: T) -> Self::Samples<T> {
        W::samples(fill)
    }

    // One copy of the code for all frames and readers, here and below.
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
