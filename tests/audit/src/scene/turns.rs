//! `tests/golden/turns.toml`.

use super::Scene;
use schuler::sensor::Timing;
use schuler::sensor::constant::Constant;
use schuler::sensor::flicker::Flicker;
use schuler::sensor::g_sensitivity::GSensitivity;
use schuler::sensor::gauss_markov::GaussMarkov;
use schuler::sensor::misalignment::Misalignment;
use schuler::sensor::parameter::ParameterError;
use schuler::sensor::quantization::Quantization;
use schuler::sensor::random_walk::RandomWalk;
use schuler::sensor::saturation::Saturation;
use schuler::sensor::scale_factor::ScaleFactor;
use schuler::sensor::triad::Triad;
use schuler::sensor::turn_on::TurnOn;
use schuler::sensor::white::White;
use schuler::trajectory::harmonic::Channels;
use schuler_scenes::channel::{channel, harmonic};
use schuler_scenes::units::*;

pub const SCENE: Scene = Scene {
    name: "turns",
    duration_s: 12,
    rate_hz: 50,
    channels: Channels {
        roll: channel(4.0, 0.0, &[harmonic(375.0, 7.9, -90.0, DEGREE)], DEGREE),
        pitch: channel(-2.0, 0.0, &[harmonic(28.0, 4.8, -67.0, DEGREE)], DEGREE),
        yaw: channel(17.0, 1.5, &[harmonic(45.0, 7.0, -90.0, DEGREE)], DEGREE),
        latitude: channel(-38.0, 1.8e-3, &[harmonic(6.1e-4, 5.2, -90.0, DEGREE)], DEGREE),
        longitude: channel(
            179.98,
            3.8e-3,
            &[harmonic(7.6e-4, 9.0, -90.0, DEGREE), harmonic(1.1e-6, 0.4, 30.0, DEGREE)],
            DEGREE,
        ),
        altitude: channel(3000.0, 0.0, &[harmonic(50.0, 7.0, -90.0, METRE)], METRE),
    },
    gyro,
    accelerometer,
};

fn gyro(timing: Timing<f64>) -> Result<Triad<f64>, ParameterError> {
    let (rms, correlation_s) = (axes(0.4, 0.2, 0.1, DEGREE_PER_HOUR), axes(5.0, 60.0, 720.0, 1.0));
    let random_walk = all(2.0, DEGREE_PER_HOUR_PER_ROOT_HOUR);
    Ok(Triad {
        constant: Some(Constant::new(axes(0.3, -0.2, 0.1, DEGREE_PER_HOUR), timing)?),
        turn_on: Some(TurnOn::new(all(0.5, DEGREE_PER_HOUR), timing)?),
        gauss_markov: Some(GaussMarkov::new(rms, correlation_s, timing)?),
        white: Some(White::new(all(0.05, DEGREE_PER_ROOT_HOUR), timing)?),
        random_walk: Some(RandomWalk::new(random_walk, timing)?),
        flicker: Some(Flicker::new(all(0.2, DEGREE_PER_HOUR), timing)?),
        scale_factor: Some(ScaleFactor::new(axes(50.0, -30.0, 20.0, PART_PER_MILLION))?),
        misalignment: Some(Misalignment::new(axes(20.0, -10.0, 15.0, ARCSECOND))?),
        g_sensitivity: Some(GSensitivity::new(all(0.1, DEGREE_PER_HOUR_PER_G))?),
        saturation: Some(Saturation::new(axes(280.0, 60.0, 60.0, DEGREE), timing)?),
        quantization: Some(Quantization::new(all(0.2, ARCSECOND))?),
        ..Triad::PERFECT
    })
}

fn accelerometer(timing: Timing<f64>) -> Result<Triad<f64>, ParameterError> {
    let (rms, correlation_s) = (axes(80.0, 40.0, 20.0, MICRO_G), axes(5.0, 60.0, 720.0, 1.0));
    let white = all(0.02, METRE_PER_SECOND_PER_ROOT_HOUR);
    Ok(Triad {
        constant: Some(Constant::new(axes(50.0, -40.0, 30.0, MICRO_G), timing)?),
        turn_on: Some(TurnOn::new(all(60.0, MICRO_G), timing)?),
        gauss_markov: Some(GaussMarkov::new(rms, correlation_s, timing)?),
        white: Some(White::new(white, timing)?),
        random_walk: Some(RandomWalk::new(all(100.0, MICRO_G_PER_ROOT_HOUR), timing)?),
        flicker: Some(Flicker::new(all(25.0, MICRO_G), timing)?),
        scale_factor: Some(ScaleFactor::new(axes(-60.0, 40.0, 20.0, PART_PER_MILLION))?),
        misalignment: Some(Misalignment::new(axes(-12.0, 18.0, 9.0, ARCSECOND))?),
        saturation: Some(Saturation::new(axes(9.0, 9.0, 5.0, STANDARD_GRAVITY), timing)?),
        quantization: Some(Quantization::new(all(1e-4, 1.0))?),
        ..Triad::PERFECT
    })
}
