//! Whether a state that came back from bytes is one that navigation could have left there.
//!
//! A state's fields hang together: a latitude with its sine, a place with its gravity, a number of samples
//! with the room for them. Whoever writes a state back, from storage or from a link, asks for all of it
//! with [`Mechanization::check`](crate::strapdown::mechanization::Mechanization::check) before going on: a single wrong
//! bit can otherwise hold a loop for ever, or bring in what is no number.

use crate::math::compensated::Accumulate;
use crate::math::quaternion::Quaternion;
use crate::math::real::Real;
use crate::math::vector::Vector;

/// A restored state is none that navigation leaves: start again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Damaged;

impl core::fmt::Display for Damaged {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("the restored state is none that navigation leaves: it was damaged on the way")
    }
}

impl core::error::Error for Damaged {}

/// What can tell whether its fields are finite, in range and agree with one another.
pub trait Plausible {
    /// Whether they do.
    fn is_plausible(&self) -> bool;
}

/// Samples or words that nobody counts beyond: 500 years at a gigahertz.
pub(crate) const MOST_COUNTED: u64 = 1 << 54;

/// Velocity, m/s, that is not met: navigation starts with at most a tenth of it.
pub(crate) const MOST_SPEED: f64 = 1e6;
/// Change of gravity over a block and its differences, m/s², that are not met.
pub(crate) const MOST_GRAVITY_CHANGE: f64 = 100.0;

/// Both parts of a sum finite and within ±bound.
pub(crate) fn sum_within<S: Accumulate>(x: S, bound: S::Real) -> bool {
    let pair = x.pair();
    pair.hi.is_within(bound) & pair.lo.is_within(bound)
}

/// The same for every component.
pub(crate) fn sums_within<S: Accumulate>(v: Vector<S>, bound: S::Real) -> bool {
    sum_within(v.x, bound) & sum_within(v.y, bound) & sum_within(v.z, bound)
}

/// Whether an attitude has unit length to a thousandth.
pub(crate) fn is_attitude<R: Real>(q: Quaternion<R>) -> bool {
    (q.dot(q) - R::ONE).is_within(R::of(2e-3))
}

/// Whether two numbers that follow from one another are within a bound.
pub(crate) fn agree<R: Real>(a: R, b: R, bound: R) -> bool {
    (a - b).is_within(bound)
}
