//! From a scene's sensor errors to the core's emulator.

use crate::scene::{Scene, SensorErrors};
use schuler::math::vector::Vector;
use schuler::sensor::Timing;
use schuler::sensor::constant::Constant;
use schuler::sensor::emulator::Emulator;
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

/// The emulator of a scene: every term there or not.
pub type SceneEmulator = Emulator<f64, Triad<f64>, Triad<f64>>;

/// The emulator of a scene.
pub fn build(scene: &Scene) -> Result<SceneEmulator, ParameterError> {
    let timing = Timing::new(1.0 / scene.rate_hz, scene.samples())?;
    Ok(Emulator::new(triad(&scene.gyro, timing)?, triad(&scene.accelerometer, timing)?, timing))
}

fn triad(errors: &SensorErrors, timing: Timing<f64>) -> Result<Triad<f64>, ParameterError> {
    let axes = |axes: &Option<[f64; 3]>| axes.map(Vector::from);
    let gauss_markov = errors
        .gauss_markov
        .map(|process| GaussMarkov::new(process.rms.into(), process.correlation_s.into(), timing));
    Ok(Triad {
        constant: axes(&errors.constant).map(|x| Constant::new(x, timing)).transpose()?,
        turn_on: axes(&errors.turn_on).map(|x| TurnOn::new(x, timing)).transpose()?,
        gauss_markov: gauss_markov.transpose()?,
        white: axes(&errors.white).map(|x| White::new(x, timing)).transpose()?,
        random_walk: axes(&errors.random_walk).map(|x| RandomWalk::new(x, timing)).transpose()?,
        flicker: axes(&errors.bias_instability).map(|x| Flicker::new(x, timing)).transpose()?,
        scale_factor: axes(&errors.scale_factor).map(ScaleFactor::new).transpose()?,
        misalignment: axes(&errors.misalignment).map(Misalignment::new).transpose()?,
        g_sensitivity: axes(&errors.g_sensitivity).map(GSensitivity::new).transpose()?,
        saturation: axes(&errors.saturation).map(|x| Saturation::new(x, timing)).transpose()?,
        quantization: axes(&errors.quantization).map(Quantization::new).transpose()?,
    })
}
