//! A bias that follows temperature: b = c(T − T₀).
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::noise::Streams;
//! use schuler::sensor::temperature::Ramp;
//! use schuler::sensor::temperature_bias::TemperatureBias;
//! use schuler::sensor::{ErrorTerm, Reading, Stimulus, Timing};
//!
//! let timing = Timing::new(0.01_f64, 1000)?;
//! let ramp = Ramp::new(10.0, 0.0, 1.0, timing)?;
//! let term = TemperatureBias::new(Vector::new(1e-6, 0.0, 0.0), ramp, timing)?;
//! let mut state = term.start(Streams::new(1, 0));
//! let truth = Vector::new(0.02_f64, 0.0, 0.0);
//! let stimulus = Stimulus { sensed: truth, velocity_b: Vector::new(0.0, 0.0, -0.098) };
//! let mut reading = Reading::new(truth);
//! term.apply(&mut state, &stimulus, &mut reading);
//! assert!((reading.increment.x - 0.02 - 1e-7).abs() < 1e-17);
//! # Ok::<(), schuler::sensor::parameter::ParameterError>(())
//! ```

use super::parameter::{Parameter, ParameterError};
use super::temperature::Ramp;
use super::{ErrorTerm, Reading, Stimulus, Timing};
use crate::math::vector::Vector;
use crate::noise::random::Random;
use crate::noise::{Deviate, Streams};

/// A bias in proportion to the temperature above that of calibration.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TemperatureBias<R> {
    increment_per_k: Vector<R>,
    ramp: Ramp<R>,
}

impl<R: Deviate> TemperatureBias<R> {
    /// From the coefficient of each axis, angle/s/K.
    ///
    /// # Errors
    ///
    /// [`ParameterError`] if a coefficient is not finite.
    pub fn new(
        coefficient: Vector<R>,
        ramp: Ramp<R>,
        timing: Timing<R>,
    ) -> Result<Self, ParameterError> {
        let coefficient = Parameter::TemperatureBias.signed(coefficient)?;
        let increment_per_k =
            Parameter::TemperatureBias.computed(coefficient * timing.interval_s())?;
        Ok(Self { increment_per_k, ramp })
    }
}

impl<R: Copy> TemperatureBias<R> {
    /// The same term in numbers of another type, as `number` makes them from these.
    pub fn map<T>(&self, number: impl Fn(R) -> T) -> TemperatureBias<T> {
        TemperatureBias {
            increment_per_k: self.increment_per_k.map(&number),
            ramp: self.ramp.map(number),
        }
    }
}

impl<R: Random> ErrorTerm<R> for TemperatureBias<R> {
    /// Samples so far.
    type State = u32;

    #[inline]
    fn start(&self, _: Streams) -> u32 {
        0
    }

    #[inline(always)]
    fn apply(&self, samples: &mut u32, _: &Stimulus<R>, reading: &mut Reading<R>) {
        // ∫c(T − T₀)dt = cΔt times the mean
        reading.increment = reading.increment + self.increment_per_k * self.ramp.mean(samples);
    }
}
