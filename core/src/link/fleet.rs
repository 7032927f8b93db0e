//! The mechanizations of an image, chosen from at run time.
//!
//! Only the mechanizations that an image names here are linked into it: [`Single`] has no double-precision
//! operation.
//!
//! ```
//! use schuler::link::fleet::{Fleet, Single};
//!
//! // What a target without double precision offers its host.
//! let mut offers = Vec::new();
//! Single::offers(&mut |one| offers.push(one.to_string()));
//! assert!(offers.contains(&"f32 local-level taylor 0,4,0".to_string()));
//! assert!(offers.iter().all(|one| !one.starts_with("f64")));
//! ```

use super::bytes::Bytes;
use super::flight::{LinkedFlight, Taken};
use super::frame::Writer;
use super::message::Start;
use super::offer::Offer;
use super::refusal::Refusal;
use crate::flight::catalogue::{Entry, NamedFrame};
use crate::math::compensated::{Pair, TwoFloat};
use crate::math::real::Scalar;
use crate::record::Record;
use crate::strapdown::block::window::*;
use crate::strapdown::frame::Frame;
use crate::strapdown::frame::earth_fixed::EarthFixed;
use crate::strapdown::frame::local_level::LocalLevel;
use crate::strapdown::navigator::Strapdown;
use crate::strapdown::reference::textbook::{EarthFixedTextbook, LocalLevelTextbook, Textbook};

/// One of several mechanizations in flight.
pub trait Fleet: Copy {
    /// Names every one that can be asked for.
    fn offers(offer: &mut impl FnMut(Offer));
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
    /// Shows the words of its state.
    fn words(&self, read: &mut dyn FnMut(u64));
    /// Writes them: `write` gets a word and returns what it shall be.
    fn restore(&mut self, write: &mut dyn FnMut(u64) -> u64);
    /// Whether the words that were written back can be its state.
    fn check(&self) -> Result<(), Refusal>;
    /// Takes the settings of an aided flight, before its first sample.
    fn aid(&mut self, _settings: Bytes) -> Result<(), Refusal> {
        Err(Refusal::Unaided)
    }
    /// Takes the measurement of a number, from 1. What a sensor says again, too late, or without room for it is
    /// counted.
    fn measure(&mut self, _number: u32, _measured: Bytes) -> Result<Taken, Refusal> {
        Err(Refusal::Unaided)
    }
    /// Shows the flight, whatever its mechanization; `None` if it is no flight by inertia alone.
    fn visit<V: Visitor>(&mut self, visitor: V) -> Option<V::Result>;
}

/// An operation on a flight of any mechanization.
pub trait Visitor {
    /// Its result.
    type Result;
    /// Does it.
    fn visit<M: Entry>(self, flight: &mut LinkedFlight<M>) -> Self::Result;
}

/// A single mechanization: the smallest image.
impl<M: Entry> Fleet for LinkedFlight<M> {
    fn offers(offer: &mut impl FnMut(Offer)) {
        offer(M::CONFIGURATION.into());
    }

    fn start(start: &Start) -> Result<Self, Refusal> {
        if start.offer == M::CONFIGURATION.into() {
            LinkedFlight::start(start)
        } else {
            Err(Refusal::Configuration)
        }
    }

    fn take(&mut self, number: u32, mut increment: Bytes) -> Result<Taken, Refusal> {
        let sample = increment.increment().ok_or(Refusal::Malformed)?;
        increment.end().ok_or(Refusal::Malformed)?;
        LinkedFlight::take(self, number, sample, M::push)
    }

    fn hold(&mut self, mut vertical: Bytes) -> Result<(), Refusal> {
        let pair = vertical.pair().ok_or(Refusal::Malformed)?;
        vertical.end().ok_or(Refusal::Malformed)?;
        LinkedFlight::hold(self, pair.hi, pair.lo)
    }

    fn finish(&mut self, samples: u32) -> Result<Taken, Refusal> {
        LinkedFlight::finish(self, samples, M::push, M::finish)
    }

    fn taken(&self) -> u32 {
        LinkedFlight::taken(self)
    }

    fn bridged(&self) -> u32 {
        LinkedFlight::bridged(self)
    }

    fn write(&self, to: &mut Writer) {
        LinkedFlight::write(self, to);
    }

    fn words(&self, read: &mut dyn FnMut(u64)) {
        self.record("", &mut |_, bits| read(bits));
    }

    fn restore(&mut self, write: &mut dyn FnMut(u64) -> u64) {
        Record::restore(self, "", &mut |_, bits| write(bits));
    }

    fn check(&self) -> Result<(), Refusal> {
        Ok(LinkedFlight::check(self)?)
    }

    fn visit<V: Visitor>(&mut self, visitor: V) -> Option<V::Result> {
        Some(visitor.visit(self))
    }
}

/// The windows of a target in one frame.
macro_rules! in_frame {
    ($($window:ident),+) => {
        fleet! {
            /// A frame with the windows that targets have.
            #[cfg_attr(feature = "defmt", derive(defmt::Format))]
            pub InFrame [F: Flown] of [F] {
                $($window: LinkedFlight<Strapdown<F, $window>>,)+
            }
        }
    };
}
windows_of! { target in_frame! }

/// A frame that the link can start, store and compare.
pub trait Flown:
    Frame<Real: Scalar + Record, Output: Record> + NamedFrame + Record + 'static
{
}

impl<F> Flown for F where
    F: Frame<Real: Scalar + Record, Output: Record> + NamedFrame + Record + 'static
{
}

/// Every frame with those windows, and the textbook.
macro_rules! every {
    ($($name:ident: $precision:ident, $axes:ident, $frame:ty, $windows:ident,
       [$($of:ident: $textbook:ty)?];)+) => {
        fleet! {
            /// Single and double precision, both axes.
            #[cfg_attr(feature = "defmt", derive(defmt::Format))]
            pub Every {
                $($name: InFrame<$frame>, $($of: LinkedFlight<Textbook<$textbook>>,)?)+
            }
        }
    };
}
every_frame! { every! }

fleet! {
    /// Single precision, local-level, with and without two-float products: no double-precision operation.
    /// (In Earth-fixed axes the vertical channel is held by libm's `sinf`, which has some.)
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    pub Single {
        LocalLevel: InFrame<LocalLevel<Pair<f32>>>,
        TwoFloat: InFrame<LocalLevel<TwoFloat<f32>>>,
        Textbook: LinkedFlight<Textbook<LocalLevelTextbook<f32>>>,
    }
}
