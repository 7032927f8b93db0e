//! The link's frames: from a stream of bytes, and back into one.

use crate::held::{Keep, held_mut, keep};
use crate::pointer::{bytes, bytes_mut, change, put};
use crate::results::{Code, SCHULER_FRAME, SCHULER_OK, result};
use schuler::link::decoder::Decoder;
use schuler::link::frame::{Header, MOST_ENCODED, encode};
use schuler::link::kind::Kind;

/// Bytes of a payload, at most.
pub const SCHULER_MOST_PAYLOAD: usize = 237;
/// Bytes of a frame on the line, at most.
pub const SCHULER_MOST_ENCODED: usize = 257;

const _: () = assert!(SCHULER_MOST_PAYLOAD == schuler::link::frame::MOST_PAYLOAD);
const _: () = assert!(SCHULER_MOST_ENCODED == MOST_ENCODED);

impl Keep for Decoder {
    const KIND: u32 = 0xf000_0007;
}

/// Collects bytes until a frame is complete. Allocate it anywhere.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct schuler_decoder {
    /// The library's.
    pub opaque: [u64; 37],
}

/// A frame that came through whole.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct schuler_frame {
    /// End of the sample that it is about, ns from the start.
    pub time_ns: u64,
    /// How many frames the sender has sent, this one included.
    pub sequence: u32,
    /// What it is for: a code of the core's `link::kind`.
    pub kind: u32,
    /// Bytes of the payload.
    pub length: u32,
    /// The payload.
    pub payload: [u8; SCHULER_MOST_PAYLOAD],
}

/// Starts with no bytes; `abi` is SCHULER_ABI. Fails with SCHULER_ERROR_NULL, _MISALIGNED or _ABI.
///
/// # Safety
///
/// The pointer is null or leads to what its type says, which nothing else uses meanwhile.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn schuler_decoder_start(decoder: *mut schuler_decoder, abi: u32) -> i32 {
    // SAFETY: as promised.
    result(unsafe { keep(decoder, abi, || Ok(Decoder::default())) })
}

/// Takes the next byte. SCHULER_FRAME, 1: it completes a frame, which is written to `frame`. SCHULER_OK: it does not;
/// a damaged frame counts as none. Fails with SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE;
/// nothing changes then.
///
/// # Safety
///
/// Each pointer is null or leads to what its type says, which nothing else uses meanwhile.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn schuler_decoder_take(
    decoder: *mut schuler_decoder,
    byte: u8,
    frame: *mut schuler_frame,
) -> i32 {
    let taken = (|| {
        // SAFETY: as promised.
        let decoder = unsafe { held_mut::<_, Decoder>(decoder) }?;
        // SAFETY: as promised: any bytes are a frame's numbers.
        let to = unsafe { change(frame) }?;
        let Some(frame) = decoder.take(byte) else { return Ok(SCHULER_OK) };
        let Header { kind, sequence, time_ns } = frame.header;
        let space = to.payload.get_mut(..frame.payload.len()).ok_or(Code::SPACE)?;
        space.copy_from_slice(frame.payload);
        to.length = frame.payload.len() as u32;
        (to.kind, to.sequence, to.time_ns) = (kind.code().into(), sequence, time_ns);
        Ok(SCHULER_FRAME)
    })();
    taken.unwrap_or_else(|Code(code)| code)
}

/// Writes a frame for the line: `kind`, a code of the core's `link::kind`, the sender's number of the frame, a sample's
/// time in ns, and `length` bytes of payload, to the front of `room` bytes; `written` gets how many they are. Fails with
/// SCHULER_ERROR_NULL, _MISALIGNED, _KIND, _PAYLOAD or _SPACE; nothing is written then.
///
/// # Safety
///
/// Each pointer is null or leads to what its type says, `payload` to `length` and `encoded` to `room` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn schuler_encode(
    kind: u32,
    sequence: u32,
    time_ns: u64,
    payload: *const u8,
    length: usize,
    encoded: *mut u8,
    room: usize,
    written: *mut usize,
) -> i32 {
    let write = || {
        // SAFETY: as promised.
        let (payload, room) = unsafe { (bytes(payload, length)?, bytes_mut(encoded, room)?) };
        let kind = u8::try_from(kind).ok().and_then(Kind::from_code).ok_or(Code::KIND)?;
        let mut line = [0; MOST_ENCODED];
        let frame = encode(&Header { kind, sequence, time_ns }, &mut line, |to| to.bytes(payload))?;
        room.get_mut(..frame.len()).ok_or(Code::SPACE)?.copy_from_slice(frame);
        Ok(frame.len())
    };
    // SAFETY: as promised.
    result(unsafe { put(written, write) })
}

/// For the tests.
#[cfg(not(feature = "archive"))]
pub(crate) fn needs(see: &mut dyn FnMut(&str, usize, usize)) {
    see("schuler_decoder", size_of::<schuler_decoder>(), crate::held::size::<Decoder>());
}
