//! Scale factor error: S·x, positive if the sensor reads too much.

use super::parameter::{Parameter, ParameterError};
use super::{ErrorTerm, Reading, Stimulus};
use crate::math::vector::Vector;
use crate::noise::{Deviate, Streams};

/// A relative error of each axis.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ScaleFactor<R> {
    relative: Vector<R>,
}

impl<R: Deviate> ScaleFactor<R> {
    /// From the relative error of each axis.
    pub fn new(relative: Vector<R>) -> Result<Self, ParameterError> {
        Ok(Self { relative: Parameter::ScaleFactor.signed(relative)? })
    }
}

impl<R: Deviate> ErrorTerm<R> for ScaleFactor<R> {
    type State = ();

    #[inline]
    fn start(&self, _: Streams) {}

    #[inline]
    fn apply(&self, _: &mut (), stimulus: &Stimulus<R>, reading: &mut Reading<R>) {
        // S = diag(s):  S·x
        let error = self.relative.zip(stimulus.sensed, |s, x| s * x);
        reading.increment = reading.increment + error;
    }
}
