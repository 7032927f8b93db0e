//! The paper's sensors.

use schuler::sensor::Timing;
use schuler::sensor::emulator::Emulator;
use schuler::sensor::parameter::ParameterError;
use schuler::sensor::triad::Triad;
use schuler_scenes::paper::{RATE_HZ, SAMPLES, accelerometer, gyro};

/// With every term there or not, as the program's scenes have it.
pub type Sensors = Emulator<f64, Triad<f64>, Triad<f64>>;

/// Those of the whole flight.
pub fn sensors() -> Result<Sensors, ParameterError> {
    let timing = Timing::new(1.0 / RATE_HZ, SAMPLES)?;
    Ok(Emulator::new(gyro(timing)?.into(), accelerometer(timing)?.into(), timing))
}
