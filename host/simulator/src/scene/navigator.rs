//! How a scene is navigated, and what happens to its samples on their way.

use schuler::flight::configuration::{Algorithm, Axes, Precision};
use schuler::link::gap::Policy;
use schuler::strapdown::block::shape::WindowShape;

/// How a scene is navigated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Navigator {
    /// Axes of the mechanization.
    pub frame: Axes,
    /// Arithmetic of the navigator.
    pub precision: Precision,
    /// Integration method.
    pub algorithm: Algorithm,
    /// Window of the taylor algorithm; `None` leaves it to the plan ("auto").
    pub window: Option<WindowShape>,
    /// The vertical channel.
    pub vertical: Vertical,
    /// What a missing sample does.
    pub gap: Gap,
}

/// The vertical channel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Vertical {
    /// It runs free: "free".
    Free,
    /// Height and vertical velocity from truth: "held".
    Held,
}

/// What a missing sample does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gap {
    /// The run ends with an error: "error".
    Error,
    /// The gap is filled from its neighbours: "bridge".
    Bridge,
}

/// What happens to samples on their way.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Link {
    /// Probability that a sample is lost.
    pub loss: f64,
    /// Rms of the sampling instants about their nominal times, s.
    pub jitter_s: f64,
}

impl From<Gap> for Policy {
    fn from(gap: Gap) -> Self {
        match gap {
            Gap::Error => Self::Refuse,
            Gap::Bridge => Self::Bridge,
        }
    }
}

macro_rules! names {
    ($type:ident: $($variant:ident = $name:literal),+) => {
        impl $type {
            /// Every name that a scene or an option may give, with its meaning.
            pub const NAMES: &'static [(&'static str, Self)] = &[$(($name, Self::$variant)),+];

            /// The name in scenes, options and summaries.
            pub fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $name),+
                }
            }
        }
    };
}

pub(super) use names;

names!(Vertical: Free = "free", Held = "held");
names!(Gap: Error = "error", Bridge = "bridge");

impl Default for Navigator {
    fn default() -> Self {
        Self {
            frame: Axes::LocalLevel,
            precision: Precision::F64,
            algorithm: Algorithm::Taylor,
            window: None,
            vertical: Vertical::Free,
            gap: Gap::Error,
        }
    }
}
