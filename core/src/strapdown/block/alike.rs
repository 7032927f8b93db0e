//! A correction that makes all samples count alike, so that blocks do not repeat an error.
//!
//! A block of B samples always meets a motion of k/B cycles per sample in the same phase, and likewise two
//! motions whose frequencies add up to that. The errors of its polynomials then accumulate instead of averaging
//! out: a cone of 4 samples per cycle leaves a tilt, and so does a cone of 6 with its own second harmonic. If
//! every sample were fitted in the same way, this would happen only at k cycles per sample. So each block corrects
//! the four samples about its start, −2 ≤ t ≤ 2 in samples, as if each had the polynomial through the P + 1 samples
//! centred on it. With F_m the integral of the polynomial through the P samples from m on (0 is the first of the
//! block) and ∇ᴾx_m over the samples m to m + P,
//!
//!   F_{m+1} − F_m = ∇ᴾx_m Π_{i=1…P}(t − m − i)/P!        as both agree at the edges m + 1 … m + P, and
//!   F − F_m = ∇ᴾx_m Π_{i=0…P}(t − m − i)/(P + 1)!         for F through one sample more, m = j − P/2.
//!
//! Their sum from F_{−H−B} (j < 0) or F_{−H} (j ≥ 0) on is χ, the error of the angle within sample j. It is
//! 0 at the edges, so to first order the block before and this one lack
//!
//!   δθ = ∫χ_θ × ω dt,  δv = ∫(χ_θ × f + χ_v × ω) dt,
//!
//! ω and f by the cubic through the four samples' increments. With k ≥ 0 alone, in sums x_k + x_{−1−k} and
//! differences x_k − x_{−1−k}, that is
//!
//!   S₀ × (difference 0) + S₁ × (difference 1) + D₀ × (sum 0) + D₁ × (sum 1),
//!
//! S_i a linear function of all sums, D_i of all differences. In smooth motion the correction is of the order of
//! the fit's own error, which it reduces.
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::sample::Increment;
//! use schuler::strapdown::block::alike::{Weights, lacking, weights_f32, weights_f64};
//!
//! const SINGLE: &Weights<f32, 6> = &weights_f32();
//! const DOUBLE: &Weights<f64, 6> = &weights_f64();
//! // A polynomial fits a steady rotation exactly: the blocks lack nothing.
//! let steady = Increment { angle_b: Vector::new(0.01, 0.02, 0.0), velocity_b: Vector::ZERO };
//! let lacking = lacking::<f64, 12, 6>(&[steady; 12], SINGLE, DOUBLE);
//! assert!(lacking.angle_b.norm() < 1e-18);
//! ```

use super::fit::{each, rounded};
use crate::math::real::Real;
use crate::math::real::Twin as _;
use crate::sample::Increment;

/// Samples of a block; as many samples before its window are used.
pub const BLOCK: usize = 4;
/// Samples on either side of the block's start that are corrected.
const SIDE: usize = BLOCK / 2;
/// Room for the coefficients of a polynomial: that of degree P + 1 times a cubic.
const ROOM: usize = 18;
/// The least common multiple of 1 … 17.
const MULTIPLE: i128 = 12_252_240;

/// The weights of the sums and differences of M pairs of opposite samples.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Weights<T, const M: usize> {
    /// In S₀ and S₁.
    sums: [[T; M]; SIDE],
    /// In D₀ and D₁.
    differences: [[T; M]; SIDE],
}

/// The weights for the window of P = 2M − B samples.
#[expect(
    clippy::indexing_slicing,
    reason = "the compiler alone evaluates it, and stops at an index out of range"
)]
pub const fn weights_f64<const M: usize>() -> Weights<f64, M> {
    let (table, denominator) = table::<M>();
    let mut weights = Weights { sums: [[0.0; M]; SIDE], differences: [[0.0; M]; SIDE] };
    let mut i = 0;
    while i < SIDE {
        let mut k = 0;
        while k < M {
            let (after, before) = (table[i][M + k], table[i][M - 1 - k]);
            weights.sums[i][k] = rounded(after + before, 2 * denominator);
            weights.differences[i][k] = rounded(after - before, 2 * denominator);
            k += 1;
        }
        i += 1;
    }
    weights
}

