//! What a target can be asked to fly: a mechanization by its digits, axes, method and window.

use crate::math::compensated::{Pair, TwoFloat};
use crate::math::real::Scalar;
use crate::record::Record;
use crate::strapdown::block::window::Window;
use crate::strapdown::frame::Frame;
use crate::strapdown::frame::earth_fixed::EarthFixed;
use crate::strapdown::frame::local_level::LocalLevel;
use crate::strapdown::limits::StartError;
use crate::strapdown::mechanization::Mechanization;
use crate::strapdown::navigator::Strapdown;
use crate::strapdown::plan::Digits;
use crate::strapdown::reference::textbook::{
    EarthFixedTextbook, LocalLevelTextbook, Textbook, TextbookFrame,
};

/// Axes of the mechanization.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Axes {
    /// North, east, down at the vehicle.
    LocalLevel,
    /// Axes that turn with the Earth.
    EarthFixed,
}

/// Integration method.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Method {
    /// A series over a window of samples.
    Taylor,
    /// Single plus previous sample.
    Textbook,
}

/// What tells one mechanization from another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Configuration {
    /// What it computes with.
    pub digits: Digits,
    /// In which axes.
    pub axes: Axes,
    /// How.
    pub method: Method,
    /// From how many samples: history, block, look-ahead. The textbook's is 0, 1, 0.
    pub window: [u8; 3],
}

impl Configuration {
    /// Bytes on the line.
    pub const LENGTH: usize = 6;

    /// As it crosses the line.
    pub fn to_bytes(&self) -> [u8; Self::LENGTH] {
        let digits = match self.digits {
            Digits::Double => 0,
            Digits::Single => 1,
            Digits::TwoFloat => 2,
        };
        let axes = match self.axes {
            Axes::LocalLevel => 0,
            Axes::EarthFixed => 1,
        };
        let method = match self.method {
            Method::Taylor => 0,
            Method::Textbook => 1,
        };
        let [history, block, lookahead] = self.window;
        [digits, axes, method, history, block, lookahead]
    }

    /// Back from [`Configuration::to_bytes`].
    pub fn of_bytes([digits, axes, method, window @ ..]: [u8; Self::LENGTH]) -> Option<Self> {
        let digits = match digits {
            0 => Digits::Double,
            1 => Digits::Single,
            2 => Digits::TwoFloat,
            _ => return None,
        };
        let axes = match axes {
            0 => Axes::LocalLevel,
            1 => Axes::EarthFixed,
            _ => return None,
        };
        let method = match method {
            0 => Method::Taylor,
            1 => Method::Textbook,
            _ => return None,
        };
        Some(Self { digits, axes, method, window })
    }
}

/// A mechanization that the link can start, feed, store and compare.
pub trait Linked:
    Mechanization<Real: Scalar + Record, Frame: Record, State: Record, Output: Record> + Copy + 'static
{
    /// How it is asked for.
    const CONFIGURATION: Configuration;

    /// For samples of an interval in seconds, with a series of at most this order.
    fn configured(interval_s: Pair<Self::Real>, order: usize) -> Result<Self, StartError>;
}

/// The digits and axes of a frame.
pub trait LinkedFrame {
    /// What it computes with.
    const DIGITS: Digits;
    /// In which axes.
    const AXES: Axes;
}

macro_rules! linked {
    ($($frame:ty: $digits:ident $axes:ident;)+) => {
        $(impl LinkedFrame for $frame {
            const DIGITS: Digits = Digits::$digits;
            const AXES: Axes = Axes::$axes;
        })+
    };
}

linked! {
    LocalLevel<Pair<f64>>: Double LocalLevel;
    LocalLevel<Pair<f32>>: Single LocalLevel;
    LocalLevel<TwoFloat<f32>>: TwoFloat LocalLevel;
    EarthFixed<Pair<f64>>: Double EarthFixed;
    EarthFixed<Pair<f32>>: Single EarthFixed;
    EarthFixed<TwoFloat<f32>>: TwoFloat EarthFixed;
    LocalLevelTextbook<f64>: Double LocalLevel;
    LocalLevelTextbook<f32>: Single LocalLevel;
    EarthFixedTextbook<f64>: Double EarthFixed;
    EarthFixedTextbook<f32>: Single EarthFixed;
}

impl<F, W> Linked for Strapdown<F, W>
where
    F: Frame<Real: Scalar + Record, Output: Record> + LinkedFrame + Record + 'static,
    W: Window,
{
    const CONFIGURATION: Configuration = Configuration {
        digits: F::DIGITS,
        axes: F::AXES,
        method: Method::Taylor,
        window: [W::HISTORY as u8, W::BLOCK as u8, W::LOOKAHEAD as u8],
    };

    fn configured(interval_s: Pair<F::Real>, order: usize) -> Result<Self, StartError> {
        Ok(Self::new(interval_s)?.with_order(order))
    }
}

impl<F> Linked for Textbook<F>
where
    F: TextbookFrame<Real: Scalar + Record, Output: Record> + LinkedFrame + Record + 'static,
{
    const CONFIGURATION: Configuration = Configuration {
        digits: F::DIGITS,
        axes: F::AXES,
        method: Method::Textbook,
        window: [0, 1, 0],
    };

    fn configured(interval_s: Pair<F::Real>, _: usize) -> Result<Self, StartError> {
        Self::new(interval_s.hi)
    }
}
