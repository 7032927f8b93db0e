//! Why a run ends early.

use crate::input::{Complaint, InputError};
use crate::navigator::Unavailable;
use crate::scene::Gap;
use crate::source::{Source, SourceError};
use schuler::aiding::aided::fault::AidedFault;
use schuler::link::gap::Missing;
use schuler::strapdown::limits::MOST_TURN;
use schuler::strapdown::limits::Rejected;
use std::fmt;

/// Why a run ended early.
#[derive(Debug)]
pub enum FlightError {
    /// The scene or an option asks for something that is not to be had.
    Input(InputError),
    /// The link lost a sample, and gaps are not bridged.
    Lost {
        /// Its number, from 1.
        sample: u64,
        /// Its end, s.
        time_s: f64,
        /// Whether gaps are bridged, and no sample arrived to bridge from.
        bridged: bool,
    },
    /// The navigator refused a sample.
    Rejected {
        /// Its number, from 1.
        sample: u64,
        /// Its end, s.
        time_s: f64,
        /// Why.
        why: Rejected,
    },
    /// A sample turns a block further than its series is made for.
    Turned {
        /// Its number, from 1.
        sample: u64,
        /// Its end, s.
        time_s: f64,
        /// The largest turn about an axis, rad.
        angle: f64,
        /// Samples of a block.
        block: usize,
        /// Samples per second.
        rate_hz: f64,
    },
    /// Checks that did not keep their bounds.
    Failed {
        /// How many.
        failed: usize,
        /// Of how many.
        checks: usize,
    },
    /// Runs of an ensemble that did not reach their end.
    Runs {
        /// How many.
        failed: usize,
        /// Of how many.
        runs: u64,
    },
    /// A recording, or a device, cannot be navigated beyond this place.
    Stopped(InputError),
}

impl fmt::Display for FlightError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Input(error) | Self::Stopped(error) => error.fmt(f),
            Self::Lost { sample, time_s, bridged: true } => write!(
                f,
                "until sample {sample} at {time_s} s all were lost on the link: \
                 no sample arrived to bridge from"
            ),
            Self::Lost { sample, time_s, bridged: false } => write!(
                f,
                "sample {sample} at {time_s} s was lost on the link; \
                 navigator.gap = \"bridge\" would fill it from its neighbours"
            ),
            Self::Turned { sample, time_s, angle, block, rate_hz } => {
                write!(
                    f,
                    "sample {sample} at {time_s} s turns a block of {block} samples by over "
                )?;
                write!(f, "{MOST_TURN} rad: ")?;
                if let Some((shape, fewer)) = shorter(*angle, *block) {
                    write!(f, "a window with a block of {fewer} would do (--window {shape}), or ")?;
                }
                let rate_hz = (rate_hz * angle * *block as f64 / MOST_TURN).ceil();
                write!(f, "a rate of {rate_hz} Hz")
            }
            Self::Failed { failed, checks } => write!(f, "{failed} of {checks} checks failed"),
            Self::Runs { failed, runs } => {
                write!(f, "{failed} of {runs} runs did not reach their end")
            }
            Self::Rejected { sample, time_s, why } => {
                write!(f, "sample {sample} at {time_s} s: {why}")
            }
        }
    }
}

impl std::error::Error for FlightError {}

impl From<InputError> for FlightError {
    fn from(error: InputError) -> Self {
        Self::Input(error)
    }
}

impl From<SourceError> for FlightError {
    fn from(error: SourceError) -> Self {
        let (key, what) = match error {
            SourceError::Trajectory(error) => ("trajectory", error.to_string()),
            SourceError::Sensor(error) => ("sensor", error.to_string()),
        };
        Self::Input(InputError::option(key, Complaint::new(what, "")))
    }
}

impl From<Unavailable> for FlightError {
    fn from(error: Unavailable) -> Self {
        Self::Input(InputError::option(error.key(), error.complaint()))
    }
}

/// The window with the longest block that samples of an angle may fill, rad, and which is shorter.
fn shorter(angle: f64, block: usize) -> Option<(&'static str, usize)> {
    let windows = [("2,4,2", 4), ("2,2,2", 2)];
    windows.into_iter().find(|&(_, b)| b < block && b as f64 * angle <= MOST_TURN)
}

/// Why a sample was not taken.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refused {
    /// It is missing, and gaps are not bridged.
    Missing,
    /// It cannot be right, or leads where the navigator cannot go.
    Rejected(Rejected),
    /// A measurement that an aided navigator cannot take.
    Aiding(AidedFault),
    /// What navigates cannot go on.
    Stopped(Complaint),
}

impl From<Missing> for Refused {
    fn from(_: Missing) -> Self {
        Self::Missing
    }
}

impl From<Rejected> for Refused {
    fn from(why: Rejected) -> Self {
        Self::Rejected(why)
    }
}

impl Refused {
    /// Whether it is the sample that is wrong, not where it leads: what came before it can be flown.
    pub fn is_of_the_sample(&self) -> bool {
        matches!(
            self,
            Self::Missing | Self::Rejected(Rejected::Angle | Rejected::Turn | Rejected::Velocity)
        )
    }

    /// The same where a sample's increment is at hand, which filled blocks of so many samples.
    pub fn at_increment(
        self,
        sample: u64,
        source: &Source,
        gap: Gap,
        angle_b: Option<[f64; 3]>,
        block: usize,
    ) -> FlightError {
        match (&self, angle_b) {
            (Self::Rejected(Rejected::Turn), Some(angles)) => FlightError::Turned {
                sample,
                time_s: source.time_s(sample),
                angle: angles.into_iter().fold(0.0, |most: f64, angle| most.max(angle.abs())),
                block,
                rate_hz: source.rate_hz(),
            },
            _ => self.at(sample, source, gap),
        }
    }

    /// The error that ends a run at a sample.
    pub fn at(self, sample: u64, source: &Source, gap: Gap) -> FlightError {
        let time_s = source.time_s(sample);
        match self {
            Self::Missing => FlightError::Lost { sample, time_s, bridged: gap == Gap::Bridge },
            Self::Rejected(why) => FlightError::Rejected { sample, time_s, why },
            Self::Aiding(fault) => {
                let complaint = Complaint::new(format!("{time_s} s: {fault}"), "");
                FlightError::Stopped(InputError::option("filter", complaint))
            }
            Self::Stopped(complaint) => {
                FlightError::Stopped(InputError::option("--device", complaint))
            }
        }
    }
}
