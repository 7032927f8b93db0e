//! What is wrong with way-points, by index from 0.
//!
//! ```
//! use schuler::trajectory::waypoints::fault::WaypointError;
//!
//! let error = WaypointError::NotIncreasing { index: 3 };
//! assert_eq!(error.to_string(), "way-point 3: its time is not later than that of the one before");
//! ```

use crate::math::real::Real;
use crate::trajectory::segment::fault::Fault;
use crate::trajectory::spline::SplineError;
use crate::trajectory::spline::place::{LARGEST_ACCELERATION, LARGEST_SPEED};

/// Why way-points are not a path.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum WaypointError {
    /// Fewer than two points.
    TooFew,
    /// There are not as many times or speeds as points.
    Count {
        /// The number of points.
        needed: usize,
    },
    /// A slice is shorter than needed.
    NoRoom {
        /// The length that is enough.
        needed: usize,
    },
    /// A number of a point is not finite.
    NotFinite {
        /// The point.
        index: usize,
    },
    /// A point is not later than the one before.
    NotIncreasing {
        /// The later point in order.
        index: usize,
    },
    /// A point is where the one before is.
    Coincident {
        /// The later point.
        index: usize,
    },
    /// A point is on the other side of the Earth from the one before, so that every direction leads there.
    Antipodal {
        /// The later point.
        index: usize,
    },
    /// The mean of the speeds at both ends of a leg is not above 0, or a speed is negative.
    Speed {
        /// The point at the end of the leg.
        index: usize,
    },
    /// A leg is flown faster than [`LARGEST_SPEED`].
    TooFast {
        /// The point at the end of the leg.
        index: usize,
        /// The speed, m/s.
        speed_m_s: f64,
    },
    /// The bank must be above 0 and at most 85°, the blend at least a millisecond.
    Turn,
    /// A turn takes more of its legs than there is.
    TooTight {
        /// The point at which it turns.
        index: usize,
        /// The bank that would do, rad.
        bank: f64,
        /// The radius that would do, m.
        radius_m: f64,
    },
    /// A turn fits on its legs with no bank: they are too short for its speed and its blend.
    NoTurn {
        /// The point at which it turns.
        index: usize,
    },
    /// A leg has no room for its turns, its change of speed and its climb.
    Short {
        /// The point at the end of the leg.
        index: usize,
    },
    /// A rhumb line begins or ends at a pole.
    Pole {
        /// The point.
        index: usize,
    },
    /// A manoeuvre of a leg cannot be flown.
    Leg {
        /// The point at the end of the leg.
        index: usize,
        /// What is wrong with it.
        fault: Fault,
    },
    /// At a point or near it the path accelerates by more than [`LARGEST_ACCELERATION`].
    TooSharp {
        /// The point.
        index: usize,
        /// The acceleration, m/s².
        acceleration_m_s2: f64,
    },
}

impl core::fmt::Display for WaypointError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match *self {
            Self::TooFew => write!(f, "a path needs at least 2 way-points"),
            Self::Count { needed } => {
                write!(f, "there must be a number for each of {needed} way-points")
            }
            Self::NoRoom { needed } => write!(f, "there is no room for {needed} entries"),
            Self::NotFinite { index } => write!(f, "way-point {index}: not finite"),
            Self::NotIncreasing { index } => {
                write!(f, "way-point {index}: its time is not later than that of the one before")
            }
            Self::Coincident { index } => {
                write!(f, "way-point {index}: it is the same place as the one before")
            }
            Self::Antipodal { index } => write!(
                f,
                "way-point {index}: it is opposite to the one before, so that every direction leads there; a point \
                 between them says which"
            ),
            Self::Speed { index } => write!(
                f,
                "way-point {index}: speeds must be at least 0, and not both 0 at the ends of a leg"
            ),
            Self::TooFast { index, speed_m_s } => write!(
                f,
                "way-point {index}: {speed_m_s:.0} m/s since the one before; up to {LARGEST_SPEED:.0} m/s is accepted"
            ),
            Self::Turn => write!(
                f,
                "the bank must be above 0 and at most 85°, the blend at least a millisecond"
            ),
            Self::TooTight { index, bank, radius_m } => write!(
                f,
                "way-point {index}: the turn does not fit on its legs; a bank of {:.1}°, a radius of {:.0} m, \
                 would do",
                0.1 * Real::round(10.0 * bank.to_degrees() + 0.5),
                Real::round(radius_m - 0.5)
            ),
            Self::NoTurn { index } => write!(
                f,
                "way-point {index}: the turn does not fit on its legs, however steep; a lower speed or a shorter \
                 blend may do"
            ),
            Self::Short { index } => write!(
                f,
                "way-point {index}: the leg to it is too short for its turns, its change of speed and its climb"
            ),
            Self::Pole { index } => {
                write!(
                    f,
                    "way-point {index}: a rhumb line has no course at a pole; a geodesic would do"
                )
            }
            Self::Leg { index, fault } => write!(f, "way-point {index}: the leg to it {fault}"),
            Self::TooSharp { index, acceleration_m_s2 } => write!(
                f,
                "way-point {index}: {acceleration_m_s2:.0} m/s² there; up to {LARGEST_ACCELERATION:.0} m/s² is accepted"
            ),
        }
    }
}

impl core::error::Error for WaypointError {}

impl From<SplineError> for WaypointError {
    fn from(error: SplineError) -> Self {
        match error {
            SplineError::TooFew => Self::TooFew,
            SplineError::NoRoom { needed } => Self::NoRoom { needed },
            SplineError::Count { needed } => Self::Count { needed },
            SplineError::NotIncreasing { index } => Self::NotIncreasing { index },
            SplineError::NotFinite { index } | SplineError::Outside { index } => {
                Self::NotFinite { index }
            }
            // Increasing finite sites always determine a spline; infinity in between is a number that is not finite.
            SplineError::Undetermined | SplineError::TooStiff => Self::NotFinite { index: 0 },
        }
    }
}
