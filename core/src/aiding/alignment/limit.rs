//! What theory allows an alignment, and how long it takes.
//!
//! With the gyros' noise N, the accelerometers' M, an east gyro bias σ_ε, an east accelerometer bias σ_∇ and
//! τ = M/(γN), the heading of a vehicle at rest whose turn rate is not known otherwise is good to
//! σ² = (σ_ε² + N²/(T − 2τ tanh(T/2τ)))/(ω_ie cosφ)² + (tanφ σ_∇/γ)².
//!
//! ```
//! use schuler::aiding::alignment::limit::Limit;
//! use schuler::aiding::surroundings::Surroundings;
//! use schuler::earth::Geodetic;
//! use schuler::units::{DEGREE, DEGREE_PER_HOUR, MICRO_G};
//!
//! let place = Geodetic { latitude: 45.0 * DEGREE, longitude: 0.0, altitude: 0.0 };
//! let limit = Limit {
//!     gyro_noise: 0.002 * DEGREE / 60.0,
//!     accelerometer_noise: 10.0 * MICRO_G,
//!     gyro_bias: 0.01 * DEGREE_PER_HOUR,
//!     accelerometer_bias: 50.0 * MICRO_G,
//! };
//! let here = Surroundings::at(&place);
//! let minutes = limit.heading(&here, 60.0) / DEGREE * 60.0;
//! assert!((minutes - 8.05).abs() < 0.02);
//! let needed = limit.seconds(&here, 5.0 / 60.0 * DEGREE).unwrap();
//! assert!((limit.heading(&here, needed) / DEGREE * 60.0 - 5.0).abs() < 1e-3);
//! ```

use crate::aiding::surroundings::Surroundings;
use crate::math::real::Scalar;

/// What limits an alignment.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Limit<R> {
    /// Angle random walk N, rad/√s.
    pub gyro_noise: R,
    /// Velocity random walk M, m/s/√s.
    pub accelerometer_noise: R,
    /// σ of a gyro's bias, rad/s.
    pub gyro_bias: R,
    /// σ of an accelerometer's bias, m/s².
    pub accelerometer_bias: R,
}

/// The longest alignment that is looked for, s.
const LONGEST_S: f64 = 86400.0;

impl<R: Scalar> Limit<R> {
    /// σ of the heading at rest after a time in seconds, rad; the biases are in it, as nothing shows them.
    pub fn heading(&self, here: &Surroundings<R>, time_s: R) -> R {
        self.with_biases(here, self.rate_variance(here.gravity, time_s))
    }

    /// The same where it is known that the vehicle does not turn: σ² = (σ_ε² + N²/T)/(ω_ie cosφ)² + (tanφ σ_∇/γ)².
    pub fn heading_unturned(&self, here: &Surroundings<R>, time_s: R) -> R {
        self.with_biases(here, self.gyro_noise * self.gyro_noise / time_s)
    }

    /// σ of the heading from the variance of a turn rate, (rad/s)².
    fn with_biases(&self, here: &Surroundings<R>, noise: R) -> R {
        let (north, gravity) = (here.earth_rate_ned.x, here.gravity);
        let tilt = here.earth_rate_ned.z / north * self.accelerometer_bias / gravity;
        ((self.gyro_bias * self.gyro_bias + noise) / (north * north) + tilt * tilt).sqrt()
    }

    /// The same of a vehicle that turns about the vertical, or stands in two positions half a turn apart: there the
    /// biases show, and only the noise limits.
    pub fn heading_turning(&self, here: &Surroundings<R>, time_s: R) -> R {
        self.rate_variance(here.gravity, time_s).sqrt() / here.earth_rate_ned.x
    }

    /// σ of level at rest, rad.
    pub fn level(&self, here: &Surroundings<R>) -> R {
        self.accelerometer_bias / here.gravity
    }

    /// The variance of the turn rate from noise, (rad/s)².
    fn rate_variance(&self, gravity: R, time_s: R) -> R {
        // N²/(T − 2τ tanh(T/2τ)) = N²/(2τ(x − tanh x)), x = T/2τ;  with x ≪ 1 it is 12M²/(γ²T³)
        let (n, m) = (self.gyro_noise, self.accelerometer_noise);
        let twice_tau = R::TWO * m / (gravity * n);
        let x = time_s / twice_tau;
        if x < R::of(0.05) {
            return R::of(12.0) * m * m / (gravity * gravity * time_s * time_s * time_s);
        }
        // tanh x = −expm1(−2x)/(2 + expm1(−2x))
        let e = (-(x + x)).exp_m1();
        n * n / (twice_tau * (x + e / (R::TWO + e)))
    }

    /// How long an alignment at rest takes to reach a σ of the heading, s; `None` if none does.
    pub fn seconds(&self, here: &Surroundings<R>, sigma: R) -> Option<R> {
        let enough = |time_s: R| self.heading(here, time_s) <= sigma;
        let (mut short, mut long) = (R::of(1e-3), R::of(LONGEST_S));
        if !enough(long) {
            return None;
        }
        for _ in 0..60 {
            let middle = (short * long).sqrt();
            if enough(middle) {
                long = middle;
            } else {
                short = middle;
            }
        }
        Some(long)
    }
}
