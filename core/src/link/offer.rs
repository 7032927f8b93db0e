//! What a target can be started for, and with which navigator.
//!
//! The purpose stands in two bits of the algorithm's byte. Who does not know it takes the whole for an unknown
//! configuration, and passes over it.
//!
//! ```
//! use schuler::flight::configuration::Configuration;
//! use schuler::link::offer::{Offer, Purpose};
//!
//! let configuration: Configuration = "f32 local-level taylor 0,4,0".parse()?;
//! let plain = Offer::from(configuration);
//! assert_eq!(plain.to_bytes(), configuration.to_bytes());
//! let aided = Offer { purpose: Purpose::Aiding, ..plain };
//! assert_eq!(Configuration::from_bytes(aided.to_bytes()), None);
//! assert_eq!(Offer::from_bytes(aided.to_bytes()), Some(aided));
//! assert_eq!(aided.to_string(), "aided f32 local-level taylor 0,4,0");
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```

use crate::flight::configuration::{Configuration, Precision};
use core::fmt::{self, Display, Formatter};

/// What samples are for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Purpose {
    /// Navigation by inertia alone.
    #[default]
    Navigation,
    /// Navigation that measurements aid.
    Aiding,
    /// The Allan deviation of a unit that stands still. Of the configuration, the precision alone matters.
    Identification,
}

/// The bits of the purpose.
const MASK: u8 = 0xc0;

impl Purpose {
    const fn bits(self) -> u8 {
        match self {
            Self::Navigation => 0,
            Self::Aiding => 0x80,
            Self::Identification => 0x40,
        }
    }

    const fn from_bits(bits: u8) -> Option<Self> {
        match bits {
            0 => Some(Self::Navigation),
            0x80 => Some(Self::Aiding),
            0x40 => Some(Self::Identification),
            _ => None,
        }
    }
}

/// A navigator, and what it is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Offer {
    /// What it is for.
    pub purpose: Purpose,
    /// What it is.
    pub configuration: Configuration,
}

impl Offer {
    /// The identification of a unit with arithmetic of a precision.
    pub const fn identification(precision: Precision) -> Self {
        use crate::flight::configuration::{Algorithm, Axes};
        let configuration = Configuration {
            precision,
            axes: Axes::LocalLevel,
            algorithm: Algorithm::Textbook,
            window: Configuration::ONE_SAMPLE,
        };
        Self { purpose: Purpose::Identification, configuration }
    }

    /// Its bytes on the link.
    pub fn to_bytes(&self) -> [u8; Configuration::LENGTH] {
        let [precision, axes, algorithm, window @ ..] = self.configuration.to_bytes();
        let [history, block, lookahead] = window;
        [precision, axes, algorithm | self.purpose.bits(), history, block, lookahead]
    }

    /// The inverse of [`to_bytes`](Self::to_bytes); `None` if a code is unknown.
    pub fn from_bytes(bytes: [u8; Configuration::LENGTH]) -> Option<Self> {
        let [precision, axes, algorithm, history, block, lookahead] = bytes;
        let purpose = Purpose::from_bits(algorithm & MASK)?;
        let bytes = [precision, axes, algorithm & !MASK, history, block, lookahead];
        Some(Self { purpose, configuration: Configuration::from_bytes(bytes)? })
    }
}

impl From<Configuration> for Offer {
    fn from(configuration: Configuration) -> Self {
        Self { purpose: Purpose::Navigation, configuration }
    }
}

impl Display for Offer {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self.purpose {
            Purpose::Navigation => self.configuration.fmt(f),
            Purpose::Aiding => write!(f, "aided {}", self.configuration),
            Purpose::Identification => {
                write!(f, "identification in {}", self.configuration.precision)
            }
        }
    }
}
