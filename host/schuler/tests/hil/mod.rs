//! `schuler hil`: a target and its twin in step, with and without faults on the line between them.

mod aided;
mod bits;
mod command;
mod devices;
mod difference;
mod identify;
mod million;
mod sessions;

use schuler_host::hil::channel::Channel;
use schuler_host::hil::faults::Rates;
use schuler_host::hil::lockstep::{Ended, Log};
use schuler_host::hil::{self, Manner};
use schuler_simulator::flight::Flight;
use schuler_simulator::scene::{Scene, builtin};
use schuler_simulator::simulate::FlightError;

/// A built-in scene of some seconds.
fn scene(name: &str, seconds: f64) -> Scene {
    let mut scene = builtin::scene(name).unwrap();
    scene.duration_s = seconds;
    scene
}

/// With faults, by seed.
fn manner(faults: &str, seed: u64, retries: u32) -> Manner {
    Manner { retries, faults: Some((Rates::parse(faults).unwrap(), seed)), ..Manner::default() }
}

/// Flies a scene with a target, and what happened on the link.
fn fly(
    scene: &Scene,
    channel: impl Channel + 'static,
    manner: &Manner,
) -> (Result<Flight, FlightError>, Ended) {
    let log = Log::default();
    let flown = hil::meet(Box::new(channel), manner, "target")
        .and_then(|met| hil::fly(scene, met, manner, &log, &mut |_| Ok(()), &|_| ()));
    let ended = log.lock().unwrap().clone();
    (flown, ended)
}
