//! Both sides as the vehicle of a flight.

use super::Lockstep;
use schuler::sample::Increment;
use schuler_simulator::navigator::{Navigate, Reader};
use schuler_simulator::simulate::{Refused, Vehicle};

impl Drop for Lockstep {
    fn drop(&mut self) {
        let mut tally = self.conversation.tally();
        tally.bridged = self.twin.bridged().into();
        self.ended(|ended| ended.tally = tally);
    }
}

impl Vehicle for Lockstep {
    fn push(&mut self, sample: &Increment<f64>, read: &mut Reader) -> Result<(), Refused> {
        self.measure_due(read).map_err(|parted| self.stop(&parted))??;
        self.sample(sample, read).map_err(|parted| self.stop(&parted))?
    }

    fn hold_vertical(&mut self, altitude_m: f64, down_m_s: f64) -> Result<(), Refused> {
        self.hold(altitude_m, down_m_s).map_err(|parted| self.stop(&parted))?
    }

    fn finish(&mut self, read: &mut Reader) -> Result<(), Refused> {
        let end = self.end(read).map_err(|parted| self.stop(&parted));
        self.report();
        end?
    }

    fn break_off(&mut self, _: &mut Reader) {
        // The target has not taken what its twin has not.
        self.report();
    }

    fn integrated(&self) -> u64 {
        self.twin.standing().integrated
    }

    fn digest(&self) -> u64 {
        self.twin.standing().digest
    }

    fn navigator(&self) -> &dyn Navigate {
        self.navigator.as_ref()
    }
}