/// The same in single precision.
#[expect(
    clippy::indexing_slicing,
    reason = "the compiler alone evaluates it, and stops at an index out of range"
)]
pub const fn weights_f32<const M: usize>() -> Weights<f32, M> {
    let double = weights_f64::<M>();
    let mut weights = Weights { sums: [[0.0; M]; SIDE], differences: [[0.0; M]; SIDE] };
    let mut i = 0;
    while i < SIDE {
        let mut k = 0;
        while k < M {
            weights.sums[i][k] = double.sums[i][k] as f32;
            weights.differences[i][k] = double.differences[i][k] as f32;
            k += 1;
        }
        i += 1;
    }
    weights
}

/// The weight of sample k − M in X_i = ∫χ ℓ_i dt, ℓ_i the cubic with the increment 1 over sample i and 0
/// over the other three.
#[expect(
    clippy::indexing_slicing,
    reason = "the compiler alone evaluates it, and stops at an index out of range"
)]
const fn table<const M: usize>() -> ([[i128; 2 * ROOM]; SIDE], i128) {
    let p = 2 * M - BLOCK;
    let half = (p / 2) as i128;
    let mut table = [[0; 2 * ROOM]; SIDE];
    let mut factorial = 1;
    let mut n = 1;
    while n <= p + 1 {
        factorial *= n as i128;
        n += 1;
    }
    let mut i = 0;
    while i < SIDE {
        let cubic = cubic(i as i128);
        let mut j = -(SIDE as i128);
        while j < SIDE as i128 {
            // The polynomial of sample j begins H samples before its block.
            let begun = if j < 0 { -(M as i128) } else { BLOCK as i128 - M as i128 };
            let mut m = begun;
            while m != j - half {
                let (step, sign) = if m < j - half { (1, 1) } else { (-1, -1) };
                let lower = if step > 0 { m } else { m - 1 };
                let product = multiplied(&cubic, lower + 1, p);
                let share = sign * (p as i128 + 1) * integral(&product, j);
                difference(&mut table[i], M, lower, p, share);
                m += step;
            }
            let product = multiplied(&cubic, j - half, p + 1);
            difference(&mut table[i], M, j - half, p, integral(&product, j));
            j += 1;
        }
        i += 1;
    }
    // The denominators of the cubic, the products and the integrals.
    (table, 24 * factorial * MULTIPLE)
}

/// Adds a share of ∇ᴾx_m = Σ (−1)ᴾ⁻ᵏ C(P, k) x_{m+k}, P even.
#[expect(
    clippy::indexing_slicing,
    reason = "the compiler alone evaluates it, and stops at an index out of range"
)]
const fn difference(row: &mut [i128; 2 * ROOM], pairs: usize, m: i128, p: usize, share: i128) {
    let mut binomial = share;
    let mut k = 0;
    while k <= p {
        row[(m + pairs as i128) as usize + k] += binomial;
        binomial = -(binomial * (p - k) as i128) / (k as i128 + 1);
        k += 1;
    }
}

/// 24 ℓ_i: the slope of Σ_{m>i} Π_{n≠m}(t − n)/(m − n), n = −2 … 2.
#[expect(
    clippy::indexing_slicing,
    reason = "the compiler alone evaluates it, and stops at an index out of range"
)]
const fn cubic(i: i128) -> [i128; ROOM] {
    let mut slope = [0; ROOM];
    let mut m = i + 1;
    while m <= SIDE as i128 {
        let mut lagrange = [0; ROOM];
        lagrange[0] = 24;
        let (mut n, mut below) = (-(SIDE as i128), 1);
        while n <= SIDE as i128 {
            if n != m {
                lagrange = times(&lagrange, n);
                below *= m - n;
            }
            n += 1;
        }
        let mut k = 0;
        while k < BLOCK {
            slope[k] += lagrange[k + 1] * (k as i128 + 1) / below;
            k += 1;
        }
        m += 1;
    }
    slope
}

