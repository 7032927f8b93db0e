//! Messages: what the payloads of frames mean.
//!
//! Numbers whose type depends on the navigator's precision stay bytes here; the navigator reads them as
//! scalars. An answer says which frame it answers, how often the target was switched on, and which errors it
//! noticed on the link.
//!
//! ```
//! use schuler::link::decoder::Decoder;
//! use schuler::link::frame::{Header, MOST_ENCODED, encode};
//! use schuler::link::message::Request;
//!
//! let request = Request::Finish { samples: 36_000 };
//! let header = Header { kind: request.kind(), sequence: 1, time_ns: 0 };
//! let mut line = [0; MOST_ENCODED];
//! let mut decoder = Decoder::default();
//! let mut read = 0;
//! for &byte in encode(&header, &mut line, |payload| request.write(payload))? {
//!     if let Some(frame) = decoder.take(byte) {
//!         assert_eq!(Request::read(&frame), Some(request));
//!         read += 1;
//!     }
//! }
//! assert_eq!(read, 1);
//! # Ok::<(), schuler::link::frame::TooLong>(())
//! ```

use super::bytes::Bytes;
use super::frame::{Frame, Writer};
use super::gap::Policy;
use super::kind::Kind;
use super::offer::Offer;
use super::refusal::Refusal;
use crate::math::compensated::Pair;
use crate::math::real::Scalar;
use crate::record::Record;
use crate::solution::Solution;

pub use super::answer::{Answer, Body, Standing};

/// Version of everything that crosses the link.
pub const VERSION: u8 = 1;
/// Words of a stored state in one piece, at most.
pub const MOST_WORDS: usize = 24;

/// How to start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Start<'a> {
    /// What to fly, and what for.
    pub offer: Offer,
    /// The order of its series, at most.
    pub order: u8,
    /// What a missing sample does.
    pub gap: Policy,
    /// The sampling interval in s, and the initial solution: pairs of the navigator's scalar.
    pub initial: Bytes<'a>,
}

impl Start<'_> {
    /// The sampling interval in s, and the initial solution.
    ///
    /// # Errors
    ///
    /// [`Refusal::Malformed`] if there are more or fewer bytes.
    pub fn beginning<R: Scalar + Record>(&self) -> Result<(Pair<R>, Solution<R>), Refusal> {
        let mut bytes = self.initial;
        let interval_s = bytes.pair().ok_or(Refusal::Malformed)?;
        let (mut initial, mut complete) = (Solution::default(), true);
        initial.restore("", &mut |_, _| {
            let bits = bytes.bits::<R>();
            complete &= bits.is_some();
            bits.unwrap_or(0)
        });
        let whole = complete && bytes.end().is_some();
        if whole { Ok((interval_s, initial)) } else { Err(Refusal::Malformed) }
    }
}

/// What a host asks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Request<'a> {
    /// Who is there?
    Greet,
    /// Start navigation.
    Start(Start<'a>),
    /// Go on from a stored state, after a start of the same kind.
    Restore {
        /// Words of the whole state.
        words: u16,
        /// Where this piece begins.
        offset: u16,
        /// Some words of it, eight bytes each.
        piece: Bytes<'a>,
    },
    /// A sample.
    Sample {
        /// Its number, from 1.
        number: u32,
        /// Its increments: six scalars of the navigator.
        increment: Bytes<'a>,
    },
    /// Height (m) and vertical velocity (down, m/s): two scalars of the navigator.
    Hold(Bytes<'a>),
    /// The stream is at its end.
    Finish {
        /// How many samples it had.
        samples: u32,
    },
    /// Forget everything.
    Reset,
    /// The settings of an aided flight: their record, eight bytes a word.
    Aid(Bytes<'a>),
    /// A measurement.
    Measure {
        /// Its number, from 1: one that is sent again is known by it.
        number: u32,
        /// Its record, eight bytes a word.
        measured: Bytes<'a>,
    },
    /// Which words does the state have?
    Read {
        /// From this one on.
        offset: u16,
    },
}

impl<'a> Request<'a> {
    /// The kind of its frame.
    pub fn kind(&self) -> Kind {
        match self {
            Self::Greet => Kind::Greet,
            Self::Start(_) => Kind::Start,
            Self::Restore { .. } => Kind::Restore,
            Self::Sample { .. } => Kind::Sample,
            Self::Hold(_) => Kind::Hold,
            Self::Finish { .. } => Kind::Finish,
            Self::Reset => Kind::Reset,
            Self::Aid(_) => Kind::Aid,
            Self::Measure { .. } => Kind::Measure,
            Self::Read { .. } => Kind::Read,
        }
    }

    /// Writes the payload.
    pub fn write(&self, to: &mut Writer) {
        match self {
            Self::Greet | Self::Reset => {}
            Self::Start(Start { offer, order, gap, initial }) => {
                to.bytes(&offer.to_bytes());
                to.u8(*order);
                to.u8(match gap {
                    Policy::Refuse => 0,
                    Policy::Bridge => 1,
                });
                to.bytes(initial.0);
            }
            Self::Restore { words, offset, piece } => {
                to.u16(*words);
                to.u16(*offset);
                to.bytes(piece.0);
            }
            Self::Sample { number, increment } => {
                to.u32(*number);
                to.bytes(increment.0);
            }
            Self::Hold(words) | Self::Aid(words) => to.bytes(words.0),
            Self::Measure { number, measured } => {
                to.u32(*number);
                to.bytes(measured.0);
            }
            Self::Read { offset } => to.u16(*offset),
            Self::Finish { samples } => to.u32(*samples),
        }
    }

    /// Reads a host's frame; `None` if its payload is not what its kind needs.
    pub fn read(frame: &Frame<'a>) -> Option<Self> {
        let mut bytes = Bytes(frame.payload);
        let request = match frame.header.kind {
            Kind::Greet => Self::Greet,
            Kind::Reset => Self::Reset,
            Kind::Start => {
                let offer = Offer::from_bytes(bytes.array()?)?;
                let order = bytes.u8()?;
                let gap = match bytes.u8()? {
                    0 => Policy::Refuse,
                    1 => Policy::Bridge,
                    _ => return None,
                };
                Self::Start(Start { offer, order, gap, initial: bytes.rest() })
            }
            Kind::Restore => {
                let (words, offset) = (bytes.u16()?, bytes.u16()?);
                Self::Restore { words, offset, piece: bytes.rest() }
            }
            Kind::Sample => Self::Sample { number: bytes.u32()?, increment: bytes.rest() },
            Kind::Hold => Self::Hold(bytes.rest()),
            Kind::Finish => Self::Finish { samples: bytes.u32()? },
            Kind::Aid => Self::Aid(bytes.rest()),
            Kind::Measure => Self::Measure { number: bytes.u32()?, measured: bytes.rest() },
            Kind::Read => Self::Read { offset: bytes.u16()? },
            Kind::Hello | Kind::Solution | Kind::Restoring | Kind::Refused | Kind::State => {
                return None;
            }
        };
        bytes.end()?;
        Some(request)
    }
}
