//! The trajectory, sensors and navigator of a run.

use super::Refused;
use crate::navigator::{Navigate, Reader};
use schuler::sample::Increment;

/// A navigator, or what stands in its place.
pub trait Vehicle {
    /// Takes a sample, and reads the rows that it completes.
    fn push(&mut self, sample: &Increment<f64>, read: &mut Reader) -> Result<(), Refused>;
    /// Sets height and vertical velocity at the end of the last block.
    fn hold_vertical(&mut self, altitude_m: f64, down_m_s: f64) -> Result<(), Refused>;
    /// Completes the rows that wait for samples.
    fn finish(&mut self, read: &mut Reader) -> Result<(), Refused>;
    /// The same as far as it can be done after a sample that was not taken.
    fn break_off(&mut self, read: &mut Reader);
    /// Samples integrated so far.
    fn integrated(&self) -> u64;
    /// Digest of every state so far.
    fn digest(&self) -> u64;
    /// A navigator of this kind, whose time is taken.
    fn navigator(&self) -> &dyn Navigate;
}

impl Vehicle for Box<dyn Navigate> {
    fn push(&mut self, sample: &Increment<f64>, read: &mut Reader) -> Result<(), Refused> {
        Ok(self.as_mut().push(sample, read)?)
    }

    fn hold_vertical(&mut self, altitude_m: f64, down_m_s: f64) -> Result<(), Refused> {
        Ok(self.as_mut().hold_vertical(altitude_m, down_m_s)?)
    }

    fn finish(&mut self, read: &mut Reader) -> Result<(), Refused> {
        self.as_mut().finish(read);
        Ok(())
    }

    fn break_off(&mut self, read: &mut Reader) {
        self.as_mut().finish(read);
    }

    fn integrated(&self) -> u64 {
        self.as_ref().integrated()
    }

    fn digest(&self) -> u64 {
        self.as_ref().digest()
    }

    fn navigator(&self) -> &dyn Navigate {
        self.as_ref()
    }
}
