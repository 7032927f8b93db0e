//! Fit of a long block of slow motion: a straight line or a parabola by least squares.
//!
//! w(σ) = w₀ + w₁σ + w₂σ² over the block's B samples, A = (BᵀB)⁻¹Bᵀ. The columns of B are powers of the
//! sample's number, so A needs only three sums, which running totals give without multiplications:
//! S₁ = Σ Δθⱼ, S₂ = Σ (B − j) Δθⱼ, S₃ = Σ ½(B − j)(B − j + 1) Δθⱼ, j = 0 … B − 1.
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::sample::Increment;
//! use schuler::strapdown::block::least_squares::least_squares;
//!
//! let sample = |x: f64| Increment { angle_b: Vector::new(x, 0.0, 0.0), velocity_b: Vector::ZERO };
//! let block: [_; 8] = core::array::from_fn(|j| sample(1.0 + j as f64));
//! let (fit, sum) = least_squares::<f64, 2>(&block);
//! // 2w₀ is the sum.
//! assert!((2.0 * fit.rate[0].x - sum.angle_b.x).abs() < 1e-12);
//! ```

use super::fit::{Fit, each};
use crate::math::real::Real;
use crate::math::real::Twin as _;
use crate::math::vector::Vector;
use crate::sample::Increment;

/// The fit of a line (K = 2) or a parabola (K = 3) to a block, and the block's sum.
#[inline(always)]
#[expect(
    clippy::indexing_slicing,
    reason = "every index is below the length of its array, a constant"
)]
pub fn least_squares<R: Real, const K: usize>(block: &[Increment<R>]) -> (Fit<R, K>, Increment<R>) {
    const { assert!(K == 2 || K == 3, "a line or a parabola") };
    let mut s1 = [R::Twin::both(R::ZERO); 3];
    let (mut s2, mut s3) = (s1, s1);
    for sample in block {
        s1 = each(s1, sample.twins(), |sum, x| sum + x);
        s2 = each(s2, s1, |sum, x| sum + x);
        if K == 3 {
            s3 = each(s3, s2, |sum, x| sum + x);
        }
    }
    let b = R::count(block.len() as u32);
    let (b1, b2) = (b + R::ONE, b + R::TWO);
    // w₁ = 3B/(2(B² − 1)) · ((B + 1)S₁ − 2S₂)
    let slope = R::Twin::both(R::of(1.5) * b / (b * b - R::ONE));
    let (b1, two) = (R::Twin::both(b1), R::Twin::both(R::TWO));
    let w1 = each(s1, s2, |s1, s2| (s1 * b1 - s2 * two) * slope);
    // w₂ = 15B²/(4(B² − 1)(B − 2)) · ((B + 1)S₁ − 6S₂ + 12/(B + 2) S₃)
    let bend = R::of(3.75) * b * b / ((b * b - R::ONE) * (b - R::TWO));
    let (bend, six) = (R::Twin::both(bend), R::Twin::both(R::of(6.0)));
    let twelfth = R::Twin::both(R::of(12.0) / b2);
    let w2 = each(each(s1, s2, |s1, s2| s1 * b1 - s2 * six), s3, |x, s3| (x + s3 * twelfth) * bend);
    // w₀ = ½S₁ − ⅓w₂: the fit preserves the sum
    let (half, third) = (R::Twin::both(R::HALF), R::Twin::both(R::of(1.0 / 3.0)));
    let w0 = if K == 3 {
        each(s1, w2, |s1, w2| s1 * half - w2 * third)
    } else {
        each(s1, s1, |s1, _| s1 * half)
    };
    let mut fit = Fit { rate: [Vector::ZERO; K], force: [Vector::ZERO; K] };
    for (k, w) in [w0, w1, w2].into_iter().enumerate().take(K) {
        let Increment { angle_b, velocity_b } = Increment::from_twins(w);
        fit.rate[k] = angle_b;
        fit.force[k] = velocity_b;
    }
    (fit, Increment::from_twins(s1))
}
