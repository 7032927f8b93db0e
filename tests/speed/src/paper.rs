//! The paper's sensors, as in its built-in scene.

use schuler::sensor::Timing;
use schuler::sensor::constant::Constant;
use schuler::sensor::emulator::Emulator;
use schuler::sensor::gauss_markov::GaussMarkov;
use schuler::sensor::parameter::ParameterError;
use schuler::sensor::triad::Triad;
use schuler::sensor::white::White;
use std::f64::consts::PI;

/// Samples of the whole flight, 20 in a second.
const SAMPLES: u64 = 36_000;
const DEGREE: f64 = PI / 180.0;

/// With every term there or not, as the program's scenes have it.
pub type Sensors = Emulator<f64, Triad<f64>, Triad<f64>>;

/// Gyro drift and Gauss-Markov 0.1 °/h, white noise 0.01 °/√h; accelerometer Gauss-Markov 100 µg; both
/// correlation times 720 s.
pub fn sensors() -> Result<Sensors, ParameterError> {
    let timing = Timing::new(1.0 / 20.0, SAMPLES)?;
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
