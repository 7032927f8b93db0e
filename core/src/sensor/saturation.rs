//! Saturation: no axis reads beyond its limit.

use super::parameter::{Parameter, ParameterError};
use super::{ErrorTerm, Reading, Stimulus, Timing};
use crate::math::vector::Vector;
use crate::noise::{Deviate, Streams};

/// Limits of the mean rate over a sample. A reading beyond them is cut, and marked.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Saturation<R> {
    limit: Vector<R>,
}

impl<R: Deviate> Saturation<R> {
    /// From the largest output of each axis, angle/s.
    pub fn new(limit: Vector<R>, timing: Timing<R>) -> Result<Self, ParameterError> {
        let limit = Parameter::Saturation.positive(limit)?;
        let limit = Parameter::Saturation.computed(limit * timing.interval_s())?;
        Ok(Self { limit })
    }
}

impl<R: Deviate> ErrorTerm<R> for Saturation<R> {
    type State = ();

    #[inline]
    fn start(&self, _: Streams) {}

    #[inline]
    fn apply(&self, _: &mut (), _: &Stimulus<R>, reading: &mut Reading<R>) {
        let Reading { increment, saturated } = reading;
        *increment = increment.zip(self.limit, |x, limit| {
            let (over, under) = (x > limit, x < -limit);
            *saturated |= over | under;
            if over {
                limit
            } else if under {
                -limit
            } else {
                x
            }
        });
    }
}
