//! Constant bias: the same in every run.

use super::parameter::{Parameter, ParameterError};
use super::{ErrorTerm, Reading, Stimulus, Timing};
use crate::math::vector::Vector;
use crate::noise::{Deviate, Streams};

/// A bias that never changes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Constant<R> {
    increment: Vector<R>,
}

impl<R: Deviate> Constant<R> {
    /// From the bias of each axis, angle/s.
    pub fn new(bias: Vector<R>, timing: Timing<R>) -> Result<Self, ParameterError> {
        let bias = Parameter::Constant.signed(bias)?;
        // ∫b dt = bΔt
        let increment = Parameter::Constant.computed(bias * timing.interval_s())?;
        Ok(Self { increment })
    }
}

impl<R: Deviate> ErrorTerm<R> for Constant<R> {
    type State = ();

    #[inline]
    fn start(&self, _: Streams) {}

    #[inline]
    fn apply(&self, _: &mut (), _: &Stimulus<R>, reading: &mut Reading<R>) {
        reading.increment = reading.increment + self.increment;
    }
}
