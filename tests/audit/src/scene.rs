//! The scenes, as the host makes them from their files: the same conversions in the same order.

pub mod aided;
mod paper;
mod turns;

use schuler::imu::Quadrature;
use schuler::math::compensated::Pair;
use schuler::sensor::Timing;
use schuler::sensor::emulator::Emulator;
use schuler::sensor::parameter::ParameterError;
use schuler::sensor::triad::Triad;
use schuler::trajectory::Trajectory;
use schuler::trajectory::harmonic::{Channels, HarmonicTrajectory};

/// Seed of everything random.
pub const SEED: u64 = 1;
/// Number of the run.
pub const RUN: u64 = 0;
/// Samples of the longest scene.
pub const MOST_SAMPLES: usize = 1200;

/// The motion of a scene.
pub type Course = HarmonicTrajectory<f64, 16>;

/// What is flown.
pub struct Scene {
    /// The stem of its file.
    pub name: &'static str,
    /// Length, s.
    pub duration_s: u32,
    /// Samples per second.
    pub rate_hz: u32,
    /// The true motion.
    channels: Channels<'static, f64>,
    /// What the gyros get wrong.
    gyro: fn(Timing<f64>) -> Result<Triad<f64>, ParameterError>,
    /// What the accelerometers get wrong.
    accelerometer: fn(Timing<f64>) -> Result<Triad<f64>, ParameterError>,
}

/// Those that are flown by inertia alone.
pub const SCENES: [Scene; 2] = [paper::SCENE, turns::SCENE];

impl Scene {
    /// How many samples it has.
    pub fn samples(&self) -> u32 {
        self.duration_s * self.rate_hz
    }

    /// From sample to sample, s, to twice the digits.
    pub fn interval_s(&self) -> Pair<f64> {
        Pair::new(f64::from(self.rate_hz)).reciprocal()
    }

    /// The motion; `None` if it had more harmonics than there is room for.
    pub fn course(&self) -> Option<Course> {
        Course::new(self.channels).ok()
    }

    /// How its rates are integrated.
    pub fn quadrature(&self, course: &Course) -> Quadrature {
        Quadrature::plan(course.bound().bandwidth, 1.0 / f64::from(self.rate_hz))
    }

    /// The sensors.
    pub fn emulator(&self) -> Result<Emulator<f64, Triad<f64>, Triad<f64>>, ParameterError> {
        let timing = Timing::new(1.0 / f64::from(self.rate_hz), self.samples().into())?;
        Ok(Emulator::new((self.gyro)(timing)?, (self.accelerometer)(timing)?, timing))
    }
}
