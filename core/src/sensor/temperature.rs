//! The temperature of a sensor, as what it is above that of its calibration: a ramp, then constant.
//!
//! ```
//! use schuler::sensor::Timing;
//! use schuler::sensor::temperature::Ramp;
//!
//! // 5 K above, and 0.01 K/s more for a minute.
//! let timing = Timing::new(1.0_f64, 100)?;
//! let ramp = Ramp::new(5.0, 0.01, 60.0, timing)?;
//! let mut samples = 0;
//! // Means over the first second, and over the hundredth.
//! assert!((ramp.mean(&mut samples) - 5.005).abs() < 1e-15);
//! samples = 99;
//! assert!((ramp.mean(&mut samples) - 5.6).abs() < 1e-15);
//! # Ok::<(), schuler::sensor::parameter::ParameterError>(())
//! ```

use super::Timing;
use super::parameter::{Parameter, ParameterError};
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::noise::Deviate;

/// T(t) = T₀ + r·min(t, t₁), less the temperature of calibration.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Ramp<R> {
    start_k: R,
    rate_k_s: R,
    until_s: R,
    interval_s: R,
}

impl<R: Deviate> Ramp<R> {
    /// From T₀, K, r, K/s, and t₁, s.
    ///
    /// # Errors
    ///
    /// [`ParameterError`] if a number is not finite, or t₁ is not positive.
    pub fn new(
        start_k: R,
        rate_k_s: R,
        until_s: R,
        timing: Timing<R>,
    ) -> Result<Self, ParameterError> {
        Parameter::Temperature.signed(Vector::new(start_k, rate_k_s, R::ZERO))?;
        let until_s = Parameter::RampTime.single(until_s)?;
        Ok(Self { start_k, rate_k_s, until_s, interval_s: timing.interval_s() })
    }
}

impl<R: Copy> Ramp<R> {
    /// The same ramp in numbers of another type, as `number` makes them from these.
    pub fn map<T>(&self, number: impl Fn(R) -> T) -> Ramp<T> {
        Ramp {
            start_k: number(self.start_k),
            rate_k_s: number(self.rate_k_s),
            until_s: number(self.until_s),
            interval_s: number(self.interval_s),
        }
    }
}

impl<R: Real> Ramp<R> {
    /// The mean over the sample after so many, K; counts it. Past 2³² samples it stays as it is.
    #[inline(always)]
    pub fn mean(&self, samples: &mut u32) -> R {
        let [from, to] =
            [*samples, samples.saturating_add(1)].map(|n| R::count(n) * self.interval_s);
        let middle = (R::count(*samples) + R::HALF) * self.interval_s;
        *samples = samples.saturating_add(1);
        // Where the ramp ends within the sample: ∫ = (t₁² − t²)/2 + t₁(t + Δt − t₁) over Δt, which is
        // t₁ − (t₁ − t)²/2Δt.
        let before = self.until_s - from;
        let last = self.until_s - before * before / (R::TWO * self.interval_s);
        let past = R::select(self.until_s.less(from), self.until_s, last);
        self.start_k + self.rate_k_s * R::select(self.until_s.less(to), past, middle)
    }
}
