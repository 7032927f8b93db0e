//! The Allan variance of each error term, in closed form.
//!
//! "Angle" is the sensor's integral: rad for a gyro, m/s for an accelerometer.
//!
//! ```
//! use schuler::allan::term::Term;
//!
//! // Far below its correlation time a Gauss-Markov bias is a random walk of K = σ√(2/T).
//! let process = Term::GaussMarkov { rms: 1e-6, correlation_s: 720.0_f64 };
//! let walk = Term::RandomWalk(1e-6 * (2.0_f64 / 720.0).sqrt());
//! let ratio = process.variance(0.01) / walk.variance(0.01);
//! assert!((ratio - 1.0).abs() < 2e-5);
//! ```

use crate::math::real::Scalar;

/// An error term of one axis, with its magnitude.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Term<R> {
    /// Quantization Q, angle: the least significant bit over √12.
    Quantization(R),
    /// White noise N, angle/√s: angle or velocity random walk.
    White(R),
    /// Bias instability B, angle/s: flicker.
    Flicker(R),
    /// Random walk K of the bias, angle/s/√s.
    RandomWalk(R),
    /// Ramp of the bias, angle/s².
    Ramp(R),
    /// First-order Gauss-Markov bias.
    GaussMarkov {
        /// Its rms, angle/s.
        rms: R,
        /// Its correlation time, s.
        correlation_s: R,
    },
}

/// Below this τ/T the closed forms of a Gauss-Markov bias cancel, and its series are as good as the type.
const SERIES: f64 = 0.5;

impl<R: Scalar> Term<R> {
    /// σ²(τ) of an averaging time in seconds, (angle/s)². Source: IEEE Std 952-2020, annex C.
    pub fn variance(self, tau_s: R) -> R {
        match self {
            // 3Q²/τ²
            Self::Quantization(q) => R::of(3.0) * square(q / tau_s),
            // N²/τ
            Self::White(n) => n * n / tau_s,
            // (2 ln 2/π)B²
            Self::Flicker(b) => {
                R::of(core::f64::consts::LN_2 * core::f64::consts::FRAC_2_PI) * b * b
            }
            // K²τ/3
            Self::RandomWalk(k) => k * k * tau_s * R::ratio(1, 3),
            // R²τ²/2
            Self::Ramp(r) => square(r * tau_s) * R::HALF,
            Self::GaussMarkov { rms, correlation_s } => {
                rms * rms * gauss_markov(tau_s / correlation_s)
            }
        }
    }

    /// The generalised covariance s(t) of the angle: whatever a second difference of the angle leaves of its
    /// covariance, so that E[d(0)d(t)] = 6s(t) − 4s(t ± τ) + s(t ± 2τ), angle². A ramp is no random process
    /// and has none.
    ///
    /// −N²|t|/2, B²t² ln|t|/(2π), K²|t|³/12; s″ = −σ²e^{−|t|/T}.
    pub fn covariance(self, t_s: R) -> R {
        let t = t_s.abs();
        let is_zero = t == R::ZERO;
        match self {
            Self::Quantization(q) if is_zero => q * q,
            Self::Quantization(_) | Self::Ramp(_) => R::ZERO,
            _ if is_zero => R::ZERO,
            Self::White(n) => -(n * n * t * R::HALF),
            Self::Flicker(b) => square(b * t) * t.ln() * R::of(0.5 * core::f64::consts::FRAC_1_PI),
            Self::RandomWalk(k) => square(k * t) * t * R::ratio(1, 12),
            Self::GaussMarkov { rms, correlation_s } => {
                // −σ²T²(e^{−x} − 1 + x − x²/2): what is even of degree 0 and 2 has no part in a second difference.
                let x = t / correlation_s;
                -(square(rms * correlation_s) * remainder(x))
            }
        }
    }
}

fn square<R: Scalar>(x: R) -> R {
    x * x
}

/// (2/x)[1 − (3 − 4e^{−x} + e^{−2x})/(2x)], x = τ/T: the Allan variance over σ².
fn gauss_markov<R: Scalar>(x: R) -> R {
    if x > R::of(SERIES) {
        let u = -(-x).exp_m1();
        // 3 − 4e^{−x} + e^{−2x} = 2u + u²
        let bracket = R::ONE - (u + u + u * u) / (x + x);
        return (R::TWO / x) * bracket;
    }
    // 1 − … = Σ_{n≥3} (−1)ⁿ⁺¹ xⁿ⁻¹(2ⁿ − 4)/(2 n!), so the whole is Σ (−1)ⁿ⁺¹ xⁿ⁻²(2ⁿ − 4)/n!
    let (mut sum, mut power) = (R::ZERO, x * R::ratio(1, 6));
    let mut n = 3;
    while n < 22 {
        sum = sum + power * R::count((1 << n) - 4);
        n += 1;
        power = -(power * x) / R::count(n);
    }
    sum
}

/// e^{−x} − 1 + x − x²/2.
fn remainder<R: Scalar>(x: R) -> R {
    if x > R::of(SERIES) {
        return ((-x).exp_m1() + x) - x * x * R::HALF;
    }
    // Σ_{n≥3} (−x)ⁿ/n!
    let (mut sum, mut power) = (R::ZERO, -(x * x * x) * R::ratio(1, 6));
    let mut n = 3;
    while n < 16 {
        sum = sum + power;
        n += 1;
        power = -(power * x) / R::count(n);
    }
    sum
}
