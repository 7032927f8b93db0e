//! What the samples of a recording support: their differences, in stretches without a gap.
//!
//! The measure is that of [`support`](schuler::strapdown::support); here it goes on over gaps and over
//! rows that were not looked at.

use schuler::sample::Increment;
use schuler::strapdown::fit::MOST_SAMPLES;
use schuler::strapdown::gain::gain_squared;
use schuler::strapdown::plan::Shape;
use schuler::strapdown::support::Differences;
use std::f64::consts::TAU;

/// Windows that a recording may be flown with, the shortest first.
pub const CANDIDATES: [Shape; 3] = [(0, 4, 0), (2, 4, 2), (4, 4, 4)];
/// How much better than a shorter window's a longer one's estimate must be: the estimates are good to that.
const CLEARLY: f64 = 1.2;
/// Of one order to the next, differences fall by at least this where motion is resolved.
const FALLS: f64 = 0.8;

/// Sums of differences.
#[derive(Clone, Debug, Default)]
pub struct Measure {
    run: Differences<f64>,
    /// Σ|∇ᵏ|² over C(2k, k), of gyros and accelerometers.
    sums: [[f64; 2]; MOST_SAMPLES + 1],
    counts: [f64; MOST_SAMPLES + 1],
}

/// What motion looks like in the samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Motion {
    /// Nothing moves, or there are too few samples to tell.
    None,
    /// The fastest that is resolved: samples per cycle.
    Resolved(f64),
    /// What there is is noise, or as fast as this: samples per cycle.
    Unresolved(f64),
}

impl Measure {
    /// Takes the next sample of a stretch.
    pub fn add(&mut self, sample: &Increment<f64>) {
        self.run.add(sample);
    }

    /// The stretch ends: the next sample does not follow the last.
    pub fn cut(&mut self) {
        let run = std::mem::take(&mut self.run);
        for (k, (sum, count)) in self.sums.iter_mut().zip(&mut self.counts).enumerate() {
            if let Some([gyro, accelerometer]) = run.power(k) {
                let there = f64::from(run.count()) - k as f64;
                *sum = [sum[0] + gyro * there, sum[1] + accelerometer * there];
                *count += there;
            }
        }
    }

    /// Mean of |∇ᵏ|² over C(2k, k) of gyros and accelerometers, each against its ∇⁴: their sum.
    fn power(&self, k: usize) -> Option<f64> {
        let mean = |k: usize| {
            let count = *self.counts.get(k)?;
            (count > 0.0).then(|| self.sums[k].map(|sum| sum / count))
        };
        let (power, reference) = (mean(k)?, mean(CANDIDATES[0].1)?);
        let parts = power.iter().zip(reference).filter(|(_, reference)| *reference > 0.0);
        Some(parts.map(|(power, reference)| power / reference).sum())
    }

    /// The window of the least estimated error, a shorter one unless a longer is clearly better.
    pub fn window(&self) -> Option<Shape> {
        let error = |shape: Shape| {
            let power = self.power(shape.0 + shape.1 + shape.2)?;
            Some((gain_squared(shape) * power).sqrt())
        };
        let errors = CANDIDATES.map(error);
        let least = errors.iter().flatten().copied().fold(f64::INFINITY, f64::min);
        let near = |error: &Option<f64>| error.is_some_and(|error| error <= CLEARLY * least);
        let found = errors.iter().position(near).filter(|_| least > 0.0)?;
        CANDIDATES.get(found).copied()
    }

    /// The fastest motion: |∇ᵏ⁺¹|/|∇ᵏ| = 2 sin(x/2) for motion of a phase x per sample.
    pub fn motion(&self) -> Motion {
        let step = |k: usize| -> Option<(f64, f64)> {
            let (before, after) = (self.power(k - 1)?, self.power(k)?);
            // C(2k, k)/C(2k − 2, k − 1) = (4k − 2)/k
            let ratio = (after / before * (4 * k - 2) as f64 / k as f64).sqrt();
            (before > 0.0).then_some(((after / before).sqrt(), ratio))
        };
        let cycle = |ratio: f64| TAU / (2.0 * (0.5 * ratio).min(1.0).asin());
        let steps: Vec<_> = (1..=12).map_while(step).collect();
        let fell = steps.iter().rposition(|(fall, _)| *fall < FALLS);
        match (fell, steps.last()) {
            (_, None) => Motion::None,
            (Some(k), _) => Motion::Resolved(cycle(steps[k].1)),
            (None, Some((_, ratio))) => Motion::Unresolved(cycle(*ratio)),
        }
    }
}
