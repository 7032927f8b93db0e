//! g-sensitivity of a gyro: G·f, a rate error in proportion to the specific force on the same axis.
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::noise::Streams;
//! use schuler::sensor::{ErrorTerm, Reading, Stimulus, g_sensitivity::GSensitivity};
//!
//! let axes = |x| Vector::new(x, x, x);
//! let term = GSensitivity::new(axes(1e-4))?;
//! let mut state = term.start(Streams::new(1, 0));
//! let truth = Vector::new(0.02_f64, 0.0, 0.0);
//! let stimulus = Stimulus { sensed: truth, velocity_b: Vector::new(0.0, 0.0, -0.098) };
//! let mut reading = Reading::new(truth);
//! term.apply(&mut state, &stimulus, &mut reading);
//! assert!((reading.increment.z + 9.8e-6).abs() < 1e-17);
//! # Ok::<(), schuler::sensor::parameter::ParameterError>(())
//! ```

use super::parameter::{Parameter, ParameterError};
use super::{ErrorTerm, Reading, Stimulus};
use crate::math::vector::Vector;
use crate::noise::random::Random;
use crate::noise::{Deviate, Streams};

/// A rate error from specific force.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GSensitivity<R> {
    coefficient: Vector<R>,
}

impl<R: Deviate> GSensitivity<R> {
    /// From the coefficient of each axis, rad/s per m/s².
    ///
    /// # Errors
    ///
    /// [`ParameterError`] if a coefficient is not finite.
    pub fn new(coefficient: Vector<R>) -> Result<Self, ParameterError> {
        Ok(Self { coefficient: Parameter::GSensitivity.signed(coefficient)? })
    }
}

impl<R: Copy> GSensitivity<R> {
    /// The same term in numbers of another type, as `number` makes them from these.
    pub fn map<T>(&self, number: impl Fn(R) -> T) -> GSensitivity<T> {
        GSensitivity { coefficient: self.coefficient.map(number) }
    }
}

impl<R: Random> ErrorTerm<R> for GSensitivity<R> {
    type State = ();

    #[inline]
    fn start(&self, _: Streams) {}

    #[inline(always)]
    fn apply(&self, _: &mut (), stimulus: &Stimulus<R>, reading: &mut Reading<R>) {
        // G = diag(g):  ∫G·f dt = G·Δv
        let error = self.coefficient.times(stimulus.velocity_b);
        reading.increment = reading.increment + error;
    }
}
