//! The configuration of a navigator: precision, axes, algorithm and window.
//!
//! ```
//! use schuler::flight::configuration::{Algorithm, Axes, Configuration, Precision};
//! use schuler::strapdown::block::shape::WindowShape;
//!
//! let one: Configuration = "f64 earth-fixed taylor 0,4,0".parse()?;
//! assert_eq!((one.precision, one.axes), (Precision::F64, Axes::EarthFixed));
//! assert_eq!((one.algorithm, one.window), (Algorithm::Taylor, WindowShape::new(0, 4, 0)));
//! assert_eq!(Configuration::from_bytes(one.to_bytes()), Some(one));
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```

use crate::strapdown::block::shape::WindowShape;
use core::fmt::{self, Display, Formatter};
use core::str::FromStr;

/// A word that is not accepted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct UnknownWord {
    /// The accepted words.
    pub accepted: &'static [&'static str],
}

impl Display for UnknownWord {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str("accepted:")?;
        self.accepted.iter().enumerate().try_for_each(|(n, word)| {
            f.write_str(if n == 0 { " " } else { ", " })?;
            f.write_str(word)
        })
    }
}

impl core::error::Error for UnknownWord {}

/// An enum whose values have a word in scenes, options and files, and a code on the link.
macro_rules! words {
    ($($(#[$doc:meta])* $name:ident { $($(#[$of:meta])* $variant:ident = $code:literal $word:literal,)+ })+) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        pub enum $name {
            $($(#[$of])* $variant = $code,)+
        }

        impl $name {
            /// Every word that is accepted in scenes and options, with its value.
            pub const NAMES: &'static [(&'static str, Self)] = &[$(($word, Self::$variant)),+];

            /// The word for it in scenes, options and files.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $word),+
                }
            }

            /// The code for it on the link.
            pub const fn code(self) -> u8 {
                self as u8
            }

            /// The inverse of [`code`](Self::code).
            pub const fn from_code(code: u8) -> Option<Self> {
                match code {
                    $($code => Some(Self::$variant),)+
                    _ => None,
                }
            }
        }

        impl Display for $name {
            fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
                f.pad(self.name())
            }
        }

        impl FromStr for $name {
            type Err = UnknownWord;

            fn from_str(text: &str) -> Result<Self, UnknownWord> {
                let found = Self::NAMES.iter().find(|(word, _)| *word == text);
                found.map(|&(_, value)| value).ok_or(UnknownWord { accepted: &[$($word),+] })
            }
        }
    )+};
}

words! {
    /// Arithmetic of a navigator.
    Precision {
        /// Double, compensated sums.
        F64 = 0 "f64",
        /// Single, compensated sums: rounding matters more than truncation.
        F32 = 1 "f32",
        /// Single, with two-float products where they matter.
        F32x2 = 2 "f32x2",
    }

    /// Axes of a navigator.
    Axes {
        /// North, east, down at the vehicle.
        LocalLevel = 0 "local-level",
        /// Axes that turn with the Earth.
        EarthFixed = 1 "earth-fixed",
    }

    /// Integration method.
    Algorithm {
        /// Windows of samples, a Taylor series about the block's centre.
        Taylor = 0 "taylor",
        /// One sample at a time, with corrections from the previous one.
        Textbook = 1 "textbook",
    }
}

/// The configuration of a navigator, written as `f32 local-level taylor 0,4,0`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Configuration {
    /// Its arithmetic.
    pub precision: Precision,
    /// Its axes.
    pub axes: Axes,
    /// Its integration method.
    pub algorithm: Algorithm,
    /// The samples that a step uses; 0,1,0 for the textbook.
    pub window: WindowShape,
}

impl Configuration {
    /// Its length in bytes on the link.
    pub const LENGTH: usize = 6;
    /// The textbook's window: a sample by itself.
    pub const ONE_SAMPLE: WindowShape = WindowShape::new(0, 1, 0);

    /// Its bytes on the link.
    pub fn to_bytes(&self) -> [u8; Self::LENGTH] {
        let Self { precision, axes, algorithm, window } = self;
        let WindowShape { history, block, lookahead } = *window;
        let [history, block, lookahead] = [history, block, lookahead].map(|samples| samples as u8);
        [precision.code(), axes.code(), algorithm.code(), history, block, lookahead]
    }

    /// The inverse of [`Configuration::to_bytes`]; `None` if a code is unknown.
    pub fn from_bytes(bytes: [u8; Self::LENGTH]) -> Option<Self> {
        let [precision, axes, algorithm, window @ ..] = bytes;
        let [history, block, lookahead] = window.map(usize::from);
        Some(Self {
            precision: Precision::from_code(precision)?,
            axes: Axes::from_code(axes)?,
            algorithm: Algorithm::from_code(algorithm)?,
            window: WindowShape { history, block, lookahead },
        })
    }

    /// The window, if the algorithm has one.
    pub fn window(&self) -> Option<WindowShape> {
        (self.algorithm == Algorithm::Taylor).then_some(self.window)
    }
}

impl Display for Configuration {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Self { precision, axes, algorithm, .. } = self;
        write!(f, "{precision} {axes} {algorithm}")?;
        self.window().map_or(Ok(()), |window| write!(f, " {window}"))
    }
}

/// Text that does not name a navigator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct NotAConfiguration;

impl Display for NotAConfiguration {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str("a navigator is written as precision axes algorithm and, for taylor, window")
    }
}

impl core::error::Error for NotAConfiguration {}

impl FromStr for Configuration {
    type Err = NotAConfiguration;

    fn from_str(text: &str) -> Result<Self, NotAConfiguration> {
        fn word<T: FromStr>(word: Option<&str>) -> Result<T, NotAConfiguration> {
            word.and_then(|word| word.parse().ok()).ok_or(NotAConfiguration)
        }
        let mut words = text.split_whitespace();
        let (precision, axes, algorithm) =
            (word(words.next())?, word(words.next())?, word(words.next())?);
        let window = match algorithm {
            Algorithm::Taylor => word(words.next())?,
            Algorithm::Textbook => Self::ONE_SAMPLE,
        };
        let configuration = Self { precision, axes, algorithm, window };
        if words.next().is_none() { Ok(configuration) } else { Err(NotAConfiguration) }
    }
}
