//! Navigation that measurements aid.

use super::side::Side;
use super::{Standing, scalars, words};
use crate::aided::report::Report;
use crate::aided::seen::Seen;
use crate::navigator::Reader;
use schuler::aiding::aided::measured::Measured;
use schuler::flight::carried::Carried;
use schuler::flight::catalogue::Entry;
use schuler::link::aided::Linked;
use schuler::link::bytes::Bytes;
use schuler::link::fleet::Fleet;
use schuler::link::flight::Taken;
use schuler::link::message::Start;
use schuler::link::refusal::Refusal;
use schuler::math::real::{Real, Scalar};
use schuler::output::Output;
use schuler::record::Record;
use schuler::sample::Increment;
use schuler::strapdown::block::body::BodyMotion;

/// An aided flight, and what is seen of its filter.
pub(super) struct Aboard<M: Entry> {
    flight: Linked<M>,
    seen: Seen,
}

impl<R, M> Aboard<M>
where
    R: Scalar + Real<Mask = bool> + Record,
    M: Entry<Real = R, Body = BodyMotion<R>>,
{
    /// At the start; it waits for its settings.
    pub(super) fn start(start: &Start, rate_hz: f64) -> Result<Self, Refusal> {
        Ok(Self { flight: Fleet::start(start)?, seen: Seen::new(rate_hz, None) })
    }

    /// Reads the row of a block that has ended since.
    fn read(&self, before: u64, read: &mut Reader) {
        let integrated = self.flight.integrated();
        if integrated != before {
            read(integrated, &self.flight.output().wide());
        }
    }
}

impl<R, M> Side for Aboard<M>
where
    R: Scalar + Real<Mask = bool> + Record,
    M: Entry<Real = R, Body = BodyMotion<R>>,
{
    fn narrow(&mut self, sample: &Increment<f64>, carried: &mut Carried) -> Vec<u8> {
        scalars::<R>(&carried.narrow::<R>(sample))
    }

    fn take(
        &mut self,
        number: u32,
        mut sample: Bytes,
        read: &mut Reader,
    ) -> Result<Taken, Refusal> {
        let before = self.flight.integrated();
        let sample = sample.increment().ok_or(Refusal::Malformed)?;
        let taken = self.flight.take(number, sample, &mut self.seen)?;
        self.read(before, read);
        Ok(taken)
    }

    fn take_unread(&mut self, number: u32, sample: Bytes) -> Result<Taken, Refusal> {
        self.take(number, sample, &mut |_, _| ())
    }

    fn finish(&mut self, samples: u32, read: &mut Reader) -> Result<Taken, Refusal> {
        let before = self.flight.integrated();
        let taken = self.flight.finish(samples, &mut self.seen)?;
        self.read(before, read);
        Ok(taken)
    }

    fn hold(&mut self, vertical: Bytes) -> Result<(), Refusal> {
        Fleet::hold(&mut self.flight, vertical)
    }

    fn aid(&mut self, settings: Bytes) -> Result<(), Refusal> {
        Fleet::aid(&mut self.flight, settings)
    }

    fn measured(&self, measured: &Measured<f64>) -> Vec<u8> {
        words(&Measured::<R>::narrow(measured))
    }

    fn measure(&mut self, number: u32, measured: Bytes) -> Result<Taken, Refusal> {
        Fleet::measure(&mut self.flight, number, measured)
    }

    fn covariance(&self) -> Option<[[f64; 9]; 9]> {
        let (aided, state) = self.flight.flying()?;
        Some(aided.covariance_ned(state).map(|row| row.map(Scalar::widen)))
    }

    fn report(&self) -> Option<Report> {
        self.flight.flying().map(|(_, state)| self.seen.report(state))
    }

    fn standing(&self) -> Standing {
        Standing {
            // When a sample ends, the host's clock says.
            time_ns: 0,
            taken: self.flight.taken(),
            came: self.flight.came(),
            integrated: self.flight.integrated(),
            digest: self.flight.digest(),
            solution: scalars::<R>(&self.flight.output()),
        }
    }

    fn words(&self, read: &mut dyn FnMut(u64)) {
        Fleet::words(&self.flight, read);
    }

    fn restore(&mut self, write: &mut dyn FnMut(u64) -> u64) -> Result<(), Refusal> {
        Fleet::restore(&mut self.flight, write);
        Fleet::check(&self.flight)
    }

    fn bridged(&self) -> u32 {
        Fleet::bridged(&self.flight)
    }
}
