//! Scale factor error: S·x, positive if the sensor reads too much.
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::noise::Streams;
//! use schuler::sensor::{ErrorTerm, Reading, Stimulus, scale_factor::ScaleFactor};
//!
//! let axes = |x| Vector::new(x, x, x);
//! let term = ScaleFactor::new(axes(1e-3))?;
//! let mut state = term.start(Streams::new(1, 0));
//! let truth = Vector::new(0.02_f64, 0.0, 0.0);
//! let stimulus = Stimulus { sensed: truth, velocity_b: Vector::new(0.0, 0.0, -0.098) };
//! let mut reading = Reading::new(truth);
//! term.apply(&mut state, &stimulus, &mut reading);
//! assert!((reading.increment.x - 0.02002).abs() < 1e-16);
//! # Ok::<(), schuler::sensor::parameter::ParameterError>(())
//! ```

use super::parameter::{Parameter, ParameterError};
use super::{ErrorTerm, Reading, Stimulus};
use crate::math::vector::Vector;
use crate::noise::random::Random;
use crate::noise::{Deviate, Streams};

/// A relative error of each axis.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ScaleFactor<R> {
    relative: Vector<R>,
}

impl<R: Deviate> ScaleFactor<R> {
    /// From the relative error of each axis.
    ///
    /// # Errors
    ///
    /// [`ParameterError`] if an error is not finite.
    pub fn new(relative: Vector<R>) -> Result<Self, ParameterError> {
        Ok(Self { relative: Parameter::ScaleFactor.signed(relative)? })
    }
}

impl<R: Copy> ScaleFactor<R> {
    /// The same term in numbers of another type, as `number` makes them from these.
    pub fn map<T>(&self, number: impl Fn(R) -> T) -> ScaleFactor<T> {
        ScaleFactor { relative: self.relative.map(number) }
    }
}

impl<R: Random> ErrorTerm<R> for ScaleFactor<R> {
    type State = ();

    #[inline]
    fn start(&self, _: Streams) {}

    #[inline(always)]
    fn apply(&self, _: &mut (), stimulus: &Stimulus<R>, reading: &mut Reading<R>) {
        // S = diag(s):  S·x
        let error = self.relative.times(stimulus.sensed);
        reading.increment = reading.increment + error;
    }
}
