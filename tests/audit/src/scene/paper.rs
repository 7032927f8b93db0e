//! `host/scenes/paper.toml`, its first minute.

use super::units::*;
use super::{Scene, channel, harmonic};
use schuler::sensor::Timing;
use schuler::sensor::constant::Constant;
use schuler::sensor::gauss_markov::GaussMarkov;
use schuler::sensor::parameter::ParameterError;
use schuler::sensor::triad::Triad;
use schuler::sensor::white::White;
use schuler::trajectory::harmonic::Channels;

pub const SCENE: Scene = Scene {
    name: "paper",
    duration_s: 60,
    rate_hz: 20,
    channels: Channels {
        roll: channel(0.0, 0.0, &[harmonic(5.0, 7200.0, 0.0, DEGREE)], DEGREE),
        pitch: channel(0.0, 0.0, &[harmonic(5.0, 7200.0, 0.0, DEGREE)], DEGREE),
        yaw: channel(0.0, 0.0, &[harmonic(5.0, 7200.0, 0.0, DEGREE)], DEGREE),
        latitude: channel(45.0, 0.0, &[harmonic(5.0, 7200.0, 0.0, DEGREE)], DEGREE),
        longitude: channel(100.0, 0.0, &[harmonic(5.0, 7200.0, 0.0, DEGREE)], DEGREE),
        altitude: channel(3500.0, 0.0, &[harmonic(2000.0, 7200.0, 0.0, METRE)], METRE),
    },
    gyro,
    accelerometer,
};

fn gyro(timing: Timing<f64>) -> Result<Triad<f64>, ParameterError> {
    let (rms, correlation_s) = (all(0.1, DEGREE_PER_HOUR), all(720.0, 1.0));
    Ok(Triad {
        constant: Some(Constant::new(all(0.1, DEGREE_PER_HOUR), timing)?),
        gauss_markov: Some(GaussMarkov::new(rms, correlation_s, timing)?),
        white: Some(White::new(all(0.01, DEGREE_PER_ROOT_HOUR), timing)?),
        ..Triad::PERFECT
    })
}

fn accelerometer(timing: Timing<f64>) -> Result<Triad<f64>, ParameterError> {
    let (rms, correlation_s) = (all(100.0, MICRO_G), all(720.0, 1.0));
    Ok(Triad {
        gauss_markov: Some(GaussMarkov::new(rms, correlation_s, timing)?),
        ..Triad::PERFECT
    })
}
