//! The mechanizations of an image, chosen from at run time.
//!
//! Only the mechanizations that an image names here are linked into it: [`Single`] has no double-precision
//! operation.

use super::bytes::Bytes;
use super::configuration::{Configuration, Linked};
use super::flight::{Flight, Taken};
use super::frame::Writer;
use super::message::Start;
use super::refusal::Refusal;
use crate::math::compensated::{Pair, TwoFloat};
use crate::record::Record;
use crate::strapdown::block::window::{H0B4A0, H2B4A2};
use crate::strapdown::frame::earth_fixed::EarthFixed;
use crate::strapdown::frame::local_level::LocalLevel;
use crate::strapdown::navigator::Strapdown;
use crate::strapdown::reference::textbook::{EarthFixedTextbook, LocalLevelTextbook, Textbook};

/// One of several mechanizations in flight.
pub trait Fleet: Copy {
    /// Names every one that can be asked for.
    fn offers(offer: impl FnMut(Configuration));
    /// Starts the one that is asked for.
    fn start(start: &Start) -> Result<Self, Refusal>;
    /// Takes a sample; no row is read.
    fn take(&mut self, number: u32, increment: Bytes) -> Result<Taken, Refusal>;
    /// Sets height and vertical velocity.
    fn hold(&mut self, vertical: Bytes) -> Result<(), Refusal>;
    /// Ends the stream after this number of samples.
    fn finish(&mut self, samples: u32) -> Result<Taken, Refusal>;
    /// Number of the last sample taken.
    fn taken(&self) -> u32;
    /// Samples filled in.
    fn bridged(&self) -> u32;
    /// Writes where it stands.
    fn write(&self, to: &mut Writer);
    /// Walks the words of its state, to read them or to write them back.
    fn words(&mut self, visit: &mut dyn FnMut(u64) -> u64);
    /// Whether the words that were written back can be its state.
    fn check(&self) -> Result<(), Refusal>;
    /// Shows the flight, whatever its mechanization.
    fn visit<V: Visitor>(&mut self, visitor: V) -> V::Result;
}

/// An operation on a flight of any mechanization.
pub trait Visitor {
    /// Its result.
    type Result;
    /// Does it.
    fn visit<M: Linked>(self, flight: &mut Flight<M>) -> Self::Result;
}

/// A single mechanization: the smallest image.
impl<M: Linked> Fleet for Flight<M> {
    fn offers(mut offer: impl FnMut(Configuration)) {
        offer(M::CONFIGURATION);
    }

    fn start(start: &Start) -> Result<Self, Refusal> {
        if start.configuration == M::CONFIGURATION {
            Flight::start(start)
        } else {
            Err(Refusal::Configuration)
        }
    }

    fn take(&mut self, number: u32, mut increment: Bytes) -> Result<Taken, Refusal> {
        let sample = increment.increment().ok_or(Refusal::Malformed)?;
        increment.end().ok_or(Refusal::Malformed)?;
        Flight::take(self, number, sample, M::push)
    }

    fn hold(&mut self, mut vertical: Bytes) -> Result<(), Refusal> {
        let pair = vertical.pair().ok_or(Refusal::Malformed)?;
        vertical.end().ok_or(Refusal::Malformed)?;
        Flight::hold(self, pair.hi, pair.lo)
    }

    fn finish(&mut self, samples: u32) -> Result<Taken, Refusal> {
        Flight::finish(self, samples, M::push, M::finish)
    }

    fn taken(&self) -> u32 {
        Flight::taken(self)
    }

    fn bridged(&self) -> u32 {
        Flight::bridged(self)
    }

    fn write(&self, to: &mut Writer) {
        Flight::write(self, to);
    }

    fn words(&mut self, visit: &mut dyn FnMut(u64) -> u64) {
        self.record("", &mut |_, bits| visit(bits));
    }

    fn check(&self) -> Result<(), Refusal> {
        Ok(Flight::check(self)?)
    }

    fn visit<V: Visitor>(&mut self, visitor: V) -> V::Result {
        visitor.visit(self)
    }
}

