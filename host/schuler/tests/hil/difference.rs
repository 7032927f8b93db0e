//! A target that is one bit off is found out: which sample, which field, which values.

use super::{fly, scene};
use schuler::flight::configuration::{Algorithm, Axes, Configuration, Precision};
use schuler::link::decoder::Decoder;
use schuler::link::frame::{MOST_ENCODED, encode};
use schuler::link::kind::Kind;
use schuler::record::Record;
use schuler::solution::{EarthFixedSolution, Solution};
use schuler_host::hil::Manner;
use schuler_host::hil::channel::{Broken, Channel};
use schuler_host::hil::difference::first;
use schuler_host::hil::in_process::InProcess;
use schuler_simulator::simulate::FlightError;
use schuler_simulator::twin::Standing;
use std::time::Duration;

/// Bytes of a solution's payload before its scalars.
const BEFORE_SOLUTION: usize = 4 + 4 + 4 * 10 + 4 + 4 + 8 + 8;

/// A channel whose target has one bit wrong in one of its solutions, and does not know it.
struct Tampered {
    channel: InProcess,
    decoder: Decoder,
    solutions: u32,
    /// In which solution, and which bit of its payload; none: of the frame's time.
    at: (u32, Option<usize>),
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
            let (mut header, mut payload) = (frame.header, frame.payload.to_vec());
            self.solutions += u32::from(frame.header.kind == Kind::Solution);
            let (solution, bit) = self.at;
            if frame.header.kind == Kind::Solution && self.solutions == solution {
                match bit {
                    Some(bit) => payload[bit / 8] ^= 1 << (bit % 8),
                    None => header.time_ns ^= 1,
                }
            }
            let mut buffer = [0; MOST_ENCODED];
            let encoded = encode(&header, &mut buffer, |to| to.bytes(&payload));
            into.extend_from_slice(encoded.unwrap());
        }
        Ok(())
    }
}

/// What ends a flight with a target whose payload has a wrong bit after so many samples.
fn found(precision: Precision, sample: u32, byte: Option<usize>) -> String {
    let mut scene = scene("paper", 5.0);
    scene.navigator.precision = precision;
    let channel = Tampered {
        channel: InProcess::every(),
        decoder: Decoder::default(),
        solutions: 0,
        // The first solution is that of the start.
        at: (sample + 1, byte.map(|byte| 8 * byte)),
    };
    let (flown, _) = fly(&scene, channel, &Manner::default());
    let Err(error @ FlightError::Stopped(_)) = flown else { panic!("{flown:?}") };
    error.to_string()
}

#[test]
fn one_bit_is_named_with_its_sample_field_and_both_values() {
    let text = found(Precision::F64, 7, Some(BEFORE_SOLUTION));
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
fn what_is_no_scalar_has_its_name_too() {
    for (byte, name) in [
        (None, "end of a sample, ns"),
        (Some(BEFORE_SOLUTION - 24), "samples taken"),
        (Some(BEFORE_SOLUTION - 20), "which samples came"),
        (Some(BEFORE_SOLUTION - 16), "samples integrated"),
        (Some(BEFORE_SOLUTION - 8), "digest of every state"),
    ] {
        let text = found(Precision::F32, 30, byte);
        let begin = format!("--device: sample 30 at 1.5 s: {name}: the target has ");
        assert!(text.starts_with(&begin), "{text}");
    }
}

/// What a difference in a solution is called: one field changed in one of two.
fn named<S: Record + Clone>(axes: Axes, zero: &S, change: impl FnOnce(&mut S)) -> String {
    let configuration = Configuration {
        precision: Precision::F64,
        axes,
        algorithm: Algorithm::Textbook,
        window: Configuration::ONE_SAMPLE,
    };
    let standing = |solution: S| {
        let mut bytes = Vec::new();
        solution.record("", &mut |_, bits| bytes.extend(bits.to_le_bytes()));
        Standing { solution: bytes, ..Standing::default() }
    };
    let mut other = zero.clone();
    change(&mut other);
    let (name, ..) =
        first(&configuration, &standing(other), &standing(zero.clone())).expect("a difference");
    name
}

#[test]
fn every_scalar_has_the_name_of_its_field() {
    macro_rules! check {
        ($axes:ident $zero:expr; $($($field:ident).+ = $name:literal;)+) => {$(
            let (zero, axes) = ($zero, Axes::$axes);
            assert_eq!(named(axes, &zero, |s| s.$($field).+.hi = 1.0), $name);
            let low = concat!($name, " (what rounding dropped)");
            assert_eq!(named(axes, &zero, |s| s.$($field).+.lo = 1.0), low);
        )+};
    }
    check! {
        LocalLevel Solution::<f64>::default();
        position.latitude = "latitude, rad";
        position.longitude = "longitude, rad";
        position.altitude = "altitude, m";
        velocity_ned.x = "velocity north, m/s";
        velocity_ned.y = "velocity east, m/s";
        velocity_ned.z = "velocity down, m/s";
        attitude.w = "attitude w";
        attitude.v.x = "attitude x";
        attitude.v.y = "attitude y";
        attitude.v.z = "attitude z";
    }
    check! {
        EarthFixed EarthFixedSolution::<f64>::default();
        position_e.x = "position x, m";
        position_e.y = "position y, m";
        position_e.z = "position z, m";
        velocity_e.x = "velocity x, m/s";
        velocity_e.y = "velocity y, m/s";
        velocity_e.z = "velocity z, m/s";
        attitude.w = "attitude w";
        attitude.v.x = "attitude x";
        attitude.v.y = "attitude y";
        attitude.v.z = "attitude z";
    }
}
