//! Refusals of a target, with their reasons.
//!
//! ```
//! use schuler::link::refusal::Refusal;
//!
//! for &refusal in Refusal::ALL {
//!     assert_eq!(Refusal::from_code(refusal.code()), Some(refusal));
//! }
//! ```

use super::gap::{MOST_BRIDGED, Missing};
#[cfg(feature = "aiding")]
use crate::aiding::aided::fault::AidedFault;
use crate::strapdown::limits::{Rejected, StartError};
use crate::strapdown::plausible::Damaged;
use core::fmt::{self, Display, Formatter};

/// The reason. Except for [`Refusal::Damaged`], only counters have changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Refusal {
    /// There is no navigation: it has just been switched on.
    NotStarted,
    /// It has no such mechanization.
    Configuration,
    /// The payload is not what its kind needs.
    Malformed,
    /// Samples before this one are missing, and are not bridged or are more than [`MOST_BRIDGED`].
    Gap,
    /// The stream has been finished.
    Finished,
    /// The stream that is to be finished has had more samples than it is said to have.
    Count,
    /// The restored state cannot be a state of the navigator. It has replaced the previous flight: the target
    /// waits for the state again, from its beginning, or for a start.
    Damaged,
    /// Navigation cannot start.
    Start(StartError),
    /// The navigator does not take the sample.
    Rejected(Rejected),
    /// No measurements are taken here: what flies is not aided, or waits for the settings of its filter.
    Unaided,
    /// The aided navigator does not take its settings, or a measurement.
    #[cfg(feature = "aiding")]
    Aided(AidedFault),
}

/// Codes both ways; a reason without one does not compile.
macro_rules! codes {
    ($($(#[$of:meta])* $refusal:ident $(($cause:ident $reason:ident))? = $code:literal,)+) => {
        impl Refusal {
            /// Every one.
            pub const ALL: &[Self] = &[$($(#[$of])* Self::$refusal $(($cause::$reason))?,)+];

            /// As it crosses the line.
            pub fn code(self) -> u8 {
                match self {
                    $($(#[$of])* Self::$refusal $(($cause::$reason))? => $code,)+
                    // The same refusal by a navigator that is not aided.
                    #[cfg(feature = "aiding")]
                    Self::Aided(AidedFault::Rejected(why)) => Self::Rejected(why).code(),
                }
            }

            /// Back from [`Refusal::code`].
            pub fn from_code(code: u8) -> Option<Self> {
                match code {
                    $($(#[$of])* $code => Some(Self::$refusal $(($cause::$reason))?),)+
                    _ => None,
                }
            }
        }
    };
}

codes! {
    NotStarted = 0,
    Configuration = 1,
    Malformed = 2,
    Gap = 3,
    Finished = 4,
    Start(StartError Interval) = 5,
    Start(StartError Limits) = 6,
    Start(StartError Position) = 7,
    Start(StartError Velocity) = 8,
    Start(StartError Attitude) = 9,
    Start(StartError Pole) = 10,
    Rejected(Rejected Angle) = 11,
    Rejected(Rejected Velocity) = 12,
    Rejected(Rejected Pole) = 13,
    Rejected(Rejected Place) = 14,
    Rejected(Rejected Held) = 15,
    Start(StartError FlushToZero) = 16,
    Count = 17,
    Rejected(Rejected Interval) = 18,
    Damaged = 19,
    Rejected(Rejected Turn) = 20,
    Unaided = 21,
    #[cfg(feature = "aiding")]
    Aided(AidedFault Settings) = 22,
    #[cfg(feature = "aiding")]
    Aided(AidedFault Lever) = 23,
    #[cfg(feature = "aiding")]
    Aided(AidedFault Horizon) = 24,
    #[cfg(feature = "aiding")]
    Aided(AidedFault Start) = 25,
    #[cfg(feature = "aiding")]
    Aided(AidedFault Time) = 26,
    #[cfg(feature = "aiding")]
    Aided(AidedFault Future) = 27,
    #[cfg(feature = "aiding")]
    Aided(AidedFault Sigma) = 28,
    #[cfg(feature = "aiding")]
    Aided(AidedFault Place) = 29,
    #[cfg(feature = "aiding")]
    Aided(AidedFault Velocity) = 30,
    #[cfg(feature = "aiding")]
    Aided(AidedFault Late) = 31,
    #[cfg(feature = "aiding")]
    Aided(AidedFault Again) = 32,
    #[cfg(feature = "aiding")]
    Aided(AidedFault Full) = 33,
}

impl Display for Refusal {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotStarted => f.write_str("navigation has not been started"),
            Self::Configuration => f.write_str("there is no such mechanization on the target"),
            Self::Malformed => f.write_str("the message is not understood"),
            Self::Gap => write!(
                f,
                "samples are missing before this one: gaps are not bridged, or it is one of over \
                 {MOST_BRIDGED} samples"
            ),
            Self::Finished => f.write_str("the stream has been finished"),
            Self::Count => f.write_str("the stream has had more samples than it is to end after"),
            Self::Damaged => Damaged.fmt(f),
            Self::Start(error) => error.fmt(f),
            Self::Rejected(error) => error.fmt(f),
            Self::Unaided => f.write_str(
                "no measurements are taken: what flies is not aided, or waits for its settings",
            ),
            #[cfg(feature = "aiding")]
            Self::Aided(fault) => fault.fmt(f),
        }
    }
}

impl core::error::Error for Refusal {}

impl From<Missing> for Refusal {
    fn from(_: Missing) -> Self {
        Self::Gap
    }
}

impl From<Damaged> for Refusal {
    fn from(_: Damaged) -> Self {
        Self::Damaged
    }
}

impl From<StartError> for Refusal {
    fn from(error: StartError) -> Self {
        Self::Start(error)
    }
}

#[cfg(feature = "aiding")]
impl From<AidedFault> for Refusal {
    fn from(fault: AidedFault) -> Self {
        match fault {
            AidedFault::Rejected(why) => Self::Rejected(why),
            other => Self::Aided(other),
        }
    }
}

impl From<Rejected> for Refusal {
    fn from(error: Rejected) -> Self {
        Self::Rejected(error)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_reason_comes_back_from_the_line() {
        for &refusal in Refusal::ALL {
            assert_eq!(Refusal::from_code(refusal.code()), Some(refusal));
        }
        let known = (0..=u8::MAX).filter(|&code| Refusal::from_code(code).is_some()).count();
        assert_eq!(known, Refusal::ALL.len());
    }
}
