//! A scale factor that follows temperature: c(T − T₀)·x.
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::noise::Streams;
//! use schuler::sensor::temperature::Ramp;
//! use schuler::sensor::temperature_scale::TemperatureScale;
//! use schuler::sensor::{ErrorTerm, Reading, Stimulus, Timing};
//!
//! let ramp = Ramp::new(10.0, 0.0, 1.0, Timing::new(0.01_f64, 1000)?)?;
//! let term = TemperatureScale::new(Vector::new(1e-5, 0.0, 0.0), ramp)?;
//! let mut state = term.start(Streams::new(1, 0));
//! let truth = Vector::new(0.02_f64, 0.0, 0.0);
//! let stimulus = Stimulus { sensed: truth, velocity_b: Vector::new(0.0, 0.0, -0.098) };
//! let mut reading = Reading::new(truth);
//! term.apply(&mut state, &stimulus, &mut reading);
//! assert!((reading.increment.x - 0.02 * 1.0001).abs() < 1e-17);
//! # Ok::<(), schuler::sensor::parameter::ParameterError>(())
//! ```

use super::parameter::{Parameter, ParameterError};
use super::temperature::Ramp;
use super::{ErrorTerm, Reading, Stimulus};
use crate::math::vector::Vector;
use crate::noise::random::Random;
use crate::noise::{Deviate, Streams};

/// A relative scale factor error in proportion to the temperature above that of calibration, by its mean over
/// a sample: exact where the rate or the temperature is constant over it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TemperatureScale<R> {
    scale_per_k: Vector<R>,
    ramp: Ramp<R>,
}

impl<R: Deviate> TemperatureScale<R> {
    /// From the coefficient of each axis, 1/K.
    ///
    /// # Errors
    ///
    /// [`ParameterError`] if a coefficient is not finite.
    pub fn new(coefficient: Vector<R>, ramp: Ramp<R>) -> Result<Self, ParameterError> {
        Ok(Self { scale_per_k: Parameter::TemperatureScale.signed(coefficient)?, ramp })
    }
}

impl<R: Copy> TemperatureScale<R> {
    /// The same term in numbers of another type, as `number` makes them from these.
    pub fn map<T>(&self, number: impl Fn(R) -> T) -> TemperatureScale<T> {
        TemperatureScale { scale_per_k: self.scale_per_k.map(&number), ramp: self.ramp.map(number) }
    }
}

impl<R: Random> ErrorTerm<R> for TemperatureScale<R> {
    /// Samples so far.
    type State = u32;

    #[inline]
    fn start(&self, _: Streams) -> u32 {
        0
    }

    #[inline(always)]
    fn apply(&self, samples: &mut u32, stimulus: &Stimulus<R>, reading: &mut Reading<R>) {
        let scale = self.scale_per_k * self.ramp.mean(samples);
        reading.increment = reading.increment + scale.times(stimulus.sensed);
    }
}
