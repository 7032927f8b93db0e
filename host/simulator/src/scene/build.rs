//! From a scene's channels to the core's trajectory.

use super::{Channel, Trajectory};
use schuler::trajectory::harmonic::{self, Channels, CourseError, HarmonicTrajectory};

/// Harmonics that a scene may have, over all channels.
pub const HARMONICS: usize = 64;

impl Trajectory {
    /// The motion that the channels describe.
    pub fn build(&self) -> Result<HarmonicTrajectory<f64, HARMONICS>, CourseError> {
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
