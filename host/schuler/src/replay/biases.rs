//! Biases that a fine alignment has found, taken off the samples that follow.

use schuler::aiding::alignment::aligned::Aligned;
use schuler::math::vector::Vector;
use schuler::sample::Increment;
use schuler_simulator::recording::samples::Sample;

/// Biases that an alignment has found: rad/s, m/s².
#[derive(Clone, Copy, Debug, Default)]
pub struct Biases {
    rate_b: Vector<f64>,
    force_b: Vector<f64>,
}

impl Biases {
    /// Those of an alignment.
    pub fn of(aligned: &Aligned<f64>) -> Self {
        Self { rate_b: aligned.gyro_bias[0], force_b: aligned.accelerometer_bias[0] }
    }

    /// A sample without them.
    pub fn taken_off(&self, sample: &Sample) -> Increment<f64> {
        let Increment { angle_b, velocity_b } = sample.increment;
        Increment {
            angle_b: angle_b - self.rate_b * sample.interval_s,
            velocity_b: velocity_b - self.force_b * sample.interval_s,
        }
    }
}
