//! The single list of navigators. Everything that chooses one at run time takes its names and its dispatch
//! from here.
//!
//! A navigator combines a row of [`every_frame!`](crate::every_frame) (precision, axes, frame) with a window from
//! the table in [`window`](crate::strapdown::block::window), or with the textbook's algorithm. A new line in
//! either table gives a new navigator to everything that uses the table.
//!
//! ```
//! use schuler::flight::catalogue::{Catalogue, Every};
//!
//! let mut in_single_precision = 0;
//! Every::each(&mut |one| in_single_precision += usize::from(one.to_string().starts_with("f32 ")));
//! assert!(in_single_precision > 20);
//! ```

use super::configuration::{Algorithm, Axes, Configuration, Precision};
use crate::math::compensated::{Pair, TwoFloat};
use crate::math::real::Scalar;
use crate::record::Record;
use crate::strapdown::block::any_window::AnyWindow;
use crate::strapdown::block::window::*;
use crate::strapdown::frame::Frame;
use crate::strapdown::frame::earth_fixed::EarthFixed;
use crate::strapdown::frame::local_level::LocalLevel;
use crate::strapdown::limits::StartError;
use crate::strapdown::mechanization::{Mechanization, UnequalIntervals};
use crate::strapdown::navigator::Strapdown;
use crate::strapdown::navigator::selected::Selected;
use crate::strapdown::reference::textbook::{
    EarthFixedTextbook, LocalLevelTextbook, Textbook, TextbookFrame,
};

/// A mechanization that can be requested by name, started, stored and compared.
pub trait Entry:
    Mechanization<Real: Scalar + Record, Frame: Record, State: Record, Output: Record, Body: Record>
    + Copy
    + Send
    + 'static
{
    /// Its name.
    const CONFIGURATION: Configuration;
    /// A mechanization with the same bits for samples of any length, of one type for all windows.
    type AnyInterval: UnequalIntervals<
            Real = Self::Real,
            Frame = Self::Frame,
            Output = Self::Output,
            Body = Self::Body,
        > + Copy
        + Send
        + 'static;

    /// For samples of an interval in seconds, with a series of at most this order.
    fn configured(interval_s: Pair<Self::Real>, order: usize) -> Result<Self, StartError>;
    /// The same for samples of any length.
    fn any_interval(
        interval_s: Pair<Self::Real>,
        order: usize,
    ) -> Result<Self::AnyInterval, StartError>;
}

/// A frame by name.
pub trait NamedFrame {
    /// What it computes with.
    const PRECISION: Precision;
    /// Its axes.
    const AXES: Axes;
}

/// Calls a macro with a row for every precision and axes, after the tokens given here. A row has a name, the
/// precision, the axes, the frame, the windows that the host has in it (`all`, or a use in the table of
/// windows) and, if there is one, the textbook in this frame with its name.
#[doc(hidden)]
#[macro_export]
macro_rules! every_frame {
    ($each:ident! $($first:tt)*) => { $each! { $($first)*
        F64LocalLevel: F64, LocalLevel, LocalLevel<Pair<f64>>, all,
            [F64LocalLevelTextbook: LocalLevelTextbook<f64>];
        F64EarthFixed: F64, EarthFixed, EarthFixed<Pair<f64>>, all,
            [F64EarthFixedTextbook: EarthFixedTextbook<f64>];
        F32LocalLevel: F32, LocalLevel, LocalLevel<Pair<f32>>, all,
            [F32LocalLevelTextbook: LocalLevelTextbook<f32>];
        F32EarthFixed: F32, EarthFixed, EarthFixed<Pair<f32>>, all,
            [F32EarthFixedTextbook: EarthFixedTextbook<f32>];
        F32x2LocalLevel: F32x2, LocalLevel, LocalLevel<TwoFloat<f32>>, two_float, [];
        F32x2EarthFixed: F32x2, EarthFixed, EarthFixed<TwoFloat<f32>>, two_float, [];
    } };
}

macro_rules! named {
    ($($name:ident: $precision:ident, $axes:ident, $frame:ty, $windows:ident,
       [$($of:ident: $textbook:ty)?];)+) => {$(
        impl NamedFrame for $frame {
            const PRECISION: Precision = Precision::$precision;
            const AXES: Axes = Axes::$axes;
        }
        $(impl NamedFrame for $textbook {
            const PRECISION: Precision = Precision::$precision;
            const AXES: Axes = Axes::$axes;
        })?
    )+};
}
every_frame! { named! }

