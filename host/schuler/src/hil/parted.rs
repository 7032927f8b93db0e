//! Why a flight in step with a target ends early.

use super::channel::Broken;
use super::difference::Difference;
use schuler::link::refusal::Refusal;
use schuler_simulator::input::Complaint;
use std::fmt;

/// How often a target may be rebooted in the middle of one request before it is given up.
pub const MOST_REBOOTS: u32 = 16;

/// Why a lockstep flight ends early.
#[derive(Clone, Debug, PartialEq)]
pub enum Parted {
    /// Target and twin differ.
    Difference(Difference),
    /// The target does not answer any more.
    Silence(&'static str),
    /// It loses its memory over and over.
    Reboots,
    /// So many samples are lost in a row that nobody knows which it has.
    Lost(usize),
    /// It refuses what its twin does not, or the other way round.
    Refusal {
        /// The target's reason, if it refuses.
        target: Option<Refusal>,
        /// Its twin's.
        twin: Option<Refusal>,
    },
    /// It answers what was not asked.
    Answer(&'static str),
    /// The connection has ended.
    Broken(Broken),
}

impl fmt::Display for Parted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let reason = |refusal: &Option<Refusal>| match refusal {
            Some(refusal) => format!("refuses ({refusal})"),
            None => "goes on".to_owned(),
        };
        match self {
            Self::Difference(difference) => difference.fmt(f),
            Self::Silence(what) => write!(f, "the target does not answer {what}"),
            Self::Reboots => write!(f, "the target was rebooted {MOST_REBOOTS} times in a row"),
            Self::Lost(samples) => write!(f, "{samples} samples were lost in a row"),
            Self::Refusal { target, twin } => {
                write!(f, "the target {}, its twin {}", reason(target), reason(twin))
            }
            Self::Answer(what) => write!(f, "the target does not understand {what}"),
            Self::Broken(broken) => broken.fmt(f),
        }
    }
}

impl From<Parted> for Complaint {
    fn from(parted: Parted) -> Self {
        Self::new(parted.to_string(), "")
    }
}

impl From<Broken> for Parted {
    fn from(broken: Broken) -> Self {
        Self::Broken(broken)
    }
}
