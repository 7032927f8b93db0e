//! Measurements, and what a filter says.

use super::super::parted::Parted;
use super::super::reply::Reply;
use super::{Lockstep, refused};
use schuler::aiding::aided::measured::Measured;
use schuler::link::bytes::Bytes;
use schuler::link::message::Request;
use schuler::solution::Solution;
use schuler_simulator::aided::measurements::Arrivals;
use schuler_simulator::navigator::Reader;
use schuler_simulator::simulate::{Claims, Refused};
use schuler_simulator::twin::Twin;

/// What aids a flight.
pub struct Aiding {
    /// Measurements on their way.
    pub arrivals: Arrivals,
    /// Measurements so far.
    pub sent: u32,
    /// Where the filter says what it claims.
    pub claims: Claims,
}

impl Lockstep {
    /// Both sides take the measurements that have arrived by the end of the next sample. One that is lost on its
    /// way is sent until it is answered.
    pub(super) fn measure_due(&mut self, read: &mut Reader) -> Result<Result<(), Refused>, Parted> {
        let next = u64::from(self.samples) + 1;
        while let Some(aiding) = &mut self.aiding
            && let Some(measured) = aiding.arrivals.by(next)
        {
            aiding.sent += 1;
            let number = aiding.sent;
            if let Err(refused) = self.measure(number, &measured, read)? {
                return Ok(Err(refused));
            }
        }
        Ok(Ok(()))
    }

    fn measure(
        &mut self,
        number: u32,
        measured: &Measured<f64>,
        read: &mut Reader,
    ) -> Result<Result<(), Refused>, Parted> {
        let measured = self.twin.measured(measured);
        let before = self.conversation.happened();
        let reply = self.ask(&Request::Measure { number, measured: Bytes(&measured) });
        self.note(before);
        let reply = reply?.ok_or(Parted::Silence("a measurement"))?;
        if let Reply::Standing(standing) = &reply {
            self.settle(standing, read)?;
        }
        let twin = self.twin.measure(number, &measured).err();
        if twin.is_some() {
            return refused(reply.refusal(), twin);
        }
        self.agree(reply).map(Ok)
    }

    /// The twin does something. The rows that it reads are shown once the filter has said what it claims there.
    pub(super) fn by_twin<T>(
        &mut self,
        read: &mut Reader,
        act: impl FnOnce(&mut Twin, &mut Reader) -> T,
    ) -> T {
        if self.aiding.is_none() {
            return act(&mut self.twin, read);
        }
        let mut rows: Vec<(u64, Solution<f64>)> = Vec::new();
        let done = act(&mut self.twin, &mut |samples, solution| rows.push((samples, *solution)));
        if !rows.is_empty() {
            self.claim();
        }
        for (samples, solution) in &rows {
            read(*samples, solution);
        }
        done
    }

    /// Says what the filter claims.
    pub(super) fn claim(&self) {
        if let (Some(aiding), Some(covariance)) = (&self.aiding, self.twin.covariance()) {
            aiding.claims.claim(&covariance);
        }
    }

    /// Says what became of the measurements.
    pub(super) fn report(&self) {
        if let Some(aiding) = &self.aiding {
            *aiding.claims.report.borrow_mut() = self.twin.report();
        }
    }
}
