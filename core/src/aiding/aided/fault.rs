//! Why a sample, a measurement or a configuration is refused.
//!
//! ```
//! use schuler::aiding::aided::fault::AidedFault;
//!
//! assert!(AidedFault::Sigma.to_string().contains("above 0"));
//! ```

use crate::strapdown::limits::Rejected;

/// Why a sample, a measurement or a configuration is refused. The state has not changed but for the counts of
/// what came late, again or too much.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum AidedFault {
    /// A standard deviation of the settings that is not above 0, or more states than the filter has.
    Settings,
    /// A lever arm that is not finite, or longer than 100 m.
    Lever,
    /// A horizon longer than half of what is remembered: `L` steps.
    Horizon,
    /// An attitude or a place from which navigation cannot start.
    Start,
    /// A sample that the mechanization refuses.
    Rejected(Rejected),
    /// A time that is none: its part of a sample is below 0, at least 1, or not a number.
    Time,
    /// A measurement older than the horizon allows, or than what is remembered.
    Late,
    /// A measurement more than 4096 samples ahead of the newest one.
    Future,
    /// A standard deviation that is not above 0, or not within 10⁶.
    Sigma,
    /// A position that is not on the Earth, or more than 1000 km from the ellipsoid.
    Place,
    /// A velocity that is not finite, or above 100 km/s.
    Velocity,
    /// The same kind of measurement of the same time was taken before.
    Again,
    /// As many measurements wait as there is room for.
    Full,
}

impl core::fmt::Display for AidedFault {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(match self {
            Self::Settings => {
                "every standard deviation must be above 0, and the states must fit the filter"
            }
            Self::Lever => "a lever arm must be finite and at most 100 m long",
            Self::Horizon => "the horizon must be at most half as long as the steps that are remembered",
            Self::Start => "navigation cannot start from this attitude and place",
            Self::Rejected(rejected) => return rejected.fmt(f),
            Self::Time => "the part of a sample must be at least 0 and below 1",
            Self::Late => "the measurement is older than the horizon, or than what is remembered",
            Self::Future => "the measurement is more than 4096 samples ahead of the newest one",
            Self::Sigma => "a standard deviation must be above 0, and at most 1e6",
            Self::Place => {
                "a position must be finite: latitude within 90°, longitude within 360°, height within \
                 1000 km"
            }
            Self::Velocity => "a velocity must be finite and at most 100 km/s",
            Self::Again => "the measurement was taken before",
            Self::Full => "no room for another measurement that waits",
        })
    }
}

impl core::error::Error for AidedFault {}
