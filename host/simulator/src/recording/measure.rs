//! The window that the samples of a recording support, from their differences in stretches without a gap.
//!
//! The measure is that of [`support`](schuler::strapdown::block::support), continued over gaps and over
//! rows that were not examined.

use crate::scene::WindowShape;
use schuler::sample::Increment;
use schuler::strapdown::block::fit::MOST_SAMPLES;
use schuler::strapdown::block::gain::gain_squared;
use schuler::strapdown::block::support::Differences;
use std::f64::consts::TAU;

/// Windows that a recording may be flown with, the shortest first.
pub const CANDIDATES: [WindowShape; 3] =
    [WindowShape::new(0, 4, 0), WindowShape::new(2, 4, 2), WindowShape::new(4, 4, 4)];
/// How much better than a shorter window's a longer one's estimate must be.
const CLEARLY: f64 = 1.1;
/// Changes from sample to sample below this part of the samples themselves are the rounding of numbers.
const ROUNDING: f64 = 1e-9;
/// How far above that of noise a mean |∇ᵏ|²/C(2k, k) must be to tell of motion.
const STANDS_OUT: f64 = 10.0;
/// White noise has the same mean |∇ᵏ|²/C(2k, k) in every order, up to chance.
const LIKE_NOISE: f64 = 0.07;
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
    /// What there is looks like white noise.
    Noise,
    /// What there is is faster than any window resolves: samples per cycle.
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

    /// Mean of |∇ᵏ|² over C(2k, k), of gyros and of accelerometers.
    fn mean(&self, k: usize) -> Option<[f64; 2]> {
        let count = *self.counts.get(k)?;
        (count > 0.0).then(|| self.sums[k].map(|sum| sum / count))
    }

    /// The same of both together, each against its ∇⁴; zero where nothing moves.
    fn power(&self, k: usize) -> Option<f64> {
        let [itself, change] = [self.mean(0)?, self.mean(1)?];
        let parts = self.mean(k)?.into_iter().zip(self.mean(CANDIDATES[0].block)?).enumerate();
        let moves = |i: usize| change[i] > ROUNDING * ROUNDING * itself[i];
        let parts = parts.filter(|(i, (_, reference))| moves(*i) && *reference > 0.0);
        Some(parts.map(|(_, (power, reference))| power / reference).sum())
    }

    /// The window of the least estimated error, a shorter one unless a longer is clearly better; none where
    /// nothing moves.
    pub fn window(&self) -> Option<WindowShape> {
        let error = |shape: WindowShape| {
            let power = self.power(shape.samples())?;
            Some((gain_squared(shape) * power).sqrt())
        };
        let errors = CANDIDATES.map(error);
        let least = errors.iter().flatten().copied().fold(f64::INFINITY, f64::min);
        let near = |error: &Option<f64>| error.is_some_and(|error| error <= CLEARLY * least);
        let found = errors.iter().position(near).filter(|_| least > 0.0)?;
        CANDIDATES.get(found).copied()
    }

    /// The fastest motion: |∇ᵏ⁺¹|/|∇ᵏ| = 2 sin(x/2) for motion of a phase x per sample. Samples themselves
    /// (k = 0) have a mean, which is no motion.
    pub fn motion(&self) -> Motion {
        let last = |k: usize| self.power(MOST_SAMPLES - k).unwrap_or(0.0);
        // Where the differences end flat, that is noise.
        let floor = if last(0) > FALLS * FALLS * last(1) { last(0) } else { 0.0 };
        // How much less than noise's the next difference is, and the ratio itself without the noise.
        let step = |k: usize| -> Option<(f64, f64)> {
            let (before, after) = (self.power(k - 1)?, self.power(k)?);
            let stands_out = after > STANDS_OUT * floor;
            let noise = if stands_out { floor } else { 0.0 };
            let fall = ((after - noise) / (before - noise)).sqrt();
            let resolved = if stands_out { fall } else { 1.0 };
            // C(2k, k)/C(2k − 2, k − 1) = (4k − 2)/k
            (before > 0.0).then(|| (resolved, fall * ((4 * k - 2) as f64 / k as f64).sqrt()))
        };
        let cycle = |ratio: f64| TAU / (2.0 * (0.5 * ratio).min(1.0).asin());
        let steps: Vec<_> = (2..=12).map_while(step).collect();
        let fell = steps.iter().rposition(|(fall, _)| *fall < FALLS);
        let powers: Vec<_> = (1..=12).map_while(|k| self.power(k)).collect();
        let noise = || powers.windows(2).all(|p| ((p[1] / p[0]).sqrt() - 1.0).abs() < LIKE_NOISE);
        match (fell, steps.last()) {
            (_, None) => Motion::None,
            (Some(k), _) => Motion::Resolved(cycle(steps[k].1)),
            _ if noise() => Motion::Noise,
            (None, Some((_, ratio))) => Motion::Unresolved(cycle(*ratio)),
        }
    }
}