/// A polynomial times t − n.
#[expect(
    clippy::indexing_slicing,
    reason = "the compiler alone evaluates it, and stops at an index out of range"
)]
const fn times(polynomial: &[i128; ROOM], n: i128) -> [i128; ROOM] {
    let mut product = [0; ROOM];
    product[0] = -n * polynomial[0];
    let mut k = 1;
    while k < ROOM {
        product[k] = polynomial[k - 1] - n * polynomial[k];
        k += 1;
    }
    product
}

/// A polynomial times Π(t − n) over `count` values of n from the first on.
const fn multiplied(polynomial: &[i128; ROOM], first: i128, count: usize) -> [i128; ROOM] {
    let mut product = *polynomial;
    let mut n = 0;
    while n < count {
        product = times(&product, first + n as i128);
        n += 1;
    }
    product
}

/// The integral from j to j + 1, times the multiple.
#[expect(
    clippy::indexing_slicing,
    reason = "the compiler alone evaluates it, and stops at an index out of range"
)]
const fn integral(polynomial: &[i128; ROOM], j: i128) -> i128 {
    let (mut below, mut above, mut sum) = (j, j + 1, 0);
    let mut k = 0;
    while k < ROOM - 1 {
        sum += polynomial[k] * (above - below) * (MULTIPLE / (k as i128 + 1));
        below *= j;
        above *= j + 1;
        k += 1;
    }
    sum
}

/// δθ and δv, from the window's samples and as many samples before it as a block has.
#[inline(always)]
#[expect(
    clippy::indexing_slicing,
    reason = "every index is below the length of its array, a constant"
)]
pub fn lacking<R: Real, const N: usize, const M: usize>(
    samples: &[Increment<R>; N],
    single: &Weights<f32, M>,
    double: &Weights<f64, M>,
) -> Increment<R> {
    const { assert!(N == 2 * M && M >= SIDE) };
    let pair = |k: usize| {
        let (after, before) = (samples[M + k].twins(), samples[M - 1 - k].twins());
        [each(after, before, |a, b| a + b), each(after, before, |a, b| a - b)]
    };
    let weight = |single: f32, double: f64| R::Twin::both(R::entry(single, double));
    let none = [R::Twin::both(R::ZERO); 3];
    let [mut s0, mut s1, mut d0, mut d1] = [none; 4];
    for k in 0..M {
        let [sum, difference] = pair(k);
        let add = |to: [R::Twin; 3], x: [R::Twin; 3], single: f32, double: f64| {
            let weight = weight(single, double);
            each(to, x, |to, x| to + x * weight)
        };
        s0 = add(s0, sum, single.sums[0][k], double.sums[0][k]);
        s1 = add(s1, sum, single.sums[1][k], double.sums[1][k]);
        d0 = add(d0, difference, single.differences[0][k], double.differences[0][k]);
        d1 = add(d1, difference, single.differences[1][k], double.differences[1][k]);
    }
    let ([sum0, difference0], [sum1, difference1]) = (pair(0), pair(1));
    let products = [(s0, difference0), (s1, difference1), (d0, sum0), (d1, sum1)];
    let mut lacking = Increment::ZERO;
    for (x, by) in products {
        let (x, by) = (Increment::<R>::from_twins(x), Increment::<R>::from_twins(by));
        let crossed = x.angle_b.cross(by.velocity_b) + x.velocity_b.cross(by.angle_b);
        lacking.angle_b = lacking.angle_b + x.angle_b.cross(by.angle_b);
        lacking.velocity_b = lacking.velocity_b + crossed;
    }
    lacking
}
