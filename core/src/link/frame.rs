//! Frames: the units that cross the link completely or not at all.
//!
//! | bytes | what |
//! |---|---|
//! | 1 | [`Kind`] |
//! | 4 | sequence number: the sender counts its frames |
//! | 8 | sample time, ns |
//! | n | payload |
//! | 4 | CRC-32 (ISO-HDLC) of all that |
//!
//! stuffed by COBS (no zero byte inside) and set between two zero bytes, so that a byte gone wrong costs
//! one frame, and what it leaves behind ends where the next frame begins.
//!
//! ```
//! use schuler::link::decoder::Decoder;
//! use schuler::link::frame::{Header, MOST_ENCODED, encode};
//! use schuler::link::kind::Kind;
//!
//! let mut line = [0; MOST_ENCODED];
//! let header = Header { kind: Kind::Greet, sequence: 1, time_ns: 0 };
//! let bytes = encode(&header, &mut line, |payload| payload.u8(42))?;
//! let mut decoder = Decoder::default();
//! let mut came = 0;
//! for &byte in bytes {
//!     if let Some(frame) = decoder.take(byte) {
//!         assert_eq!((frame.header.sequence, frame.payload), (1, &[42][..]));
//!         came += 1;
//!     }
//! }
//! assert_eq!(came, 1);
//! # Ok::<(), schuler::link::frame::TooLong>(())
//! ```

use super::kind::Kind;
use crate::math::real::Scalar;
use cobs::CobsEncoder;
use crc::{CRC_32_ISO_HDLC, Crc, Digest, Table};

/// Bytes of a frame before stuffing, at most: one stuffing byte is enough for them.
pub const MOST_FRAME: usize = 254;
/// Bytes of a frame beside its payload.
pub const LEAST_FRAME: usize = 1 + 4 + 8 + CHECK;
/// Bytes of a payload at most.
pub const MOST_PAYLOAD: usize = MOST_FRAME - LEAST_FRAME;
/// Bytes of a frame on the line, at most.
pub const MOST_ENCODED: usize = MOST_FRAME + 3;
/// Bytes of the CRC.
pub(super) const CHECK: usize = 4;

/// A microcontroller has more time than room; a host, the reverse.
#[cfg(feature = "std")]
type Lookup = Table<16>;
#[cfg(not(feature = "std"))]
type Lookup = Table<0>;

pub(super) static CRC: Crc<u32, Lookup> = Crc::<u32, Lookup>::new(&CRC_32_ISO_HDLC);

/// What every frame begins with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Header {
    /// What the payload is.
    pub kind: Kind,
    /// How many frames the sender has sent, this one included.
    pub sequence: u32,
    /// End of the sample that it is about, ns from the start.
    pub time_ns: u64,
}

/// A frame that came through whole.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Frame<'a> {
    /// What it begins with.
    pub header: Header,
    /// What it carries.
    pub payload: &'a [u8],
}

/// A payload longer than [`MOST_PAYLOAD`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TooLong;

impl core::fmt::Display for TooLong {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("the payload is longer than a frame holds")
    }
}

impl core::error::Error for TooLong {}

/// A frame being written: checked and stuffed as it grows.
pub struct Writer<'a> {
    stuffed: CobsEncoder<'a>,
    check: Digest<'static, u32, Lookup>,
    length: usize,
}

#[cfg(feature = "defmt")]
impl defmt::Format for Writer<'_> {
    fn format(&self, to: defmt::Formatter<'_>) {
        defmt::write!(to, "a frame of {} bytes so far", self.length);
    }
}

impl Writer<'_> {
    /// Appends bytes; a frame that grows too long is refused when it is finished.
    pub fn bytes(&mut self, bytes: &[u8]) {
        self.length += bytes.len();
        if self.length <= MOST_FRAME {
            self.check.update(bytes);
            // It cannot be full: there is room for the longest frame.
            let _ = self.stuffed.push(bytes);
        }
    }

    /// One byte.
    pub fn u8(&mut self, x: u8) {
        self.bytes(&[x]);
    }

    /// Two bytes.
    pub fn u16(&mut self, x: u16) {
        self.bytes(&x.to_le_bytes());
    }

    /// Four bytes.
    pub fn u32(&mut self, x: u32) {
        self.bytes(&x.to_le_bytes());
    }

    /// Eight bytes.
    pub fn u64(&mut self, x: u64) {
        self.bytes(&x.to_le_bytes());
    }

    /// Bits of a scalar in as many bytes as it has.
    pub fn bits<R: Scalar>(&mut self, bits: u64) {
        if size_of::<R>() == 4 { self.u32(bits as u32) } else { self.u64(bits) }
    }
}

/// Writes a frame for the line, its payload by `payload`.
///
/// # Errors
///
/// [`TooLong`] if the payload exceeds [`MOST_PAYLOAD`].
pub fn encode<'a>(
    header: &Header,
    buffer: &'a mut [u8; MOST_ENCODED],
    payload: impl FnOnce(&mut Writer),
) -> Result<&'a [u8], TooLong> {
    let [before, stuffed @ ..] = &mut *buffer;
    *before = 0;
    let stuffed = CobsEncoder::new(stuffed);
    let mut writer = Writer { stuffed, check: CRC.digest(), length: CHECK };
    writer.u8(header.kind.code());
    writer.u32(header.sequence);
    writer.u64(header.time_ns);
    payload(&mut writer);
    if writer.length > MOST_FRAME {
        return Err(TooLong);
    }
    let check = writer.check.clone().finalize();
    writer.length -= CHECK;
    writer.u32(check);
    let end = 1 + writer.stuffed.finalize();
    if let Some(after) = buffer.get_mut(end) {
        *after = 0;
    }
    buffer.get(..=end).ok_or(TooLong)
}
