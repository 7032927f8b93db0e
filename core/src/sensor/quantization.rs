//! Quantization: increments come in whole steps, and what a step leaves over is not lost.
//!
//! The cumulative sum is rounded and its difference emitted. Rounding each sample for itself would
//! turn 3Q²/τ² of Allan variance into white noise, and bias slow motion.

use super::parameter::{Parameter, ParameterError};
use super::{ErrorTerm, Reading, Stimulus};
use crate::math::vector::Vector;
use crate::noise::{Deviate, Streams};

/// Steps of the output. Its Allan variance is 3Q²/τ² with Q = step/√12.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Quantization<R> {
    step: Vector<R>,
    steps_per_unit: Vector<R>,
}

impl<R: Deviate> Quantization<R> {
    /// From the least significant bit of each axis, angle; 0 leaves an axis continuous.
    pub fn new(step: Vector<R>) -> Result<Self, ParameterError> {
        let step = Parameter::Quantization.magnitude(step)?;
        let inverse = step.map(|s| if s > R::ZERO { R::ONE / s } else { R::ZERO });
        Ok(Self { step, steps_per_unit: Parameter::Quantization.computed(inverse)? })
    }
}

impl<R: Deviate> ErrorTerm<R> for Quantization<R> {
    /// What the output so far lacks of the input so far: at most half a step.
    type State = Vector<R>;

    #[inline]
    fn start(&self, _: Streams) -> Vector<R> {
        Vector::ZERO
    }

    #[inline]
    fn apply(&self, remainder: &mut Vector<R>, _: &Stimulus<R>, reading: &mut Reading<R>) {
        // y = x + c,  out = q·round(y/q),  c ← y − out
        let exact = reading.increment + *remainder;
        let steps = self.step.zip(self.steps_per_unit, |q, inverse| (q, inverse));
        reading.increment = exact
            .zip(steps, |y, (q, inverse)| if q > R::ZERO { q * (y * inverse).round() } else { y });
        *remainder = exact - reading.increment;
    }
}
