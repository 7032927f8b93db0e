//! Fit of a window without look-ahead, through as many samples as the motion supports.
//!
//! With t in samples, 0 at the block's end, t = ½B(σ − 1) in the block, the polynomial through the newest P
//! samples is w(σ) = Σ_m ∇ᵐx₀ T_m(σ), T_m = d/dσ [t(t + 1)…(t + m)/(m + 1)!], m < P. Every P from B up to
//! the window's own is a candidate; the one whose estimated error is least (see `support`) is taken, for
//! gyros and accelerometers separately, by leaving out the differences beyond it.
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::sample::Increment;
//! use schuler::strapdown::block::behind::{SEEN, behind, table_f32, table_f64, weights};
//!
//! // Noise alone does not support a longer window than the block of two itself.
//! let mut samples = [Increment::<f64>::ZERO; SEEN];
//! for (n, sample) in samples.iter_mut().enumerate() {
//!     sample.angle_b = Vector::new(if n % 2 == 0 { 1e-6 } else { -1e-6 }, 0.0, 0.0);
//! }
//! let (_, used) = behind::<f64, 4>(&samples, 2, &table_f32(2), &table_f64(2), &weights(2));
//! assert_eq!(used.gyro, 2.0);
//! ```

use super::fit::{Fit, each, narrowed, rounded};
use super::gain::by_history;
use super::newton::Used;
use super::support::central_binomial;
use crate::math::real::Real;
use crate::math::real::Twin as _;
use crate::math::vector::Vector;
use crate::sample::Increment;

/// Samples from which the number to use is estimated.
pub const SEEN: usize = 12;

/// The coefficients of T_m at index m, in double precision.
#[expect(
    clippy::indexing_slicing,
    reason = "the compiler alone evaluates it, and stops at an index out of range"
)]
pub const fn table_f64<const P: usize>(block: usize) -> [[f64; P]; P] {
    // t(t + 1)…(t + m)/(m + 1)! = Π (Bσ + 2i − B)/(2(i + 1)), i = 0 … m
    let mut table = [[0.0; P]; P];
    let (mut product, mut denominator) = ([0_i128; 16], 1_i128);
    product[0] = 1;
    let mut m = 0;
    while m < P {
        let shift = 2 * m as i128 - block as i128;
        let mut k = m + 1;
        while k > 0 {
            product[k] = product[k] * shift + product[k - 1] * block as i128;
            k -= 1;
        }
        product[0] *= shift;
        denominator *= 2 * (m + 1) as i128;
        while k <= m {
            table[m][k] = rounded(product[k + 1] * (k + 1) as i128, denominator);
            k += 1;
        }
        m += 1;
    }
    table
}

/// The same in single precision.
pub const fn table_f32<const P: usize>(block: usize) -> [[f32; P]; P] {
    narrowed(&table_f64::<P>(block))
}

/// The weight of the sum of |∇ᵏx|² over the samples seen in the estimated error of k samples, at index
/// k − B: gain²/((SEEN − k) C(2k, k)).
#[expect(
    clippy::indexing_slicing,
    reason = "the compiler alone evaluates it, and stops at an index out of range"
)]
pub const fn weights<const P: usize>(block: usize) -> [f32; P] {
    let gains = by_history(block, 0);
    let mut weights = [0.0; P];
    let mut history = 0;
    while block + history <= P {
        let k = block + history;
        weights[history] = (gains[history] / ((SEEN - k) as f64 * central_binomial(k))) as f32;
        history += 1;
    }
    weights
}

/// The fit of the newest `block` samples through at most P samples, and the number used.
#[inline(always)]
#[expect(
    clippy::indexing_slicing,
    reason = "every index is below the length of its array, a constant"
)]
pub fn behind<R: Real, const P: usize>(
    seen: &[Increment<R>; SEEN],
    block: usize,
    single: &[[f32; P]; P],
    double: &[[f64; P]; P],
    weights: &[f32; P],
) -> (Fit<R, P>, Used<R>) {
    const { assert!(P < SEEN, "the difference of the longest window's order must be seen") };
    let zero = [R::Twin::both(R::ZERO); 3];
    let mut differences = [zero; SEEN];
    for (difference, sample) in differences.iter_mut().zip(seen) {
        *difference = sample.twins();
    }
    let mut newest = [zero; P];
    let (mut used, mut best) = ([R::count(block as u32); 2], [R::ZERO; 2]);
    for k in 0..=P {
        let there = SEEN - k;
        if k >= block {
            let mut sums = zero;
            for difference in differences.iter().take(there) {
                sums = each(sums, *difference, |sum, x| sum + x * x);
            }
            let [(x, y), (z, forward), (right, down)] = sums.map(|sum| sum.parts());
            let weight = weights[k - block];
            let weight = R::entry(weight, f64::from(weight));
            let errors = [(x + y + z) * weight, (forward + right + down) * weight];
            for ((used, best), error) in used.iter_mut().zip(&mut best).zip(errors) {
                let better = error.less(*best);
                *used = R::select(better, R::count(k as u32), *used);
                *best = if k == block { error } else { R::select(better, error, *best) };
            }
        }
        if k < P {
            newest[k] = differences[there - 1];
            for i in 1..there {
                differences[i - 1] = each(differences[i], differences[i - 1], |a, b| a - b);
            }
        }
    }
    let [gyro, accelerometer] = used;
    for (k, difference) in newest.iter_mut().enumerate().skip(block) {
        let order = R::count(k as u32);
        let [g, a] = used.map(|used| R::select(order.less(used), R::ONE, R::ZERO));
        let keeps = [R::Twin::both(g), R::Twin::new(g, a), R::Twin::both(a)];
        *difference = each(*difference, keeps, |x, keep| x * keep);
    }
    let mut fit = Fit { rate: [Vector::ZERO; P], force: [Vector::ZERO; P] };
    for k in 0..P {
        let mut sum = zero;
        for m in k..P {
            let c = R::Twin::both(R::entry(single[m][k], double[m][k]));
            sum = each(sum, newest[m], |sum, x| sum + x * c);
        }
        let Increment { angle_b, velocity_b } = Increment::from_twins(sum);
        fit.rate[k] = angle_b;
        fit.force[k] = velocity_b;
    }
    (fit, Used { gyro, accelerometer })
}
