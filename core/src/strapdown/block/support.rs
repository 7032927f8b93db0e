//! How long a window the motion supports, measured on the samples themselves.
//!
//! The k-th differences ∇ᵏx of white noise of variance σ² have the variance C(2k, k)σ², and the error of the
//! polynomial through k samples is about their k-th difference. So a window of k samples has an error of about
//! gain · rms(∇ᵏx)/√C(2k, k). This falls with k if the motion is resolved, and is level if it is not resolved or
//! is noise, while the gain of a one-sided window grows. The window with the least estimate is used.
//! The estimate needs no knowledge of the motion and uses only + − × ÷ √, so it is the same on every target.

use super::fit::MOST_SAMPLES;
use super::gain::gain_squared;
use super::shape::WindowShape;
use crate::math::real::Real;
use crate::sample::Increment;

/// Differences of order 0 to 14 of a stream of samples, and their powers, for gyros and accelerometers
/// separately.
///
/// ```
/// # use schuler::strapdown::block::{shape::WindowShape, support::Differences};
/// # use schuler::{math::vector::Vector, sample::Increment};
/// let mut differences = Differences::<f64>::new();
/// for k in 0..100 {
///     // A cone of 2.5 samples per cycle.
///     let phase = core::f64::consts::TAU * k as f64 / 2.5;
///     let angle_b = Vector::new(phase.cos(), phase.sin(), 0.0);
///     differences.add(&Increment { angle_b, velocity_b: Vector::ZERO });
/// }
/// let error = |history, block, lookahead| {
///     let shape = WindowShape::new(history, block, lookahead);
///     f64::sqrt(differences.error_squared(shape).unwrap()[0])
/// };
/// assert!(error(0, 4, 10) > 10.0 * error(0, 4, 0));
/// assert!(error(2, 4, 2) < error(0, 4, 0));
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Differences<R> {
    /// ∇ᵏ at the newest sample.
    newest: [Increment<R>; MOST_SAMPLES + 1],
    /// Σ(∇ᵏ)² axis by axis.
    sums: [Increment<R>; MOST_SAMPLES + 1],
    count: u32,
}

impl<R: Real> Default for Differences<R> {
    fn default() -> Self {
        Self::new()
    }
}

impl<R: Real> Differences<R> {
    /// Without samples.
    pub fn new() -> Self {
        Self {
            newest: [Increment::ZERO; MOST_SAMPLES + 1],
            sums: [Increment::ZERO; MOST_SAMPLES + 1],
            count: 0,
        }
    }

    /// Adds the next sample.
    pub fn add(&mut self, sample: &Increment<R>) {
        let mut difference = *sample;
        for (order, (newest, sum)) in (0..).zip(self.newest.iter_mut().zip(&mut self.sums)) {
            // ∇ᵏ⁺¹ = ∇ᵏ − the sample's before
            let next = Increment {
                angle_b: difference.angle_b - newest.angle_b,
                velocity_b: difference.velocity_b - newest.velocity_b,
            };
            *newest = difference;
            sum.angle_b = sum.angle_b + difference.angle_b.map(|x| x * x);
            sum.velocity_b = sum.velocity_b + difference.velocity_b.map(|x| x * x);
            if order == self.count {
                break;
            }
            difference = next;
        }
        self.count = self.count.saturating_add(1);
    }

    /// The number of samples added.
    pub fn count(&self) -> u32 {
        self.count
    }

    /// ∇ᵏ at the newest sample, at index k; 0 if there are too few samples.
    pub(crate) fn newest(&self) -> &[Increment<R>; MOST_SAMPLES + 1] {
        &self.newest
    }

    /// Mean of |∇ᵏx|² over C(2k, k), of gyros (rad²) and accelerometers (m²/s²); `None` if there are
    /// k samples or fewer, or k exceeds [`MOST_SAMPLES`].
    pub fn power(&self, k: usize) -> Option<[R; 2]> {
        let Increment { angle_b, velocity_b } = self.power_by_axis(k)?;
        Some([angle_b, velocity_b].map(|v| v.x + v.y + v.z))
    }

    /// The same of each axis.
    pub(crate) fn power_by_axis(&self, k: usize) -> Option<Increment<R>> {
        let there = self.count.checked_sub(u32::try_from(k).ok()?).filter(|&there| there > 0)?;
        let sum = self.sums.get(k)?;
        let &of_one = OF_NOISE.get(k)?;
        let of_noise = R::count(there) * R::entry(of_one, f64::from(of_one));
        Some(Increment {
            angle_b: sum.angle_b.map(|sum| sum / of_noise),
            velocity_b: sum.velocity_b.map(|sum| sum / of_noise),
        })
    }

    /// Estimated mean square of the error of the rate that a window fits, per sample, for gyros (rad²) and
    /// accelerometers (m²/s²), over three axes. `None` if there are no more samples than the window has,
    /// if it has no block, or if it has more than [`MOST_SAMPLES`].
    pub fn error_squared(
        &self,
        WindowShape { history, block, lookahead }: WindowShape,
    ) -> Option<[R; 2]> {
        let power = self.power(history + block + lookahead)?;
        let gain = R::of(gain_squared(WindowShape { history, block, lookahead }));
        (block > 0).then(|| power.map(|power| power * gain))
    }
}

/// C(2k, k), up to k = 14, all exact in single precision.
#[expect(
    clippy::indexing_slicing,
    reason = "the compiler alone evaluates it, and stops at an index out of range"
)]
const OF_NOISE: [f32; MOST_SAMPLES + 1] = {
    let mut binomials = [0.0; MOST_SAMPLES + 1];
    let mut k = 0;
    while k <= MOST_SAMPLES {
        binomials[k] = central_binomial(k) as f32;
        assert!(binomials[k] as f64 == central_binomial(k));
        k += 1;
    }
    binomials
};

/// C(2k, k), up to k = 14.
pub(crate) const fn central_binomial(k: usize) -> f64 {
    // C(2k, k) = Π (4i − 2)/i, whose partial products are integers.
    let (mut product, mut i) = (1, 1);
    while i <= k && i <= MOST_SAMPLES {
        product = product * (4 * i as u64 - 2) / i as u64;
        i += 1;
    }
    product as f64
}
