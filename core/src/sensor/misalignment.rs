//! Misalignment: M·x, for sensor axes that are rotated a little from the body axes.
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::noise::Streams;
//! use schuler::sensor::{ErrorTerm, Reading, Stimulus, misalignment::Misalignment};
//!
//! let term = Misalignment::new(Vector::new(0.0, 0.0, 1e-3))?;
//! let mut state = term.start(Streams::new(1, 0));
//! let truth = Vector::new(0.02_f64, 0.0, 0.0);
//! let stimulus = Stimulus { sensed: truth, velocity_b: Vector::new(0.0, 0.0, -0.098) };
//! let mut reading = Reading::new(truth);
//! term.apply(&mut state, &stimulus, &mut reading);
//! assert!((reading.increment.y + 2e-5).abs() < 1e-17);
//! # Ok::<(), schuler::sensor::parameter::ParameterError>(())
//! ```

use super::parameter::{Parameter, ParameterError};
use super::{ErrorTerm, Reading, Stimulus};
use crate::math::vector::Vector;
use crate::noise::random::Random;
use crate::noise::{Deviate, Streams};

/// A small rotation of the triad, to first order.
///
/// m is the rotation vector from the body axes to the sensor axes. A vector with body components x
/// has the components (I − [m×])x along the sensor axes, so M = −[m×].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Misalignment<R> {
    rotation: Vector<R>,
}

impl<R: Deviate> Misalignment<R> {
    /// From m in body axes, rad.
    ///
    /// # Errors
    ///
    /// [`ParameterError`] if an angle is not finite.
    pub fn new(rotation: Vector<R>) -> Result<Self, ParameterError> {
        Ok(Self { rotation: Parameter::Misalignment.signed(rotation)? })
    }
}

impl<R: Copy> Misalignment<R> {
    /// The same term in numbers of another type, as `number` makes them from these.
    pub fn map<T>(&self, number: impl Fn(R) -> T) -> Misalignment<T> {
        Misalignment { rotation: self.rotation.map(number) }
    }
}

impl<R: Random> ErrorTerm<R> for Misalignment<R> {
    type State = ();

    #[inline]
    fn start(&self, _: Streams) {}

    #[inline(always)]
    fn apply(&self, _: &mut (), stimulus: &Stimulus<R>, reading: &mut Reading<R>) {
        // M·x = −m × x = x × m
        reading.increment = reading.increment + stimulus.sensed.cross(self.rotation);
    }
}
