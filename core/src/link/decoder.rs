//! Frames from a stream of bytes, any of which may be wrong, missing or surplus.
//!
//! ```
//! use schuler::link::decoder::Decoder;
//! use schuler::link::frame::{Header, MOST_ENCODED, encode};
//! use schuler::link::kind::Kind;
//!
//! let mut line = [0; MOST_ENCODED];
//! let header = Header { kind: Kind::Greet, sequence: 1, time_ns: 0 };
//! let mut bytes = encode(&header, &mut line, |_| ())?.to_vec();
//! // A bit that is wrong costs the frame, and nothing but it.
//! bytes[2] ^= 2;
//! let mut decoder = Decoder::default();
//! assert!(bytes.iter().all(|&byte| decoder.take(byte).is_none()));
//! assert_eq!(decoder.dropped().total(), 1);
//! # Ok::<(), schuler::link::frame::TooLong>(())
//! ```

use super::bytes::Bytes;
use super::counters::{Dropped, count};
use super::frame::{CHECK, CRC, Frame, Header, LEAST_FRAME, MOST_FRAME};
use super::kind::Kind;
use cobs::{DecodeResult, DecoderState};

/// Bytes between two zero bytes at most: a frame with its stuffing byte.
const MOST_STUFFED: usize = MOST_FRAME + 1;

/// Collects bytes until a frame is complete.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Decoder {
    buffer: [u8; MOST_STUFFED],
    /// Bytes since the last zero byte, those beyond the buffer's length included.
    length: usize,
    dropped: Dropped,
}

impl Default for Decoder {
    fn default() -> Self {
        Self { buffer: [0; MOST_STUFFED], length: 0, dropped: Dropped::default() }
    }
}

/// Why the bytes between two zero bytes are no frame.
enum Fault {
    Stuffing,
    Check,
    Short,
    Kind,
}

impl Decoder {
    /// Takes the next byte, and gives the frame that it completes.
    pub fn take(&mut self, byte: u8) -> Option<Frame<'_>> {
        if byte != 0 {
            if let Some(slot) = self.buffer.get_mut(self.length) {
                *slot = byte;
            }
            self.length = self.length.saturating_add(1);
            return None;
        }
        let length = core::mem::take(&mut self.length);
        if length == 0 {
            return None;
        }
        let Some(stuffed) = self.buffer.get_mut(..length) else {
            count(&mut self.dropped.long);
            return None;
        };
        match frame(stuffed) {
            Ok(frame) => Some(frame),
            Err(fault) => {
                let reason = match fault {
                    Fault::Stuffing => &mut self.dropped.stuffing,
                    Fault::Check => &mut self.dropped.check,
                    Fault::Short => &mut self.dropped.short,
                    Fault::Kind => &mut self.dropped.kind,
                };
                count(reason);
                None
            }
        }
    }

    /// The number of frames dropped so far, by reason.
    pub fn dropped(&self) -> Dropped {
        self.dropped
    }

    /// Resets the counts of dropped frames.
    pub fn forget_dropped(&mut self) {
        self.dropped = Dropped::default();
    }
}

fn frame(stuffed: &mut [u8]) -> Result<Frame<'_>, Fault> {
    let length = unstuff(stuffed).ok_or(Fault::Stuffing)?;
    let whole = stuffed.get(..length).ok_or(Fault::Stuffing)?;
    if length < LEAST_FRAME {
        return Err(Fault::Short);
    }
    let (content, check) = whole.split_last_chunk::<CHECK>().ok_or(Fault::Short)?;
    if CRC.checksum(content) != u32::from_le_bytes(*check) {
        return Err(Fault::Check);
    }
    let mut bytes = Bytes(content);
    let (Some(kind), Some(sequence), Some(time_ns)) = (bytes.u8(), bytes.u32(), bytes.u64()) else {
        return Err(Fault::Short);
    };
    let kind = Kind::from_code(kind).ok_or(Fault::Kind)?;
    Ok(Frame { header: Header { kind, sequence, time_ns }, payload: bytes.0 })
}

/// Takes the stuffing out, in place: the length of what it held.
fn unstuff(bytes: &mut [u8]) -> Option<usize> {
    let mut state = DecoderState::default();
    let mut length = 0;
    for index in 0..bytes.len() {
        let byte = *bytes.get(index)?;
        if let DecodeResult::DataContinue(byte) = state.feed(byte).ok()? {
            // Never ahead of what is read: the first byte gives none.
            *bytes.get_mut(length)? = byte;
            length += 1;
        }
    }
    matches!(state.feed(0), Ok(DecodeResult::DataComplete)).then_some(length)
}
