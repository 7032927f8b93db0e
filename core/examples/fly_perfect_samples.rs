//! Flies a minute of an analytic trajectory through perfect sensors and compares it with the truth.
//!
//! `cargo run -p schuler --features full --example fly_perfect_samples`

use schuler::drift::compare::drift;
use schuler::imu::Quadrature;
use schuler::prelude::*;
use schuler::trajectory::Trajectory as _;
use schuler::trajectory::harmonic::{Channel, Channels, Harmonic, HarmonicTrajectory};

const RATE_HZ: f64 = 100.0;
const SAMPLES: u64 = 6000;

fn main() -> Result<(), Box<dyn core::error::Error>> {
    // Rolling and pitching by 0.2 rad within some seconds, on a curve to the north-east.
    let roll = [Harmonic { amplitude: 0.2, angular_rate: 1.1, phase: 0.0 }];
    let pitch = [Harmonic { amplitude: 0.2, angular_rate: 0.9, phase: 1.0 }];
    let course = HarmonicTrajectory::<f64, 2>::new(Channels {
        roll: Channel { harmonics: &roll, ..Channel::constant(0.0) },
        pitch: Channel { harmonics: &pitch, ..Channel::constant(0.0) },
        yaw: Channel::steady(0.8, 0.01),
        latitude: Channel::steady(0.8, 3e-5),
        longitude: Channel::steady(0.2, 4e-5),
        altitude: Channel::constant(3000.0),
    })?;
    let perfect = Quadrature::plan(course.bound().bandwidth, 1.0 / RATE_HZ);

    let navigator = Navigator8::<f64>::from_rate_hz(RATE_HZ)?;
    let mut state = navigator.start(&course.at(0.0).initial())?;
    let mut largest_m = 0.0_f64;
    let mut read = |sample: u64, row: Solution<f64>| {
        let truth = course.at(sample as f64 / RATE_HZ).solution();
        largest_m = largest_m.max(drift(&row, &truth).position_ned.norm());
    };
    for number in 1..=SAMPLES {
        let sample = perfect.sample(&course, number, RATE_HZ);
        navigator.push_rows(&mut state, sample, &mut read)?;
    }
    navigator.finish_rows(&mut state, &mut read);

    println!("after {SAMPLES} samples: {}", navigator.readout(&state));
    println!("largest distance from the truth: {largest_m:.1e} m");
    assert!(largest_m < 1e-8);
    Ok(())
}
