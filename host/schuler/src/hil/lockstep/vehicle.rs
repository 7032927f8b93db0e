//! Both sides as the vehicle of a flight.

use super::Lockstep;
use schuler::sample::Increment;
use schuler_simulator::input::Complaint;
use schuler_simulator::navigator::{Navigate, Reader};
use schuler_simulator::simulate::{Refused, Vehicle};

/// A vehicle that is a target and its twin.
pub struct Boarded {
    lockstep: Lockstep,
    /// The host's own, for the time that it takes.
    navigator: Box<dyn Navigate>,
}

impl Boarded {
    /// With a navigator of the same kind, whose time is taken.
    pub fn new(lockstep: Lockstep, navigator: Box<dyn Navigate>) -> Self {
        Self { lockstep, navigator }
    }
}

impl Lockstep {
    /// Both sides take a sample that is not of a flight; what ends it is told.
    pub(in super::super) fn take_sample(
        &mut self,
        sample: &Increment<f64>,
        read: &mut Reader,
    ) -> Result<(), Complaint> {
        match self.sample(sample, read) {
            Ok(Ok(())) => Ok(()),
            Ok(Err(Refused::Missing)) => {
                Err(Complaint::new(format!("sample {} was lost", self.samples), "more --retries"))
            }
            Ok(Err(_)) => Err(Complaint::new(format!("sample {} is refused", self.samples), "")),
            Err(parted) => Err(Complaint::new(format!("sample {}: {parted}", self.samples), "")),
        }
    }

    /// Digest of every state so far.
    pub(in super::super) fn digest(&self) -> u64 {
        self.twin.standing().digest
    }
}

impl Drop for Lockstep {
    fn drop(&mut self) {
        let mut tally = self.conversation.tally();
        tally.bridged = self.twin.bridged().into();
        self.ended(|ended| ended.tally = tally);
    }
}

impl Vehicle for Boarded {
    fn push(&mut self, sample: &Increment<f64>, read: &mut Reader) -> Result<(), Refused> {
        let side = &mut self.lockstep;
        side.measure_due(read).map_err(|parted| side.stop(&parted))??;
        side.sample(sample, read).map_err(|parted| side.stop(&parted))?
    }

    fn hold_vertical(&mut self, altitude_m: f64, down_m_s: f64) -> Result<(), Refused> {
        let side = &mut self.lockstep;
        side.hold(altitude_m, down_m_s).map_err(|parted| side.stop(&parted))?
    }

    fn finish(&mut self, read: &mut Reader) -> Result<(), Refused> {
        let side = &mut self.lockstep;
        let end = side.end(read).map_err(|parted| side.stop(&parted));
        side.report();
        end?
    }

    fn break_off(&mut self, _: &mut Reader) {
        // The target has not taken what its twin has not.
        self.lockstep.report();
    }

    fn integrated(&self) -> u64 {
        self.lockstep.twin.standing().integrated
    }

    fn digest(&self) -> u64 {
        self.lockstep.digest()
    }

    fn navigator(&self) -> &dyn Navigate {
        self.navigator.as_ref()
    }
}
