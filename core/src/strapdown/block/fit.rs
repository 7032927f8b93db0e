//! Fit of a window: polynomials through the increments of H + B + A samples.
//!
//! σ ∈ [−1, 1] spans the block of B samples; sample j is [aⱼ, bⱼ] = −1 + 2[j − H, j − H + 1]/B.
//! w(σ) = Σ w_k σᵏ is the angular rate per unit of σ whose integral over every sample is that sample's
//! increment: w_k = Σⱼ A_kj Δθⱼ, A the inverse of B_jk = (bⱼᵏ⁺¹ − aⱼᵏ⁺¹)/(k + 1); likewise f_k from Δvⱼ.
//! Each entry of A is a ratio of integers, from Lagrange's basis over the sample edges, divided once.
//! For slow motion a line or a parabola over a long block is enough: see [`least_squares`](super::least_squares).
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::sample::Increment;
//! use schuler::strapdown::block::fit::Fit;
//!
//! // Two samples of a rate that grows: over σ ∈ [−1, 1] the rate is 1.5 + σ.
//! let sample = |x: f64| Increment { angle_b: Vector::new(x, 0.0, 0.0), velocity_b: Vector::ZERO };
//! let (fit, sum) = Fit::<f64, 2>::from_any(&[sample(1.0), sample(2.0)], 0, 2);
//! assert_eq!((fit.rate[0].x, fit.rate[1].x, sum.angle_b.x), (1.5, 1.0, 3.0));
//! ```

use crate::math::real::Real;
use crate::math::real::Twin as _;
use crate::math::vector::Vector;
use crate::sample::Increment;

/// Samples in the windows of a stream's last blocks, if lines or parabolas are fitted to the others.
pub const LINE_LAST_SAMPLES: usize = 8;

/// Most samples that a window may interpolate.
pub const MOST_SAMPLES: usize = 14;

/// Coefficients of angular rate and specific force over a block, per unit of σ.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Fit<R, const K: usize> {
    /// w_k, rad.
    pub rate: [Vector<R>; K],
    /// f_k, m/s.
    pub force: [Vector<R>; K],
}

/// The same function of each pair of three twins.
#[inline(always)]
pub(crate) fn each<T: Copy>(a: [T; 3], b: [T; 3], f: impl Fn(T, T) -> T) -> [T; 3] {
    [f(a[0], b[0]), f(a[1], b[1]), f(a[2], b[2])]
}

impl<R: Real, const K: usize> Fit<R, K> {
    /// The fit to `P` samples, by a table in either precision, with the sum of the block that follows `history`
    /// samples. A window is symmetric if as many samples follow the block.
    #[inline(always)]
    #[expect(
        clippy::indexing_slicing,
        reason = "every index is below the length of its array, a constant"
    )]
    pub fn from_samples<const P: usize>(
        samples: &[Increment<R>; P],
        history: usize,
        block: usize,
        single: &[[f32; P]; K],
        double: &[[f64; P]; K],
    ) -> (Self, Increment<R>) {
        let none = [R::Twin::both(R::ZERO); 3];
        let mut fit = Self { rate: [Vector::ZERO; K], force: [Vector::ZERO; K] };
        // A_k,P−1−j = (−1)ᵏ A_kj in a symmetric window: even coefficients use the sums of opposite
        // samples, odd ones their differences.
        let mut sums = [none; MOST_SAMPLES / 2];
        let mut differences = sums;
        let half = if 2 * history + block == P { P / 2 } else { 0 };
        for j in 0..half {
            let (a, b) = (samples[j].twins(), samples[P - 1 - j].twins());
            sums[j] = each(a, b, |a, b| a + b);
            differences[j] = each(a, b, |a, b| a - b);
        }
        for k in 0..K {
            let folded = if k % 2 == 0 { &sums } else { &differences };
            let mut sum = none;
            for j in 0..half {
                let a = R::Twin::both(R::entry(single[k][j], double[k][j]));
                sum = each(sum, folded[j], |sum, x| sum + x * a);
            }
            for j in half..P - half {
                let a = R::Twin::both(R::entry(single[k][j], double[k][j]));
                sum = each(sum, samples[j].twins(), |sum, x| sum + x * a);
            }
            let Increment { angle_b, velocity_b } = Increment::from_twins(sum);
            fit.rate[k] = angle_b;
            fit.force[k] = velocity_b;
        }
        let mut sum = none;
        for pair in sums.iter().take(half).skip(history) {
            sum = each(sum, *pair, |sum, x| sum + x);
        }
        let ends = (history + block).min(P - half);
        for sample in samples.iter().take(ends).skip(half.max(history)) {
            sum = each(sum, sample.twins(), |sum, x| sum + x);
        }
        (fit, Increment::from_twins(sum))
    }

    /// The fit to any number of samples up to `K`, with a table computed at run time, and the block's sum.
    pub fn from_any(
        samples: &[Increment<R>],
        history: usize,
        block: usize,
    ) -> (Self, Increment<R>) {
        let mut fit = Self { rate: [Vector::ZERO; K], force: [Vector::ZERO; K] };
        let count = samples.len().min(MOST_SAMPLES);
        let table = Table::interpolating(history, block, count);
        let rows = fit.rate.iter_mut().zip(fit.force.iter_mut()).zip(&table.numerators);
        for ((rate, force), row) in rows.take(count) {
            for (sample, &numerator) in samples.iter().zip(row) {
                let a = R::ratio(numerator, table.denominator);
                *rate = *rate + sample.angle_b * a;
                *force = *force + sample.velocity_b * a;
            }
        }
        let mut sum = Increment::ZERO;
        for sample in samples.iter().skip(history).take(block) {
            sum.angle_b = sum.angle_b + sample.angle_b;
            sum.velocity_b = sum.velocity_b + sample.velocity_b;
        }
        (fit, sum)
    }
}

