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
use super::counters::Counters;
use super::frame::{Frame, Writer};
use super::gap::Policy;
use super::kind::Kind;
use super::refusal::Refusal;
use crate::flight::configuration::Configuration;
use crate::record::Record;

/// Version of everything that crosses the link.
pub const VERSION: u8 = 1;
/// Words of a stored state in one piece, at most.
pub const MOST_WORDS: usize = 24;

/// How to start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Start<'a> {
    /// What to fly.
    pub configuration: Configuration,
    /// The order of its series, at most.
    pub order: u8,
    /// What a missing sample does.
    pub gap: Policy,
    /// The sampling interval in s, and the initial solution: pairs of the navigator's scalar.
    pub initial: Bytes<'a>,
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
        }
    }

    /// Writes the payload.
    pub fn write(&self, to: &mut Writer) {
        match self {
            Self::Greet | Self::Reset => {}
            Self::Start(Start { configuration, order, gap, initial }) => {
                to.bytes(&configuration.to_bytes());
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
            Self::Hold(vertical) => to.bytes(vertical.0),
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
                let configuration = Configuration::from_bytes(bytes.array()?)?;
                let order = bytes.u8()?;
                let gap = match bytes.u8()? {
                    0 => Policy::Refuse,
                    1 => Policy::Bridge,
                    _ => return None,
                };
                Self::Start(Start { configuration, order, gap, initial: bytes.rest() })
            }
            Kind::Restore => {
                let (words, offset) = (bytes.u16()?, bytes.u16()?);
                Self::Restore { words, offset, piece: bytes.rest() }
            }
            Kind::Sample => Self::Sample { number: bytes.u32()?, increment: bytes.rest() },
            Kind::Hold => Self::Hold(bytes.rest()),
            Kind::Finish => Self::Finish { samples: bytes.u32()? },
            Kind::Hello | Kind::Solution | Kind::Restoring | Kind::Refused => return None,
        };
        bytes.end()?;
        Some(request)
    }
}

/// Where a navigator stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Standing<'a> {
    /// Number of the last sample that it has taken, or filled in.
    pub taken: u32,
    /// Of the last 32 of them a bit each, the newest lowest: whether it came, or was filled in.
    pub came: u32,
    /// Samples that lie behind the solution.
    pub integrated: u64,
    /// Digest of every state so far.
    pub digest: u64,
    /// The solution in the navigator's own axes: ten pairs of its scalar.
    pub solution: Bytes<'a>,
}

/// What a target says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Answer<'a> {
    /// Sequence number of the frame that it answers; 0 if unasked.
    pub answers: u32,
    /// How often it was switched on before, or another number that differs every time.
    pub boot: u32,
    /// What it has noticed of the host's frames since then, or since the host has greeted it.
    pub counters: Counters,
    /// The answer.
    pub body: Body<'a>,
}

/// The part of an answer that depends on its kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Body<'a> {
    /// It is there.
    Hello {
        /// Its [`VERSION`].
        version: u8,
        /// What it can fly: a [`Configuration`] after the other.
        offers: Bytes<'a>,
    },
    /// Where it stands.
    Solution(Standing<'a>),
    /// How many words of a stored state it has.
    Restoring {
        /// From the first on, without a hole.
        words: u16,
    },
    /// It does not do what was asked.
    Refused {
        /// Why.
        refusal: Refusal,
        /// The sample at which it is.
        taken: u32,
    },
}

impl<'a> Answer<'a> {
    /// Writes what every answer begins with.
    pub fn write_begin(to: &mut Writer, answers: u32, boot: u32, counters: Counters) {
        to.u32(answers);
        to.u32(boot);
        counters.record("", &mut |_, count| to.u32(count as u32));
    }

    /// Reads a target's frame; `None` if its payload is not what its kind needs.
    pub fn read(frame: &Frame<'a>) -> Option<Self> {
        let mut bytes = Bytes(frame.payload);
        let (answers, boot) = (bytes.u32()?, bytes.u32()?);
        let mut counters = Counters::default();
        let mut complete = true;
        counters.restore("", &mut |_, _| {
            let count = bytes.u32();
            complete &= count.is_some();
            count.unwrap_or(0).into()
        });
        if !complete {
            return None;
        }
        let body = match frame.header.kind {
            Kind::Hello => Body::Hello { version: bytes.u8()?, offers: bytes.rest() },
            Kind::Solution => Body::Solution(Standing {
                taken: bytes.u32()?,
                came: bytes.u32()?,
                integrated: bytes.u64()?,
                digest: bytes.u64()?,
                solution: bytes.rest(),
            }),
            Kind::Restoring => Body::Restoring { words: bytes.u16()? },
            Kind::Refused => {
                Body::Refused { refusal: Refusal::from_code(bytes.u8()?)?, taken: bytes.u32()? }
            }
            _ => return None,
        };
        bytes.end()?;
        Some(Self { answers, boot, counters, body })
    }
}
