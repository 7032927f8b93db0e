//! A target that is one bit off is found out: which sample, which field, which values.

use crate::{fly, scene};
use schuler::link::decoder::Decoder;
use schuler::link::fleet::Every;
use schuler::link::frame::{MOST_ENCODED, encode};
use schuler::link::message::Kind;
use schuler_host::hil::Manner;
use schuler_host::hil::channel::{Broken, Channel};
use schuler_host::hil::in_process::InProcess;
use schuler_host::scene::Precision;
use schuler_host::simulate::FlightError;
use std::time::Duration;

/// Bytes of a solution's payload before its scalars.
const BEFORE_SOLUTION: usize = 4 + 4 + 4 * 10 + 4 + 4 + 8 + 8;

/// A channel whose target has one bit wrong in one of its solutions, and does not know it.
struct Tampered {
    channel: InProcess<Every>,
    decoder: Decoder,
    solutions: u32,
    /// In which solution, and which bit of its payload.
    at: (u32, usize),
}

impl Channel for Tampered {
    fn send(&mut self, frame: &[u8]) -> Result<(), Broken> {
        self.channel.send(frame)
    }

    fn receive(&mut self, into: &mut Vec<u8>, patience: Duration) -> Result<(), Broken> {
        let mut bytes = Vec::new();
        self.channel.receive(&mut bytes, patience)?;
        for byte in bytes {
            let Some(frame) = self.decoder.take(byte) else { continue };
            let mut payload = frame.payload.to_vec();
            self.solutions += u32::from(frame.header.kind == Kind::Solution);
            let (solution, bit) = self.at;
            if frame.header.kind == Kind::Solution && self.solutions == solution {
                payload[bit / 8] ^= 1 << (bit % 8);
            }
            let mut buffer = [0; MOST_ENCODED];
            let encoded = encode(&frame.header, &mut buffer, |to| to.bytes(&payload));
            into.extend_from_slice(encoded.unwrap());
        }
        Ok(())
    }
}

/// What ends a flight with a target whose payload has a wrong bit after so many samples.
fn found(precision: Precision, sample: u32, byte: usize) -> String {
    let mut scene = scene("paper", 5.0);
    scene.navigator.precision = precision;
    let channel = Tampered {
        channel: InProcess::new(),
        decoder: Decoder::default(),
        solutions: 0,
        // The first solution is that of the start.
        at: (sample + 1, 8 * byte),
    };
    let (flown, _) = fly(&scene, channel, &Manner::default());
    let Err(error @ FlightError::Stopped(_)) = flown else { panic!("{flown:?}") };
    error.to_string()
}

#[test]
fn one_bit_is_named_with_its_sample_field_and_both_values() {
    let text = found(Precision::F64, 7, BEFORE_SOLUTION);
    let begin = "--device: sample 7 at 0.35 s: latitude, rad: the target has 8.7";
    assert!(text.starts_with(begin), "{text}");
    // The last bit of the first double, in hex and in decimal.
    let hex: Vec<u64> = text
        .split("(0x")
        .skip(1)
        .map(|rest| u64::from_str_radix(rest.split(')').next().unwrap(), 16).unwrap())
        .collect();
    assert_eq!(hex[0] ^ hex[1], 1, "{text}");
    let decimal = |after: &str| -> f64 {
        let (_, rest) = text.split_once(after).unwrap();
        rest.split(' ').next().unwrap().parse().unwrap()
    };
    assert_eq!(decimal("has ").to_bits(), hex[0]);
    assert_eq!(decimal("twin ").to_bits(), hex[1]);
}

#[test]
fn every_field_has_its_name() {
    let scalar = |n: usize| BEFORE_SOLUTION + 4 * n;
    for (byte, name) in [
        (BEFORE_SOLUTION - 24, "samples taken"),
        (BEFORE_SOLUTION - 16, "samples integrated"),
        (BEFORE_SOLUTION - 8, "digest of every state"),
        (scalar(1), "latitude, rad (what rounding dropped)"),
        (scalar(4), "altitude, m"),
        (scalar(10), "velocity down, m/s"),
        (scalar(18), "attitude z"),
    ] {
        let text = found(Precision::F32, 30, byte);
        let begin = format!("--device: sample 30 at 1.5 s: {name}: the target has ");
        assert!(text.starts_with(&begin), "{text}");
    }
}
