//! The paper's flight and sensors, as in its built-in scene.

use schuler::sensor::Timing;
use schuler::sensor::constant::Constant;
use schuler::sensor::emulator::Emulator;
use schuler::sensor::gauss_markov::GaussMarkov;
use schuler::sensor::parameter::ParameterError;
use schuler::sensor::triad::Triad;
use schuler::sensor::white::White;
use schuler::trajectory::harmonic::{
    Channel, Channels, Harmonic, HarmonicTrajectory, TooManyHarmonics,
};
use std::f64::consts::{PI, TAU};

/// Samples per second.
pub const RATE_HZ: f64 = 20.0;
/// Samples of the whole flight.
const SAMPLES: u64 = 36_000;
const DEGREE: f64 = PI / 180.0;

/// With the room for harmonics that the program's scenes have.
pub type Course = HarmonicTrajectory<f64, 64>;
/// With every term there or not, as the program's scenes have it.
pub type Sensors = Emulator<f64, Triad<f64>, Triad<f64>>;

/// The true motion.
pub fn course() -> Result<Course, TooManyHarmonics> {
    let swing = |amplitude| [Harmonic { amplitude, angular_rate: TAU / 7200.0, phase: 0.0 }];
    let (angle, height) = (swing(5.0 * DEGREE), swing(2000.0));
    let about = |offset| Channel { offset, rate: 0.0, harmonics: &angle };
    HarmonicTrajectory::new(Channels {
        roll: about(0.0),
        pitch: about(0.0),
        yaw: about(0.0),
        latitude: about(45.0 * DEGREE),
        longitude: about(100.0 * DEGREE),
        altitude: Channel { offset: 3500.0, rate: 0.0, harmonics: &height },
    })
}

/// Gyro drift and Gauss-Markov 0.1 °/h, white noise 0.01 °/√h; accelerometer Gauss-Markov 100 µg; both
/// correlation times 720 s.
pub fn sensors() -> Result<Sensors, ParameterError> {
    let timing = Timing::new(1.0 / RATE_HZ, SAMPLES)?;
    let each = |value: f64| [value; 3].into();
    let process = |rms| GaussMarkov::new(each(rms), each(720.0), timing);
    let drift = 0.1 * DEGREE / 3600.0;
    let gyro = Triad {
        constant: Some(Constant::new(each(drift), timing)?),
        gauss_markov: Some(process(drift)?),
        white: Some(White::new(each(0.01 * DEGREE / 60.0), timing)?),
        ..Triad::PERFECT
    };
    let accelerometer =
        Triad { gauss_markov: Some(process(100.0 * 9.80665e-6)?), ..Triad::PERFECT };
    Ok(Emulator::new(gyro, accelerometer, timing))
}
