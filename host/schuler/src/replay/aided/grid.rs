//! Samples at times of their own, cut into samples of a constant interval.

use schuler::math::vector::Vector;
use schuler::sample::Increment;
use schuler_simulator::recording::samples::Sample;

/// Cuts samples: what falls into an interval of the grid is added up, a sample that two of them share by its time in
/// each. Nothing is lost. Rate and specific force are constant within a sample for that; what this neglects of coning is
/// of second order in the angle of a single sample.
pub struct Grid {
    origin_s: f64,
    interval_s: f64,
    count: u64,
    reached_s: f64,
    sum: Increment<f64>,
}

impl Grid {
    /// From a time on, s.
    pub fn new(origin_s: f64, interval_s: f64) -> Self {
        let sum = Increment { angle_b: Vector::ZERO, velocity_b: Vector::ZERO };
        Self { origin_s, interval_s, count: 0, reached_s: origin_s, sum }
    }

    /// Takes a sample, and gives those that are complete by its end.
    pub fn cut(&mut self, sample: &Sample) -> Vec<Sample> {
        let mut whole = Vec::new();
        loop {
            let next_s = self.origin_s + (self.count + 1) as f64 * self.interval_s;
            let to_s = next_s.min(sample.end_s);
            let part = (to_s - self.reached_s).max(0.0) / sample.interval_s;
            self.sum.angle_b = self.sum.angle_b + sample.increment.angle_b * part;
            self.sum.velocity_b = self.sum.velocity_b + sample.increment.velocity_b * part;
            self.reached_s = self.reached_s.max(to_s);
            if next_s > sample.end_s {
                return whole;
            }
            self.count += 1;
            whole.push(Sample {
                time_s: next_s,
                end_s: next_s,
                interval_s: self.interval_s,
                increment: self.sum,
                unread: Vec::new(),
                ..*sample
            });
            self.sum = Increment { angle_b: Vector::ZERO, velocity_b: Vector::ZERO };
        }
    }
}
