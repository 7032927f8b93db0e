//! The χ² distribution: how often a sum of squares exceeds a limit, and the limit for a frequency.
//!
//! Source: Press et al., *Numerical Recipes*, 3rd ed., §6.2 (the incomplete gamma function by its series, and by its
//! continued fraction).
//!
//! ```
//! use schuler::aiding::chi_square::{exceedance, quantile};
//!
//! // Three squares exceed 16.27 once in a thousand times.
//! assert!((quantile(1e-3_f64, 3) - 16.266).abs() < 1e-3);
//! assert!((exceedance(16.266_f64, 3) - 1e-3).abs() < 1e-6);
//! ```

use crate::math::real::Scalar;

/// Terms of the series, and of the fraction, at most.
const TERMS: u32 = 10_000;

/// e^x, with all digits where it is small.
fn exponential<R: Scalar>(x: R) -> R {
    if x < R::ZERO { R::ONE / (R::ONE + (-x).exp_m1()) } else { R::ONE + x.exp_m1() }
}

/// y^a e^(−y)/Γ(a + 1) for a = degrees/2.
fn density<R: Scalar>(y: R, degrees: u32) -> R {
    // Γ(a + 1) = a(a − 1)…, which ends at 1, or at ½ with Γ(½) = √π
    let (mut sum, mut twice) = (-y, degrees);
    while twice > 0 {
        sum = sum + (y * R::TWO / R::count(twice)).ln();
        twice = twice.saturating_sub(2);
    }
    let whole = exponential(sum);
    if degrees.is_multiple_of(2) {
        whole
    } else {
        whole / (R::of(core::f64::consts::PI) * y).sqrt()
    }
}

/// How often the sum of squares of so many standard normal numbers exceeds x.
pub fn exceedance<R: Scalar>(x: R, degrees: u32) -> R {
    if degrees == 0 || x <= R::ZERO {
        return if degrees == 0 { R::ZERO } else { R::ONE };
    }
    let (a, y) = (R::HALF * R::count(degrees), R::HALF * x);
    let density = density(y, degrees);
    let tiny = R::of(1e-9);
    if y < a + R::ONE {
        // P = y^a e^(−y)/Γ(a + 1)·(1 + y/(a + 1) + y²/((a + 1)(a + 2)) + …)
        let (mut sum, mut term) = (R::ONE, R::ONE);
        for n in 1..TERMS {
            term = term * y / (a + R::count(n));
            sum = sum + term;
            if term < sum * tiny * tiny {
                break;
            }
        }
        return R::ONE - density * sum;
    }
    // Q = a·y^a e^(−y)/Γ(a + 1)·1/(y + 1 − a − 1(1 − a)/(y + 3 − a − 2(2 − a)/(y + 5 − a − …))), by Lentz's method
    let mut b = y + R::ONE - a;
    let mut c = R::of(1e30);
    let mut d = R::ONE / b;
    let mut fraction = d;
    for n in 1..TERMS {
        let n = R::count(n);
        let along = -(n * (n - a));
        b = b + R::TWO;
        let nonzero = |x: R| if x.abs() < R::of(1e-30) { R::of(1e-30) } else { x };
        d = R::ONE / nonzero(along * d + b);
        c = nonzero(b + along / c);
        let factor = d * c;
        fraction = fraction * factor;
        if (factor - R::ONE).abs() < R::entry(1e-7, 1e-15) {
            break;
        }
    }
    a * density * fraction
}

/// The limit that the sum of squares of so many standard normal numbers exceeds so often: a probability above 0 and
/// below 1.
pub fn quantile<R: Scalar>(probability: R, degrees: u32) -> R {
    let (mut low, mut high) = (R::ZERO, R::count(degrees.max(1)));
    for _ in 0..20 {
        if exceedance(high, degrees) < probability {
            break;
        }
        (low, high) = (high, high + high);
    }
    for _ in 0..80 {
        let middle = (low + high) * R::HALF;
        if exceedance(middle, degrees) < probability {
            high = middle;
        } else {
            low = middle;
        }
    }
    (low + high) * R::HALF
}
