//! Why a target does not do what it is asked to.

use super::gap::Missing;
use crate::strapdown::mechanization::{Rejected, StartError};
use core::fmt::{self, Display, Formatter};

/// The reason. Nothing has changed but counters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Refusal {
    /// It navigates nothing: it has just been switched on.
    NotStarted,
    /// It has no such mechanization.
    Configuration,
    /// The payload is not what its kind needs.
    Malformed,
    /// Samples before this one never came, and are not bridged, or are too many.
    Gap,
    /// The stream has been finished.
    Finished,
    /// Navigation cannot start.
    Start(StartError),
    /// The navigator does not take the sample.
    Rejected(Rejected),
}

impl Refusal {
    /// Every one, in the order of their codes on the line.
    pub const ALL: [Self; 16] = [
        Self::NotStarted,
        Self::Configuration,
        Self::Malformed,
        Self::Gap,
        Self::Finished,
        Self::Start(StartError::Interval),
        Self::Start(StartError::Limits),
        Self::Start(StartError::Position),
        Self::Start(StartError::Velocity),
        Self::Start(StartError::Attitude),
        Self::Start(StartError::Pole),
        Self::Rejected(Rejected::Angle),
        Self::Rejected(Rejected::Velocity),
        Self::Rejected(Rejected::Pole),
        Self::Rejected(Rejected::Place),
        Self::Rejected(Rejected::Held),
    ];

    /// As it crosses the line.
    pub fn code(self) -> u8 {
        Self::ALL.iter().position(|&refusal| refusal == self).unwrap_or(Self::ALL.len()) as u8
    }

    /// Back from [`Refusal::code`].
    pub fn of(code: u8) -> Option<Self> {
        Self::ALL.get(usize::from(code)).copied()
    }
}

impl Display for Refusal {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotStarted => f.write_str("navigation has not been started"),
            Self::Configuration => f.write_str("there is no such mechanization on the target"),
            Self::Malformed => f.write_str("the message is not understood"),
            Self::Gap => f.write_str("samples are missing before this one, and are not bridged"),
            Self::Finished => f.write_str("the stream has been finished"),
            Self::Start(error) => error.fmt(f),
            Self::Rejected(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for Refusal {}

impl From<Missing> for Refusal {
    fn from(_: Missing) -> Self {
        Self::Gap
    }
}

impl From<StartError> for Refusal {
    fn from(error: StartError) -> Self {
        Self::Start(error)
    }
}

impl From<Rejected> for Refusal {
    fn from(error: Rejected) -> Self {
        Self::Rejected(error)
    }
}
