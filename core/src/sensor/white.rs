//! White noise on the rates: angle random walk, velocity random walk.

use super::parameter::{Parameter, ParameterError};
use super::{ErrorTerm, Reading, Stimulus, Timing};
use crate::math::vector::Vector;
use crate::noise::{Deviate, Stream, Streams};

/// White noise, whose integral is a random walk. Its Allan variance is N²/τ.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct White<R> {
    deviation: Vector<R>,
}

impl<R: Deviate> White<R> {
    /// From N of each axis, angle/√s.
    pub fn new(density: Vector<R>, timing: Timing<R>) -> Result<Self, ParameterError> {
        let density = Parameter::WhiteNoise.magnitude(density)?;
        let deviation = Parameter::WhiteNoise.computed(density * timing.interval_s().sqrt())?;
        Ok(Self { deviation })
    }
}

impl<R: Deviate> ErrorTerm<R> for White<R> {
    type State = [Stream; 3];

    #[inline]
    fn start(&self, streams: Streams) -> [Stream; 3] {
        streams.axes()
    }

    #[inline]
    fn apply(&self, streams: &mut [Stream; 3], _: &Stimulus<R>, reading: &mut Reading<R>) {
        let [x, y, z] = streams;
        // N√Δt·z
        let deviates = Vector::new(x.normal(), y.normal(), z.normal());
        reading.increment = reading.increment + self.deviation.zip(deviates, |n, z: R| n * z);
    }
}
