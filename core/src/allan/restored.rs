//! Sums in the record list, and checked after they were restored.

use super::octaves::{Octaves, Ring, Sums};
use crate::math::compensated::Pair;
use crate::math::real::Real;
use crate::record::{Record, record};
use crate::strapdown::plausible::Damaged;

/// Larger than any sum of increments, and far from what a type can hold.
const MOST: f64 = 1e35;

impl<R: Sums, const OCTAVES: usize> Octaves<R, OCTAVES> {
    /// Checks whether what was restored can be sums of samples. Call it before anything else.
    ///
    /// # Errors
    ///
    /// [`Damaged`] if it cannot.
    pub fn check(&self) -> Result<(), Damaged> {
        let most = R::of(MOST);
        let finite = |x: R| Real::is_within(x, most);
        let pair = |sum: Pair<R>| finite(sum.hi) && finite(sum.lo);
        let sound = finite(self.first)
            && self.squares.into_iter().all(pair)
            && self.rings.iter().all(|ring| {
                pair(ring.squares)
                    && ring.quarters.iter().all(|&sum| <R as Sums>::is_within(sum, most))
            });
        if sound { Ok(()) } else { Err(Damaged) }
    }
}

impl<R: Sums + Record> Record for Ring<R> {
    record!(quarters, squares);
}

/// Without the interval, which is configuration.
impl<R: Sums + Record, const OCTAVES: usize> Record for Octaves<R, OCTAVES> {
    record!(samples, first, squares, rings);
}
