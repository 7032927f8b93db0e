//! Answers: what the frames of a target mean.
//!
//! ```
//! use schuler::link::answer::{Answer, Body};
//! use schuler::link::decoder::Decoder;
//! use schuler::link::fleet::Single;
//! use schuler::link::target::Target;
//!
//! let mut decoder = Decoder::default();
//! let mut offers = 0;
//! Target::<Single>::new(7).hello(&mut |bytes: &[u8]| {
//!     for &byte in bytes {
//!         let Some(frame) = decoder.take(byte) else { continue };
//!         if let Some(Answer { boot: 7, body: Body::Hello { offers: all, .. }, .. }) = Answer::read(&frame) {
//!             offers = all.0.len() / 6;
//!         }
//!     }
//! });
//! assert!(offers > 2);
//! ```

use super::bytes::Bytes;
use super::counters::Counters;
use super::frame::{Frame, Writer};
use super::kind::Kind;
use super::refusal::Refusal;
use crate::record::Record;

/// Words of a state in one answer, at most.
pub const MOST_READ: usize = 22;

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
        /// Its [`VERSION`](super::message::VERSION).
        version: u8,
        /// What it can do: an [`Offer`](super::offer::Offer) after the other.
        offers: Bytes<'a>,
    },
    /// Where it stands.
    Solution(Standing<'a>),
    /// How many words of a stored state it has.
    Restoring {
        /// From the first on, without a hole.
        words: u16,
    },
    /// A piece of its state.
    State {
        /// Words of the whole state.
        words: u16,
        /// Where the piece begins.
        offset: u16,
        /// Some words of it, eight bytes each, at most [`MOST_READ`].
        piece: Bytes<'a>,
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
            Kind::State => {
                let (words, offset) = (bytes.u16()?, bytes.u16()?);
                Body::State { words, offset, piece: bytes.rest() }
            }
            Kind::Refused => {
                Body::Refused { refusal: Refusal::from_code(bytes.u8()?)?, taken: bytes.u32()? }
            }
            _ => return None,
        };
        bytes.end()?;
        Some(Self { answers, boot, counters, body })
    }
}
