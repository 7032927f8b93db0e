//! What is wrong with a manoeuvre.
//!
//! ```
//! use schuler::trajectory::segment::fault::Fault;
//!
//! let refused = Fault::TooSteep { largest: 49.2 };
//! assert_eq!(refused.to_string(), "climbs too steeply for its speed: at most 49.2 m/s");
//! ```

use core::fmt::{self, Display, Formatter};

/// The largest speed, m/s.
pub const LARGEST_SPEED: f64 = 1e5;
/// The least time of a segment or a blend, s.
pub const LEAST_TIME_S: f64 = 1e-3;
/// The largest climb angle, rad: 80°.
pub const LARGEST_CLIMB: f64 = 80.0 * core::f64::consts::PI / 180.0;
/// The largest bank, rad: 85°.
pub const LARGEST_BANK: f64 = 85.0 * core::f64::consts::PI / 180.0;
/// The least cosine of the latitude on a rhumb line: 6 km from the pole.
pub const LEAST_RHUMB_COSINE: f64 = 1e-3;
/// Heights between which paths lie, m.
pub const HEIGHTS: [f64; 2] = [-1e5, 1e7];

/// Why a manoeuvre cannot be flown.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Fault {
    /// A number is infinite or not a number.
    NotFinite,
    /// A latitude beyond ±π/2, or a longitude or a course beyond ±2π.
    Angle,
    /// A height outside [`HEIGHTS`].
    Height,
    /// A time is below [`LEAST_TIME_S`].
    TooShort,
    /// A distance, a radius, a rate, an acceleration or a bank must be positive; what changes has the sign.
    NotPositive,
    /// Faster than [`LARGEST_SPEED`].
    TooFast,
    /// A turn, a climb or a distance at speed 0.
    AtRest,
    /// A climb at more than 80°.
    TooSteep {
        /// The largest climb rate at this speed, m/s.
        largest: f64,
    },
    /// A bank of more than 85°.
    TooTight {
        /// The least radius at this speed, m.
        least_radius: f64,
    },
    /// A coordinated flight pushes over so fast that nothing tells up from down.
    PushesOver {
        /// The blend that would do, s.
        least_blend_s: f64,
    },
    /// The same in flight: specific force has no upward part there.
    Weightless,
    /// A rhumb line, or a turn to a course, at a pole.
    Pole,
    /// Controls do not go on where those before them end.
    Jump,
}

impl Display for Fault {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite => f.write_str("has a number that is not finite"),
            Self::Angle => {
                f.write_str("has a latitude beyond ±π/2, or a longitude or a course beyond ±2π rad")
            }
            Self::Height => {
                let [least, most] = HEIGHTS;
                write!(f, "has a height outside {least} to {most} m")
            }
            Self::TooShort => write!(f, "has a time below {LEAST_TIME_S} s"),
            Self::NotPositive => f.write_str(
                "has a distance, a radius, a rate, an acceleration or a bank that is not positive",
            ),
            Self::TooFast => write!(f, "is faster than {LARGEST_SPEED} m/s"),
            Self::AtRest => f.write_str("moves at speed 0: accelerate first, or rotate"),
            Self::TooSteep { largest } => {
                write!(f, "climbs too steeply for its speed: at most {largest} m/s")
            }
            Self::TooTight { least_radius } => write!(
                f,
                "turns too tightly for its speed: a bank of at most 85°, a radius of at least \
                 {least_radius} m"
            ),
            Self::PushesOver { least_blend_s } => write!(
                f,
                "pushes over into weightlessness: a blend of at least {least_blend_s} s would do"
            ),
            Self::Weightless => f.write_str(
                "has no specific force upwards: a coordinated attitude is not defined there",
            ),
            Self::Pole => {
                f.write_str("keeps or takes a course at a pole, where a course is not defined")
            }
            Self::Jump => f.write_str("does not go on where the controls before it end"),
        }
    }
}

impl core::error::Error for Fault {}