impl<F, W> Entry for Strapdown<F, W>
where
    F: Frame<Real: Scalar + Record, Output: Record> + NamedFrame + Record + 'static,
    W: Window,
{
    const CONFIGURATION: Configuration = Configuration {
        precision: F::PRECISION,
        axes: F::AXES,
        algorithm: Algorithm::Taylor,
        window: W::SHAPE,
    };
    type AnyInterval = Selected<F>;

    fn configured(interval_s: Pair<F::Real>, order: usize) -> Result<Self, StartError> {
        Ok(Self::new(interval_s)?.with_order(order))
    }

    fn any_interval(interval_s: Pair<F::Real>, order: usize) -> Result<Selected<F>, StartError> {
        Ok(Selected::new(interval_s, AnyWindow::of::<W>())?.with_order(order))
    }
}

impl<F> Entry for Textbook<F>
where
    F: TextbookFrame<Real: Scalar + Record, Output: Record> + NamedFrame + Record + 'static,
{
    const CONFIGURATION: Configuration = Configuration {
        precision: F::PRECISION,
        axes: F::AXES,
        algorithm: Algorithm::Textbook,
        window: Configuration::ONE_SAMPLE,
    };
    type AnyInterval = Self;

    fn configured(interval_s: Pair<F::Real>, _: usize) -> Result<Self, StartError> {
        Self::new(interval_s.hi)
    }

    fn any_interval(interval_s: Pair<F::Real>, order: usize) -> Result<Self, StartError> {
        Self::configured(interval_s, order)
    }
}

/// An operation on the type of a navigator.
pub trait Visitor {
    /// Its result.
    type Result;
    /// Carries it out.
    fn visit<M: Entry>(self) -> Self::Result;
}

/// A set of navigators to choose from.
pub trait Catalogue {
    /// Passes on the name of each, in order.
    fn each(name: &mut dyn FnMut(Configuration));
    /// Carries out an operation on the requested one; `None` if the set does not have it.
    fn visit<V: Visitor>(asked: &Configuration, visitor: V) -> Option<V::Result>;

    /// Whether the set has it.
    fn has(asked: &Configuration) -> bool {
        let mut found = false;
        Self::each(&mut |one| found |= one == *asked);
        found
    }
}

/// Every navigator: the set of the host.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Every;

/// The navigators that audits record step by step and that golden chains contain.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Audited;

/// Names a mechanization, or visits it if it is the requested one.
macro_rules! consider {
    ([name $name:ident] $entry:ty) => {
        $name(<$entry as Entry>::CONFIGURATION);
    };
    ([visit $asked:ident $visitor:ident] $entry:ty) => {
        if *$asked == <$entry as Entry>::CONFIGURATION {
            return Some($visitor.visit::<$entry>());
        }
    };
}

/// Considers a frame with some windows.
macro_rules! with_windows {
    ($how:tt $frame:ty; $($window:ident),*) => {
        $(consider!($how Strapdown<$frame, $window>);)*
    };
}

/// Considers a frame with the windows of a use.
macro_rules! with_use {
    (all $how:tt $frame:ty) => {
        every_window! { with_windows! $how $frame; }
    };
    ($of:ident $how:tt $frame:ty) => {
        windows_of! { $of with_windows! $how $frame; }
    };
}

/// Considers every navigator.
macro_rules! every {
    ($how:tt $($name:ident: $precision:ident, $axes:ident, $frame:ty, $windows:ident,
               [$($of:ident: $textbook:ty)?];)+) => {
        $(every!(@textbook $how [$($textbook)?]); with_use!($windows $how $frame);)+
    };
    (@textbook $how:tt [$textbook:ty]) => { consider!($how Textbook<$textbook>); };
    (@textbook $how:tt []) => {};
}

/// Considers those that are audited.
macro_rules! audited {
    ($how:tt $($name:ident: $precision:ident, $axes:ident, $frame:ty, $windows:ident,
               [$($of:ident: $textbook:ty)?];)+) => {
        $(
            every!(@textbook $how [$($textbook)?]);
            with_use!(audited $how $frame);
            audited!(@level $precision $axes $how $frame);
        )+
    };
    (@level F32x2 $axes:ident $how:tt $frame:ty) => {};
    (@level $precision:ident LocalLevel $how:tt $frame:ty) => {
        with_use!(audited_level $how $frame);
    };
    (@level $precision:ident $axes:ident $how:tt $frame:ty) => {};
}

macro_rules! catalogues {
    ($($catalogue:ident by $each:ident;)+) => {$(
        impl Catalogue for $catalogue {
            fn each(name: &mut dyn FnMut(Configuration)) {
                every_frame! { $each! [name name] }
            }

            fn visit<V: Visitor>(asked: &Configuration, visitor: V) -> Option<V::Result> {
                every_frame! { $each! [visit asked visitor] }
                None
            }
        }
    )+};
}

catalogues! {
    Every by every;
    Audited by audited;
}