/// Makes a [`Fleet`](crate::link::fleet::Fleet) of some mechanizations, each
/// [`Linked`](crate::link::configuration::Linked).
#[macro_export]
macro_rules! fleet {
    ($($(#[$doc:meta])* $visibility:vis $name:ident {
        $($variant:ident: $mechanization:ty,)+
    })+) => {$(
        $(#[$doc])*
        // Nothing is on a heap, and a target has one of them.
        #[allow(clippy::large_enum_variant)]
        #[derive(Clone, Copy, Debug)]
        $visibility enum $name {
            $(
                #[doc = concat!("`", stringify!($mechanization), "`.")]
                $variant($crate::link::flight::Flight<$mechanization>),
            )+
        }

        const _: () = {
            use $crate::link::bytes::Bytes;
            use $crate::link::configuration::{Configuration, Linked};
            use $crate::link::fleet::{Fleet, Visitor};
            use $crate::link::flight::{Flight, Taken};
            use $crate::link::frame::Writer;
            use $crate::link::message::Start;
            use $crate::link::refusal::Refusal;

            impl Fleet for $name {
                fn offers(mut offer: impl FnMut(Configuration)) {
                    $(offer(<$mechanization as Linked>::CONFIGURATION);)+
                }

                fn start(start: &Start) -> Result<Self, Refusal> {
                    $(if start.configuration == <$mechanization as Linked>::CONFIGURATION {
                        return Flight::start(start).map(Self::$variant);
                    })+
                    Err(Refusal::Configuration)
                }

                fn take(&mut self, number: u32, increment: Bytes) -> Result<Taken, Refusal> {
                    match self {
                        $(Self::$variant(flight) => Fleet::take(flight, number, increment),)+
                    }
                }

                fn hold(&mut self, vertical: Bytes) -> Result<(), Refusal> {
                    match self {
                        $(Self::$variant(flight) => Fleet::hold(flight, vertical),)+
                    }
                }

                fn finish(&mut self, samples: u32) -> Result<Taken, Refusal> {
                    match self {
                        $(Self::$variant(flight) => Fleet::finish(flight, samples),)+
                    }
                }

                fn taken(&self) -> u32 {
                    match self {
                        $(Self::$variant(flight) => flight.taken(),)+
                    }
                }

                fn bridged(&self) -> u32 {
                    match self {
                        $(Self::$variant(flight) => flight.bridged(),)+
                    }
                }

                fn write(&self, to: &mut Writer) {
                    match self {
                        $(Self::$variant(flight) => flight.write(to),)+
                    }
                }

                fn words(&mut self, visit: &mut dyn FnMut(u64) -> u64) {
                    match self {
                        $(Self::$variant(flight) => Fleet::words(flight, visit),)+
                    }
                }

                fn check(&self) -> Result<(), Refusal> {
                    match self {
                        $(Self::$variant(flight) => Fleet::check(flight),)+
                    }
                }

                fn visit<V: Visitor>(&mut self, visitor: V) -> V::Result {
                    match self {
                        $(Self::$variant(flight) => visitor.visit(flight),)+
                    }
                }
            }
        };
    )+};
}

fleet! {
    /// Single precision, local-level, with and without two-float products: no double-precision operation.
    /// (In Earth-fixed axes the vertical channel is held by libm's `sinf`, which has some.)
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    pub Single {
        LocalLevel4: Strapdown<LocalLevel<Pair<f32>>, H0B4A0>,
        LocalLevel8: Strapdown<LocalLevel<Pair<f32>>, H2B4A2>,
        TwoFloat4: Strapdown<LocalLevel<TwoFloat<f32>>, H0B4A0>,
        TwoFloat8: Strapdown<LocalLevel<TwoFloat<f32>>, H2B4A2>,
        LocalLevelTextbook: Textbook<LocalLevelTextbook<f32>>,
    }

    /// Single and double precision, both axes.
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    pub Every {
        DoubleLocalLevel4: Strapdown<LocalLevel<Pair<f64>>, H0B4A0>,
        DoubleLocalLevel8: Strapdown<LocalLevel<Pair<f64>>, H2B4A2>,
        DoubleEarthFixed4: Strapdown<EarthFixed<Pair<f64>>, H0B4A0>,
        DoubleEarthFixed8: Strapdown<EarthFixed<Pair<f64>>, H2B4A2>,
        DoubleLocalLevelTextbook: Textbook<LocalLevelTextbook<f64>>,
        DoubleEarthFixedTextbook: Textbook<EarthFixedTextbook<f64>>,
        LocalLevel4: Strapdown<LocalLevel<Pair<f32>>, H0B4A0>,
        LocalLevel8: Strapdown<LocalLevel<Pair<f32>>, H2B4A2>,
        EarthFixed4: Strapdown<EarthFixed<Pair<f32>>, H0B4A0>,
        EarthFixed8: Strapdown<EarthFixed<Pair<f32>>, H2B4A2>,
        TwoFloat4: Strapdown<LocalLevel<TwoFloat<f32>>, H0B4A0>,
        TwoFloat8: Strapdown<LocalLevel<TwoFloat<f32>>, H2B4A2>,
        TwoFloatEarthFixed4: Strapdown<EarthFixed<TwoFloat<f32>>, H0B4A0>,
        TwoFloatEarthFixed8: Strapdown<EarthFixed<TwoFloat<f32>>, H2B4A2>,
        LocalLevelTextbook: Textbook<LocalLevelTextbook<f32>>,
        EarthFixedTextbook: Textbook<EarthFixedTextbook<f32>>,
    }
}
