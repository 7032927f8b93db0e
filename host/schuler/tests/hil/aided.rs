//! Aided flights over a line with faults: the bits are those of a flight on the host alone.

use super::{fly, manner, scene};
use schuler::link::decoder::Decoder;
use schuler::link::fleet::Every;
use schuler::link::kind::Kind;
use schuler::link::target::Target;
use schuler_host::hil::Manner;
use schuler_host::hil::channel::{Broken, Channel};
use schuler_host::hil::in_process::InProcess;
use schuler_simulator::flight::Flight;
use schuler_simulator::scene::{Axes, Precision, Scene};
use schuler_simulator::simulate;
use std::time::Duration;

/// A drive whose measurements come late, twice, or not at all for a while.
fn drive(seconds: f64, precision: Precision) -> Scene {
    let mut scene = scene("aided-drive", seconds);
    scene.navigator.precision = precision;
    let line = &mut scene.aiding.gnss.as_mut().expect("a receiver").line;
    (line.latency_s, line.jitter_s) = (0.25, 0.4);
    (line.loss, line.repetition) = (0.1, 0.2);
    *line = line
        .with_outage(schuler::sensor::aiding::line::Outage { from_s: 12.0, until_s: 18.0 })
        .expect("room for an outage");
    scene
}

fn alone(scene: &Scene) -> Flight {
    simulate::fly(scene, false, &mut |_| Ok(()), &|_| ()).expect("a flight")
}

#[track_caller]
fn flies_alike(scene: &Scene, target: InProcess, manner: &Manner) {
    let expected = alone(scene);
    let (flown, ended) = fly(scene, target, manner);
    let flown = flown.unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(flown.digest, expected.digest);
    assert_eq!(flown.last.drift, expected.last.drift);
    assert_eq!(flown.last.sigma, expected.last.sigma);
    let report = flown.aided.expect("a report");
    assert_eq!(Some(&report), expected.aided.as_ref());
    assert!(report.again > 0 && report.sensors[0].accepted > 10, "{report:?}");
    for trace in ended.tally.traces() {
        assert!(trace.is_explained(), "{trace:?} of {:?}", ended.tally);
    }
    let is_faulty = manner.faults.is_some();
    let is_noticed = ended.tally.resent + ended.tally.reboots > 0;
    assert_eq!(is_noticed, is_faulty, "{:?}", ended.tally);
}

#[test]
fn an_aided_flight_on_a_target_has_the_bits_of_the_hosts() {
    flies_alike(&drive(30.0, Precision::F64), InProcess::every(), &Manner::default());
}

#[test]
fn whatever_is_lost_doubled_overtaken_or_damaged_the_bits_stay() {
    for seed in 1..=3 {
        let manner = manner("all=0.02", seed, 20);
        flies_alike(&drive(30.0, Precision::F64), InProcess::every(), &manner);
    }
}

#[test]
fn a_target_without_double_precision_flies_it_too() {
    let manner = manner("all=0.02", 7, 20);
    flies_alike(&drive(30.0, Precision::F32), InProcess::single(), &manner);
}

#[test]
fn in_earth_fixed_axes_with_every_sensor_and_a_horizon() {
    let mut scene = drive(30.0, Precision::F64);
    scene.navigator.frame = Axes::EarthFixed;
    scene.aiding.filter.horizon_s = Some(1.0);
    scene.aiding.filter.lever_arm_m = Some(0.1);
    scene.aiding.filter.latency_s = Some(0.05);
    flies_alike(&scene, InProcess::every(), &manner("all=0.02", 3, 20));
}

#[test]
fn memory_that_is_lost_over_and_over_comes_back_with_the_filter() {
    flies_alike(&drive(30.0, Precision::F64), InProcess::every(), &manner("reboot=0.01", 5, 20));
}

#[test]
fn a_target_of_before_is_told_what_it_lacks() {
    let before = InProcess::new(Box::new(Target::<Every>::new(0)));
    let (flown, _) = fly(&drive(5.0, Precision::F64), before, &Manner::default());
    let text = flown.unwrap_err().to_string();
    assert!(text.contains("does not fly aided f64 local-level taylor 0,4,0"), "{text}");
}

/// A line that changes a bit of every measurement on its way, with the check that belongs to it.
struct Forged(InProcess);

impl Channel for Forged {
    fn send(&mut self, frame: &[u8]) -> Result<(), Broken> {
        let mut decoder = Decoder::default();
        let mut buffer = [0; schuler::link::frame::MOST_ENCODED];
        for &byte in frame {
            let Some(frame) = decoder.take(byte) else { continue };
            if frame.header.kind != Kind::Measure {
                continue;
            }
            let mut payload = frame.payload.to_vec();
            // The lowest bit of the north velocity: word 9, after the number.
            payload[4 + 8 * 9] ^= 1;
            let header = frame.header;
            let forged =
                schuler::link::frame::encode(&header, &mut buffer, |to| to.bytes(&payload));
            return self.0.send(forged.expect("it fits"));
        }
        self.0.send(frame)
    }
    fn receive(&mut self, into: &mut Vec<u8>, patience: Duration) -> Result<(), Broken> {
        self.0.receive(into, patience)
    }
}

#[test]
fn one_bit_of_a_measurement_parts_target_and_twin() {
    let (flown, _) =
        fly(&drive(5.0, Precision::F64), Forged(InProcess::every()), &Manner::default());
    let text = flown.unwrap_err().to_string();
    assert!(text.contains("its twin"), "{text}");
}
