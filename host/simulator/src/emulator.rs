//! From a scene's sensor errors to the core's emulator.

use crate::scene::terms::{Conditions, TERMS};
use crate::scene::{GaussMarkov, Scene, SensorErrors, Temperature};
use schuler::sensor::Timing;
use schuler::sensor::emulator::Emulator;
use schuler::sensor::gauss_markov;
use schuler::sensor::parameter::ParameterError;
use schuler::sensor::temperature::Ramp;
use schuler::sensor::triad::Triad;

/// The emulator of a scene: every term there or not.
pub type SceneEmulator = Emulator<f64, Triad<f64>, Triad<f64>>;

/// The emulator of a scene.
pub fn build(scene: &Scene) -> Result<SceneEmulator, ParameterError> {
    let timing = Timing::new(1.0 / scene.rate_hz, scene.samples())?;
    Ok(Emulator::new(triad(&scene.gyro, timing)?, triad(&scene.accelerometer, timing)?, timing))
}

fn triad(errors: &SensorErrors, timing: Timing<f64>) -> Result<Triad<f64>, ParameterError> {
    let mut triad = Triad::PERFECT;
    let calibrated = Temperature { offset_k: 0.0, rate_k_s: 0.0, until_s: 1.0 };
    let Temperature { offset_k, rate_k_s, until_s } = errors.temperature.unwrap_or(calibrated);
    let conditions = Conditions { timing, ramp: Ramp::new(offset_k, rate_k_s, until_s, timing)? };
    for term in TERMS {
        if let Some(values) = (term.values)(errors) {
            (term.build)(&mut triad, values, &conditions)?;
        }
    }
    if let Some(GaussMarkov { rms, correlation_s }) = errors.gauss_markov {
        let process = gauss_markov::GaussMarkov::new(rms.into(), correlation_s.into(), timing)?;
        triad.gauss_markov = Some(process);
    }
    Ok(triad)
}