/// The table of a window in double precision.
#[expect(
    clippy::indexing_slicing,
    reason = "the compiler alone evaluates it, and stops at an index out of range"
)]
pub const fn table_f64<const P: usize>(h: usize, b: usize) -> [[f64; P]; P] {
    let exact = Table::interpolating(h, b, P);
    let mut table = [[0.0; P]; P];
    let mut k = 0;
    while k < P {
        let mut j = 0;
        while j < P {
            table[k][j] = rounded(exact.numerators[k][j], exact.denominator);
            j += 1;
        }
        k += 1;
    }
    table
}

/// The same in single precision.
pub const fn table_f32<const P: usize>(h: usize, b: usize) -> [[f32; P]; P] {
    narrowed(&table_f64::<P>(h, b))
}

/// A table in single precision.
#[expect(
    clippy::indexing_slicing,
    reason = "the compiler alone evaluates it, and stops at an index out of range"
)]
pub(crate) const fn narrowed<const P: usize>(double: &[[f64; P]; P]) -> [[f32; P]; P] {
    let mut table = [[0.0; P]; P];
    let mut k = 0;
    while k < P {
        let mut j = 0;
        while j < P {
            table[k][j] = double[k][j] as f32;
            j += 1;
        }
        k += 1;
    }
    table
}

/// A_kj as integers over one denominator.
struct Table {
    numerators: [[i128; MOST_SAMPLES]; MOST_SAMPLES],
    denominator: i128,
}

impl Table {
    /// Through all of P samples.
    #[expect(
        clippy::indexing_slicing,
        reason = "the compiler alone evaluates it, and stops at an index out of range"
    )]
    const fn interpolating(h: usize, b: usize, p: usize) -> Self {
        // Edges at sᵢ = 2i − (2H + B), σ = s/B. The integral F(s) has F(s_m) = Σ_{j<m} Δθⱼ, so Δθⱼ's share
        // is Σ_{m>j} ℓ_m(s), ℓ_m = Π_{i≠m}(s − sᵢ)/(s_m − sᵢ), Π_{i≠m}(s_m − sᵢ) = 2ᴾ(−1)ᴾ⁻ᵐ m!(P − m)!.
        // A_kj = (k + 1) Bᵏ⁺¹ [sᵏ⁺¹] Σ_{m>j} (−1)ᴾ⁻ᵐ C(P, m) Π_{i≠m}(s − sᵢ) / (2ᴾ P!)
        let mut numerators = [[0; MOST_SAMPLES]; MOST_SAMPLES];
        let mut denominator = 1;
        let mut binomial = 1;
        let mut m = 1;
        while m <= p {
            binomial = binomial * (p + 1 - m) as i128 / m as i128;
            denominator *= 2 * m as i128;
            let product = product_without(m, h, b, p);
            let sign = if (p - m).is_multiple_of(2) { 1 } else { -1 };
            let mut scale = sign * binomial;
            let mut k = 0;
            // The second condition always holds; it lets the compiler drop the bounds checks.
            while k < p && k < MOST_SAMPLES {
                scale *= b as i128;
                let share = scale * product[k + 1] * (k + 1) as i128;
                let mut j = 0;
                while j < m && j < MOST_SAMPLES {
                    numerators[k][j] += share;
                    j += 1;
                }
                k += 1;
            }
            m += 1;
        }
        Self { numerators, denominator }
    }
}

/// The coefficients of Π_{i≠m}(s − sᵢ) over the edges of P samples.
#[expect(
    clippy::indexing_slicing,
    reason = "the compiler alone evaluates it, and stops at an index out of range"
)]
const fn product_without(m: usize, h: usize, b: usize, p: usize) -> [i128; MOST_SAMPLES + 1] {
    let mut product = [0; MOST_SAMPLES + 1];
    product[0] = 1;
    let mut i = 0;
    while i <= p {
        if i != m {
            let edge = 2 * i as i128 - (2 * h + b) as i128;
            let mut power = p;
            while power > 0 {
                product[power] = product[power - 1] - edge * product[power];
                power -= 1;
            }
            product[0] *= -edge;
        }
        i += 1;
    }
    product
}

/// A ratio in lowest terms, divided once.
pub(crate) const fn rounded(numerator: i128, denominator: i128) -> f64 {
    let (mut a, mut b) = (numerator.abs(), denominator);
    while b != 0 {
        (a, b) = (b, a % b);
    }
    if a == 0 { 0.0 } else { (numerator / a) as f64 / (denominator / a) as f64 }
}
