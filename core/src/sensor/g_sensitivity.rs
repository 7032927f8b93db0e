//! g-sensitivity of a gyro: G·f, a rate error in proportion to the specific force on the same axis.

use super::parameter::{Parameter, ParameterError};
use super::{ErrorTerm, Reading, Stimulus};
use crate::math::vector::Vector;
use crate::noise::{Deviate, Streams};

/// A rate error from specific force.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GSensitivity<R> {
    coefficient: Vector<R>,
}

impl<R: Deviate> GSensitivity<R> {
    /// From the coefficient of each axis, rad/s per m/s².
    pub fn new(coefficient: Vector<R>) -> Result<Self, ParameterError> {
        Ok(Self { coefficient: Parameter::GSensitivity.signed(coefficient)? })
    }
}

impl<R: Deviate> ErrorTerm<R> for GSensitivity<R> {
    type State = ();

    #[inline]
    fn start(&self, _: Streams) {}

    #[inline]
    fn apply(&self, _: &mut (), stimulus: &Stimulus<R>, reading: &mut Reading<R>) {
        // G = diag(g):  ∫G·f dt = G·Δv
        let error = self.coefficient.zip(stimulus.velocity_b, |g, f| g * f);
        reading.increment = reading.increment + error;
    }
}
