//! The paper's flight and sensors, bit for bit those of the host's built-in scene `paper`.

use schuler::noise::Deviate;
use schuler::sensor::Timing;
use schuler::sensor::emulator::Emulator;
use schuler::sensor::parameter::ParameterError;
use schuler::trajectory::harmonic::{CourseError, HarmonicTrajectory};
use schuler_scenes::paper::{Accelerometer, CHANNELS, Gyro, accelerometer, gyro};

pub use schuler_scenes::paper::{RATE_HZ, SEED};

/// The true motion: one harmonic in each channel.
pub type Course = HarmonicTrajectory<f64, 6>;

/// The true motion.
pub fn course() -> Result<Course, CourseError> {
    HarmonicTrajectory::new(CHANNELS)
}

/// The end of a sample, s.
pub fn time_s(sample: u32) -> f64 {
    f64::from(sample) / RATE_HZ
}

/// The sensors: no term but the paper's.
pub type Sensors<R> = Emulator<R, Gyro<R>, Accelerometer<R>>;

/// The sensors of a run of so many samples.
pub fn sensors<R: Deviate>(samples: u64) -> Result<Sensors<R>, ParameterError> {
    let timing = Timing::new(R::of(1.0 / RATE_HZ), samples)?;
    Ok(Emulator::new(gyro(timing)?, accelerometer(timing)?, timing))
}
