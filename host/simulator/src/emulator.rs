//! From a scene's sensor errors to the core's emulator.

use crate::scene::terms::TERMS;
use crate::scene::{GaussMarkov, Scene, SensorErrors};
use schuler::sensor::Timing;
use schuler::sensor::emulator::Emulator;
use schuler::sensor::gauss_markov;
use schuler::sensor::parameter::ParameterError;
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
    for term in TERMS {
        if let Some(values) = (term.values)(errors) {
            (term.build)(&mut triad, values.into(), timing)?;
        }
    }
    if let Some(GaussMarkov { rms, correlation_s }) = errors.gauss_markov {
        let process = gauss_markov::GaussMarkov::new(rms.into(), correlation_s.into(), timing)?;
        triad.gauss_markov = Some(process);
    }
    Ok(triad)
}
