//! From a scene's channels to the core's trajectory.

use super::{Channel, Trajectory};
use crate::course::{Course, Reference};
use schuler::trajectory::harmonic::{self, Channels, CourseError, HarmonicTrajectory};

/// Harmonics that a scene may have, over all channels.
pub const HARMONICS: usize = 64;

impl Trajectory {
    /// The motion that is described.
    pub fn build(&self) -> Result<Course, CourseError> {
        let reference = match &self.path {
            Some(path) => Reference::Path(path.clone()),
            None => Reference::Harmonic(self.channels()?),
        };
        Ok(Course::new(reference, None))
    }

    fn channels(&self) -> Result<HarmonicTrajectory<f64, HARMONICS>, CourseError> {
        HarmonicTrajectory::new(Channels {
            roll: self.roll.borrow(),
            pitch: self.pitch.borrow(),
            yaw: self.yaw.borrow(),
            latitude: self.latitude.borrow(),
            longitude: self.longitude.borrow(),
            altitude: self.altitude.borrow(),
        })
    }
}

impl Channel {
    /// As the core takes it.
    fn borrow(&self) -> harmonic::Channel<'_, f64> {
        harmonic::Channel { offset: self.offset, rate: self.rate, harmonics: &self.harmonics }
    }
}
