//! What contradicts an alignment, or makes it too poor.
//!
//! ```
//! use schuler::aiding::alignment::verdict::AlignmentFault;
//!
//! assert!(AlignmentFault::Pole.to_string().contains("pole"));
//! ```

use crate::strapdown::limits::Rejected;

/// Why an alignment does not start, or stops.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum AlignmentFault {
    /// Within 6° of a pole, where the Earth's rate has hardly a horizontal component.
    Pole,
    /// A standard deviation that is not above 0, or more states than the filter has.
    Settings,
    /// An attitude or a place from which navigation cannot start.
    Start,
    /// A sample that the mechanization refuses; the state is unchanged.
    Rejected(Rejected),
    /// A second of measurements was refused: the vehicle moves more than its base is said to.
    Moved,
    /// A vehicle that moved, but hardly changed its velocity: nothing shows its heading.
    Unseen,
    /// Estimates that the mechanization refuses: the samples do not fit a vehicle that goes nowhere.
    Diverged,
}

impl core::fmt::Display for AlignmentFault {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(match self {
            Self::Pole => "there is no heading within 6° of a pole",
            Self::Settings => {
                "every standard deviation must be above 0, and the states must fit the filter"
            }
            Self::Start => "navigation cannot start from this attitude and place",
            Self::Rejected(rejected) => return rejected.fmt(f),
            Self::Moved => {
                "a second of measurements is refused: it moves more than its base is said to"
            }
            Self::Unseen => "no heading is seen: the velocity has hardly changed",
            Self::Diverged => {
                "the estimates diverged: the samples do not fit a vehicle that goes nowhere"
            }
        })
    }
}

impl core::error::Error for AlignmentFault {}
