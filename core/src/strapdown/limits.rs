//! The limits of navigation, and the errors beyond them.
//!
//! ```
//! use schuler::earth::Geodetic;
//! use schuler::math::{compensated::Pair, vector::Vector};
//! use schuler::sample::Increment;
//! use schuler::solution::{Euler, Solution};
//! use schuler::strapdown::block::window::H0B4A0;
//! use schuler::strapdown::frame::local_level::LocalLevel;
//! use schuler::strapdown::limits::{Limits, Rejected};
//! use schuler::strapdown::navigator::Strapdown;
//!
//! let at = Geodetic { latitude: 0.8_f64, longitude: 0.1, altitude: 100.0 };
//! let initial = Solution::new(at, Vector::ZERO, Euler::default());
//! let limits = Limits { angular_rate: 10.0, specific_force: 200.0 };
//! let navigator = Strapdown::<LocalLevel<Pair<f64>>, H0B4A0>::with_limits(Pair::of(0.01), limits)?;
//! let mut state = navigator.start(&initial)?;
//! let broken = Increment { angle_b: Vector::new(f64::NAN, 0.0, 0.0), velocity_b: Vector::ZERO };
//! assert_eq!(navigator.push(&mut state, broken), Err(Rejected::Angle));
//! # Ok::<(), schuler::strapdown::limits::StartError>(())
//! ```

use crate::math::real::Real;

/// The largest height above and below the ellipsoid, m, for navigation.
pub(crate) const FARTHEST: f64 = 1e6;

/// Velocity, m/s, that navigation starts with at most.
pub(crate) const FASTEST: f64 = 1e5;

/// The largest angle that a block may turn by about one axis, rad. The series of a step are truncated and
/// do not serve larger angles.
pub const MOST_TURN: f64 = 2.0;

/// The largest readings that can be right.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Limits<R> {
    /// Angular rate, rad/s.
    pub angular_rate: R,
    /// Specific force, m/s².
    pub specific_force: R,
}

impl<R: Real> Default for Limits<R> {
    /// 10⁵ °/s and 10⁵ m/s².
    fn default() -> Self {
        Self {
            angular_rate: R::of(1e5 * core::f64::consts::PI / 180.0),
            specific_force: R::of(1e5),
        }
    }
}

/// Why a sample or a held vertical was refused. The state is unchanged, bit for bit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Rejected {
    /// An angle increment that is not finite, or above the limit.
    Angle,
    /// A velocity increment that is not finite, or above the limit.
    Velocity,
    /// The local-level frame has come within a ten-thousandth of the Earth's radius of a pole, where
    /// its axes are undefined. The Earth-fixed frame has no such limit.
    Pole,
    /// The position is more than 1000 km above or below the ellipsoid.
    Place,
    /// A height or a vertical velocity to hold that is not finite, above 1000 km or above 10⁵ m/s.
    Held,
    /// An interval that is not finite, not above 0 s or above 1 s.
    Interval,
    /// An angle increment within the limit, but so large that a block of such samples would turn by more
    /// than [`MOST_TURN`]. Use a window with a shorter block, or a higher rate.
    Turn,
}

impl core::fmt::Display for Rejected {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(match self {
            Self::Angle => "the angle increment is not finite or exceeds the limit",
            Self::Velocity => "the velocity increment is not finite or exceeds the limit",
            Self::Pole => "the local-level frame ends at the pole; earth-fixed goes on",
            Self::Place => {
                "navigation has left the ellipsoid by over 1000 km: \
                 check signs and units of the samples, or hold the vertical"
            }
            Self::Held => "the vertical to hold must be finite, within 1000 km and 100 km/s",
            Self::Interval => "the sample's interval must be above 0 s and at most 1 s",
            Self::Turn => {
                "the angle increment turns a block by over 2 rad: \
                 a window with a shorter block or a higher rate would do"
            }
        })
    }
}

impl core::error::Error for Rejected {}

/// Why navigation cannot start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum StartError {
    /// The sampling interval is not above 0 s and at most 1 s.
    Interval,
    /// A limit is not a positive finite number.
    Limits,
    /// The position is not finite, beyond ±90° of latitude or ±360° of longitude, or farther than
    /// 1000 km from the ellipsoid.
    Position,
    /// The velocity is not finite or above 10⁵ m/s.
    Velocity,
    /// The attitude is not a unit quaternion to a thousandth.
    Attitude,
    /// The local-level frame cannot start at a pole.
    Pole,
    /// The processor flushes subnormal numbers to zero, so its results would differ from those of others.
    FlushToZero,
}

impl core::fmt::Display for StartError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(match self {
            Self::Interval => "the sampling interval must be above 0 s and at most 1 s",
            Self::Limits => "the limits must be positive and finite",
            Self::Position => {
                "the initial position must be finite: latitude within 90°, longitude within 360°, \
                 height within 1000 km"
            }
            Self::Velocity => "the initial velocity must be finite and at most 100 km/s",
            Self::Attitude => "the initial attitude must be a unit quaternion to a thousandth",
            Self::Pole => "the local-level frame cannot start at a pole; earth-fixed can",
            Self::FlushToZero => "the processor flushes subnormal numbers to zero; clear that mode",
        })
    }
}

impl core::error::Error for StartError {}

impl From<Rejected> for StartError {
    /// Why a frame cannot go on from a place.
    fn from(rejected: Rejected) -> Self {
        if rejected == Rejected::Pole { Self::Pole } else { Self::Position }
    }
}
