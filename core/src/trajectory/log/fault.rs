//! What is wrong with a log, by row from 0.

use crate::trajectory::spline::SplineError;
use crate::trajectory::spline::place::LARGEST_SPEED;

/// A part of a log that has its own noise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Part {
    /// Horizontal position.
    Horizontal,
    /// Height.
    Vertical,
    /// Attitude.
    Attitude,
}

/// Why a log is not a path.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum LogError {
    /// Fewer than two rows.
    TooFew,
    /// Columns differ in length.
    Count {
        /// The number of rows.
        needed: usize,
    },
    /// A slice is shorter than needed.
    NoRoom {
        /// The length that is enough.
        needed: usize,
    },
    /// A number is not finite.
    NotFinite {
        /// Its row.
        index: usize,
    },
    /// A row is not later than the one before.
    NotIncreasing {
        /// The row.
        index: usize,
    },
    /// More time passes between two rows than the log may have.
    Gap {
        /// The row after the gap.
        index: usize,
        /// The time of the row before it, s.
        from_s: f64,
        /// The time of this row, s.
        to_s: f64,
        /// The longest gap that is accepted, s.
        max_gap_s: f64,
    },
    /// The position jumps.
    TooFast {
        /// The row after the jump.
        index: usize,
        /// The speed that it takes, m/s.
        speed_m_s: f64,
    },
    /// A noise is negative or not a number.
    Noise {
        /// Of what.
        part: Part,
    },
    /// Without noise the sites must be the rows' times.
    Sites {
        /// What has no noise.
        part: Part,
    },
    /// A row lies outside the sites.
    Outside {
        /// The row.
        index: usize,
    },
    /// The path does not come as near to the rows as the noise says.
    TooStiff {
        /// In what.
        part: Part,
    },
    /// Smoothing needs at least three rows.
    Undetermined {
        /// What was to be smoothed.
        part: Part,
    },
}

impl core::fmt::Display for Part {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(match self {
            Self::Horizontal => "the horizontal position",
            Self::Vertical => "the height",
            Self::Attitude => "the attitude",
        })
    }
}

impl core::fmt::Display for LogError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match *self {
            Self::TooFew => write!(f, "a log needs at least 2 rows"),
            Self::Count { needed } => write!(f, "every column must have {needed} rows"),
            Self::NoRoom { needed } => write!(f, "there is no room for {needed} entries"),
            Self::NotFinite { index } => write!(f, "row {index}: a number is not finite"),
            Self::NotIncreasing { index } => {
                write!(f, "row {index}: its time is not later than that of the one before")
            }
            Self::Gap { index, from_s, to_s, max_gap_s } => write!(
                f,
                "row {index}: a gap from {from_s} s to {to_s} s; up to {max_gap_s} s is accepted"
            ),
            Self::TooFast { index, speed_m_s } => write!(
                f,
                "row {index}: a jump that takes {speed_m_s:.0} m/s; up to {LARGEST_SPEED:.0} m/s is accepted"
            ),
            Self::Noise { part } => write!(f, "the noise of {part} must be 0 or more"),
            Self::Sites { part } => {
                write!(f, "{part} has no noise, so that every row must be a joint of the path")
            }
            Self::Outside { index } => write!(f, "row {index}: it lies outside the joints"),
            Self::TooStiff { part } => write!(
                f,
                "the noise of {part} is larger than stated, or the joints lie too far apart to follow it"
            ),
            Self::Undetermined { part } => write!(f, "{part} needs at least 3 rows for smoothing"),
        }
    }
}

impl core::error::Error for LogError {}

impl LogError {
    /// From what a spline of a part says.
    pub(super) fn of(error: SplineError, part: Part) -> Self {
        match error {
            SplineError::TooFew => Self::TooFew,
            SplineError::NoRoom { needed } => Self::NoRoom { needed },
            SplineError::Count { needed } => Self::Count { needed },
            SplineError::NotIncreasing { index } => Self::NotIncreasing { index },
            SplineError::NotFinite { index } => Self::NotFinite { index },
            SplineError::Outside { index } => Self::Outside { index },
            SplineError::Undetermined => Self::Undetermined { part },
            SplineError::TooStiff => Self::TooStiff { part },
        }
    }
}
