//! Stands still with a gyro of 1 °/h of bias and noise, and compares the drift with what the bias explains.
//!
//! `cargo run -p schuler --features full --example emulate_a_sensor`

use core::f64::consts::PI;
use schuler::earth::{gravity, rotation_ned};
use schuler::math::real::Real;
use schuler::prelude::*;
use schuler::sensor::Timing;
use schuler::sensor::constant::Constant;
use schuler::sensor::emulator::Emulator;
use schuler::sensor::white::White;

const RATE_HZ: f64 = 50.0;
const SAMPLES: u64 = 50 * 600;
const DEGREE: f64 = PI / 180.0;

fn main() -> Result<(), Box<dyn core::error::Error>> {
    // One bias about east, 1 °/h; an angle random walk of 0.01 °/√h on every axis.
    let timing = Timing::new(1.0 / RATE_HZ, SAMPLES)?;
    let bias = Constant::new(Vector::new(0.0, DEGREE / 3600.0, 0.0), timing)?;
    let walk = 0.01 * DEGREE / 60.0;
    let noise = White::new(Vector::new(walk, walk, walk), timing)?;
    let unit = Emulator::new((bias, noise), (), timing);

    // At rest, level, heading north: the Earth's rate and the reaction to gravity.
    let place = Geodetic { latitude: PI / 4.0, longitude: 0.0, altitude: 0.0 };
    let (sine, cosine) = Real::sin_cos(place.latitude);
    let at_rest = Rates {
        rate_ib_b: rotation_ned(sine, cosine),
        specific_force_b: Vector::new(0.0, 0.0, -gravity(sine, 0.0)),
    };
    let perfect = Increment::from_mean_rates(&at_rest, Pair::new(RATE_HZ).reciprocal());

    let navigator = Navigator4::<f64>::from_rate_hz(RATE_HZ)?;
    let level = Euler { roll: 0.0, pitch: 0.0, yaw: 0.0 };
    let start = Solution::new(place, Vector::ZERO, level);
    let (mut state, mut sensors) = (navigator.start(&start)?, unit.start(1, 0));
    for _ in 0..SAMPLES {
        navigator.push(&mut state, unit.emulate(&mut sensors, &perfect))?;
    }

    // v_N = b R(1 − cos ω_s t), with ω_s = √(g/R): Schuler's oscillation. A bias about east tilts the nose
    // up, and the accelerometer then feels gravity forwards.
    let seconds = SAMPLES as f64 / RATE_HZ;
    let radius = 6.37e6;
    let schuler_rate = (gravity(sine, 0.0) / radius).sqrt();
    let expected = DEGREE / 3600.0 * radius * (1.0 - Real::sin_cos(schuler_rate * seconds).1);
    let north = navigator.readout(&state).velocity_ned_m_s.x;
    println!("after {seconds} s: {}", navigator.readout(&state));
    println!("velocity north {north:.2} m/s; the bias alone explains {expected:.2} m/s");
    assert!((north.abs() - expected).abs() < 0.1 * expected);
    Ok(())
}
