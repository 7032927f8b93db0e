//! Checks whether a state that was restored from bytes can be a state of a navigator.
//!
//! A state's fields depend on each other: a latitude and its sine, a place and its gravity, a number of
//! samples and the room for them. After a state is written back, from storage or from a link, check it with
//! [`Mechanization::check`](crate::strapdown::mechanization::Mechanization::check) before navigation
//! continues. A single wrong bit could otherwise cause an endless loop or a NaN.
//!
//! ```
//! use schuler::earth::Geodetic;
//! use schuler::math::{compensated::Pair, vector::Vector};
//! use schuler::sample::Increment;
//! use schuler::solution::{Euler, Solution};
//! use schuler::record::Record;
//! use schuler::strapdown::block::window::H0B4A0;
//! use schuler::strapdown::frame::local_level::LocalLevel;
//! use schuler::strapdown::navigator::Strapdown;
//!
//! let at = Geodetic { latitude: 0.8_f64, longitude: 0.1, altitude: 100.0 };
//! let initial = Solution::new(at, Vector::ZERO, Euler::default());
//! let navigator = Strapdown::<LocalLevel<Pair<f64>>, H0B4A0>::new(Pair::of(0.01))?;
//! let mut state = navigator.start(&initial)?;
//! assert!(navigator.check(&state).is_ok());
//! // A latitude that no longer belongs to its sine.
//! state.restore("", &mut |name, bits| if name == "sine" { 0 } else { bits });
//! assert!(navigator.check(&state).is_err());
//! # Ok::<(), schuler::strapdown::limits::StartError>(())
//! ```

use crate::math::compensated::Accumulate;
use crate::math::quaternion::Quaternion;
use crate::math::real::Real;
use crate::math::vector::Vector;

/// A restored state that no navigator can have: start again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Damaged;

impl core::fmt::Display for Damaged {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("the restored state is none that navigation leaves: it was damaged on the way")
    }
}

impl core::error::Error for Damaged {}

/// A state that can check whether its fields are finite, in range and consistent.
pub trait Plausible {
    /// Whether they are.
    fn is_plausible(&self) -> bool;
}

/// The largest plausible number of samples: 570 years at a megahertz.
pub(crate) const MOST_COUNTED: u64 = 1 << 54;

/// The largest plausible velocity, m/s; navigation starts with at most a tenth of it.
pub(crate) const MOST_SPEED: f64 = 1e6;
/// The largest plausible change of gravity over a block, and of its differences, m/s².
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

/// Whether two numbers that depend on each other agree within a bound.
pub(crate) fn agree<R: Real>(a: R, b: R, bound: R) -> bool {
    (a - b).is_within(bound)
}
