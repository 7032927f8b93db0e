//! From a scene's channels to the core's trajectory.

use super::{Channel, Mounting, Trajectory, Vibration};
use crate::course::{Course, HARMONICS, Reference};
use schuler::trajectory::carried::Mount;
use schuler::trajectory::harmonic::{self, Channels, CourseError, HarmonicTrajectory};

impl Trajectory {
    /// The motion that is described.
    pub fn build(&self) -> Result<Course, CourseError> {
        let reference = match &self.path {
            Some(path) => Reference::Path(path.clone()),
            None => Reference::Harmonic(Box::new(self.channels()?)),
        };
        Ok(Course::new(reference, self.mounting.build()?))
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

impl Mounting {
    /// As the core takes it; `None` where the unit is the reference point itself.
    fn build(&self) -> Result<Option<Mount<HARMONICS>>, CourseError> {
        if *self == Self::default() {
            return Ok(None);
        }
        let still = Channel::default();
        let of = |[a, b, c]: [&Channel; 3]| -> Result<_, CourseError> {
            if [a, b, c].iter().all(|channel| **channel == still) {
                return Ok(None);
            }
            let rest = harmonic::Channel::constant(0.0);
            let channels = Channels {
                roll: a.borrow(),
                pitch: b.borrow(),
                yaw: c.borrow(),
                latitude: rest,
                longitude: rest,
                altitude: rest,
            };
            HarmonicTrajectory::new(channels).map(Some)
        };
        let Vibration { roll, pitch, yaw, forward, right, down } = &self.vibration;
        Ok(Some(Mount {
            lever_arm_b: self.lever_arm_m.into(),
            turning: of([roll, pitch, yaw])?,
            moving: of([forward, right, down])?,
        }))
    }
}

impl Channel {
    /// As the core takes it.
    fn borrow(&self) -> harmonic::Channel<'_, f64> {
        harmonic::Channel { offset: self.offset, rate: self.rate, harmonics: &self.harmonics }
    }
}
