//! How long, how far, how fast, how tight a manoeuvre is.
//!
//! ```
//! use schuler::trajectory::segment::compile::extent::Tightness;
//!
//! // 100 m/s on a circle of 2 km.
//! assert_eq!(Tightness::Radius(2000.0).course_rate(100.0, 9.81), 0.05);
//! ```

use crate::math::real::Real;
use crate::trajectory::segment::step::STEEPEST;

/// How long a straight line is.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Length {
    /// A duration, s.
    Time(f64),
    /// A distance along the path, m.
    Distance(f64),
}

/// How fast a speed changes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Pace {
    /// Within a duration, s: the mean acceleration is the change over it, the largest 2.93 times that.
    Blend(f64),
    /// With an acceleration of at most, m/s².
    Acceleration(f64),
}

/// How far a turn goes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Amount {
    /// By an angle against the straight line, rad, to the right. Whole turns are possible. The course
    /// differs from it by what the meridians converge along the turn.
    By(f64),
    /// To a course from north to east, rad, exactly.
    To {
        /// The course, rad.
        course: f64,
        /// Which way round.
        way: Way,
    },
}

/// Which way a turn to a course goes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Way {
    /// The shorter way, to the right if both are equal.
    #[default]
    Shorter,
    /// To the left.
    Left,
    /// To the right.
    Right,
}

/// How tight a turn is at most.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Tightness {
    /// By a bank, rad: a lateral acceleration of γ tan(bank), whether the body banks or not.
    Bank(f64),
    /// By a radius, m.
    Radius(f64),
}

impl Pace {
    /// How long a change of speed, m/s, takes.
    pub(super) fn blend_s(self, change: f64) -> f64 {
        match self {
            Self::Blend(blend_s) => blend_s,
            Self::Acceleration(most) => STEEPEST * Real::abs(change) / most,
        }
    }
}
