//! A navigator that begins later than its samples do, with biases that are known then.

use super::{Navigate, Reader};
use crate::flight::Edges;
use crate::lanes::abreast::Refused;
use schuler::sample::Increment;
use schuler::solution::Solution;
use schuler::strapdown::correction::{Correction, CorrectionError};
use schuler::strapdown::limits::Rejected;

/// A navigator with what an alignment left it.
pub struct Begun {
    /// What navigates.
    pub navigator: Box<dyn Navigate>,
    /// Samples before its first one.
    pub before: u64,
    /// What the biases add to a sample of the nominal interval.
    pub bias: Increment<f64>,
    /// That interval, s.
    pub interval_s: f64,
}

impl Begun {
    fn without(&self, sample: &Increment<f64>, interval_s: f64) -> Increment<f64> {
        let share = interval_s / self.interval_s;
        Increment {
            angle_b: sample.angle_b - self.bias.angle_b * share,
            velocity_b: sample.velocity_b - self.bias.velocity_b * share,
        }
    }
}

impl Navigate for Begun {
    fn push(&mut self, sample: &Increment<f64>, read: &mut Reader) -> Result<(), Rejected> {
        let sample = self.without(sample, self.interval_s);
        let before = self.before;
        self.navigator.push(&sample, &mut |n, row| read(n + before, row))
    }

    fn push_over(
        &mut self,
        sample: &Increment<f64>,
        interval_s: f64,
        read: &mut Reader,
    ) -> Result<(), Rejected> {
        let sample = self.without(sample, interval_s);
        let before = self.before;
        self.navigator.push_over(&sample, interval_s, &mut |n, row| read(n + before, row))
    }

    fn fly(&mut self, samples: &[Increment<f64>]) -> Result<(), Refused> {
        let samples: Vec<_> = samples.iter().map(|x| self.without(x, self.interval_s)).collect();
        self.navigator.fly(&samples)
    }

    fn solution(&self) -> Solution<f64> {
        self.navigator.solution()
    }

    fn finish(&mut self, read: &mut Reader) {
        let before = self.before;
        self.navigator.finish(&mut |n, row| read(n + before, row));
    }

    fn hold_vertical(&mut self, altitude_m: f64, down_m_s: f64) -> Result<(), Rejected> {
        self.navigator.hold_vertical(altitude_m, down_m_s)
    }

    fn correct(&mut self, correction: &Correction<f64>) -> Result<(), CorrectionError> {
        self.navigator.correct(correction)
    }

    fn integrated(&self) -> u64 {
        self.before + self.navigator.integrated()
    }

    fn edges(&self) -> Option<Edges> {
        self.navigator.edges()
    }

    fn digest(&self) -> u64 {
        self.navigator.digest()
    }

    fn fly_unread(
        &self,
        before: &[Increment<f64>],
        samples: &[Increment<f64>],
    ) -> Box<dyn FnMut() + '_> {
        self.navigator.fly_unread(before, samples)
    }
}
