//! Any bytes through the decoder: a frame that it accepts is one that an encoder writes, and every piece
//! between two zero bytes is a frame or is counted.
//!
//! `cargo +nightly fuzz run --fuzz-dir tests/fuzz decoder`, and `target` in its place, run until something
//! is found; `-- -max_total_time=60` after it ends them.

#![no_main]

use libfuzzer_sys::fuzz_target;
use schuler::link::decoder::Decoder;
use schuler::link::frame::{Frame, MOST_ENCODED, encode};

/// What an encoder makes of a frame's content, without the zero bytes about it.
fn encoded(frame: &Frame) -> Vec<u8> {
    let mut buffer = [0; MOST_ENCODED];
    let bytes = encode(&frame.header, &mut buffer, |to| to.bytes(frame.payload));
    let bytes = bytes.expect("what came in a frame fits into one");
    bytes[1..bytes.len() - 1].to_vec()
}

fuzz_target!(|bytes: &[u8]| {
    let mut decoder = Decoder::default();
    let (mut piece, mut frames, mut pieces) = (Vec::new(), 0, 0);
    for &byte in bytes {
        if let Some(frame) = decoder.take(byte) {
            frames += 1;
            assert_eq!(encoded(&frame), piece);
        }
        if byte == 0 {
            pieces += u32::from(!piece.is_empty());
            piece.clear();
        } else {
            piece.push(byte);
        }
    }
    assert_eq!(frames + decoder.dropped().total(), pieces);
});
