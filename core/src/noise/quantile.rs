//! The inverse of the normal distribution: Wichura's algorithm AS 241 (Applied Statistics 37, 1988,
//! 477), PPND16, in double precision, and polynomials that follow it in single precision.
//!
//! PPND16 has rational functions of the probability's distance from ½ in the centre, and of √(−ln p) in the
//! tails. What a deviate's word means is told at [`Deviate::normal`](super::Deviate::normal).
//!
//! ```
//! use schuler::noise::quantile::double::{centre, tail};
//!
//! // At the border of centre and tail both are good.
//! assert!((centre(0.425_f64) - tail(0.075_f64)).abs() < 1e-15);
//! ```

pub(super) mod single;

use crate::math::real::Real;

/// Numerator and denominator, by falling powers.
type Rational = ([f64; 8], [f64; 8]);

/// P(r)/Q(r).
#[inline(always)]
fn ratio<R: Real>(table: &Rational, r: R) -> R {
    horner(&table.0, r) / horner(&table.1, r)
}

/// A polynomial in r, by Horner's rule. No closures here: packs are slow where one is not inlined.
#[inline(always)]
fn horner<R: Real>([first, rest @ ..]: &[f64; 8], r: R) -> R {
    let mut sum = R::of(*first);
    for &c in rest {
        sum = sum * r + R::of(c);
    }
    sum
}

/// PPND16: relative error about 1e-16. Packs of runs have the bits of a single `f64`.
#[allow(clippy::excessive_precision, reason = "the coefficients as published")]
pub mod double {
    use super::{Rational, Real, ratio};

    /// Up to this distance of the probability from ½ the central approximation holds,
    /// in units of a word, 0.425·2⁶⁴.
    pub const CENTRE: i64 = (0.425 / UNIT) as i64;

    /// The unit of a word, 2⁻⁶⁴.
    pub const UNIT: f64 = 1.0 / (1u128 << 64) as f64;

    /// The deviate at the distance q ≤ 0.425 of the probability from ½.
    #[inline(always)]
    pub fn centre<R: Real>(q: R) -> R {
        // z = q P(r)/Q(r),  r = 0.425² − q²
        q * ratio(&CENTRAL, R::of(0.180625) - q * q)
    }

    pub(super) const CENTRAL: Rational = (
        [
            2.5090809287301226727e3,
            3.3430575583588128105e4,
            6.7265770927008700853e4,
            4.5921953931549871457e4,
            1.3731693765509461125e4,
            1.9715909503065514427e3,
            1.3314166789178437745e2,
            3.3871328727963666080,
        ],
        [
            5.2264952788528545610e3,
            2.8729085735721942674e4,
            3.9307895800092710610e4,
            2.1213794301586595867e4,
            5.3941960214247511077e3,
            6.8718700749205790830e2,
            4.2313330701600911252e1,
            1.0,
        ],
    );

    pub(super) const TAIL: Rational = (
        [
            7.74545014278341407640e-4,
            2.27238449892691845833e-2,
            2.41780725177450611770e-1,
            1.27045825245236838258,
            3.64784832476320460504,
            5.76949722146069140550,
            4.63033784615654529590,
            1.42343711074968357734,
        ],
        [
            1.05075007164441684324e-9,
            5.47593808499534494600e-4,
            1.51986665636164571966e-2,
            1.48103976427480074590e-1,
            6.89767334985100004550e-1,
            1.67638483018380384940,
            2.05319162663775882187,
            1.0,
        ],
    );

    pub(super) const FAR_TAIL: Rational = (
        [
            2.01033439929228813265e-7,
            2.71155556874348757815e-5,
            1.24266094738807843860e-3,
            2.65321895265761230930e-2,
            2.96560571828504891230e-1,
            1.78482653991729133580,
            5.46378491116411436990,
            6.65790464350110377720,
        ],
        [
            2.04426310338993978564e-15,
            1.42151175831644588870e-7,
            1.84631831751005468180e-5,
            7.86869131145613259100e-4,
            1.48753612908506148525e-2,
            1.36929880922735805310e-1,
            5.99832206555887937690e-1,
            1.0,
        ],
    );

    /// The deviate that is exceeded with probability p.
    #[inline(always)]
    pub fn tail<R: Real>(p: R) -> R {
        // r = √(−ln p)
        let r = (-p.ln()).sqrt();
        let near = ratio(&TAIL, r - R::of(1.6));
        let far = R::of(5.0).less(r);
        if R::any(far) { R::select(far, ratio(&FAR_TAIL, r - R::of(5.0)), near) } else { near }
    }
}
