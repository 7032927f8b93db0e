//! Navigation by inertia alone, whatever the mechanization.

use super::side::Side;
use super::{Standing, scalars};
use crate::navigator::{self, Reader};
use schuler::flight::carried::Carried;
use schuler::flight::catalogue::Entry;
use schuler::link::bytes::Bytes;
use schuler::link::fleet::{Every, Fleet, Visitor};
use schuler::link::flight::{LinkedFlight, Taken};
use schuler::link::refusal::Refusal;
use schuler::math::compensated::Pair;
use schuler::math::real::Scalar;
use schuler::sample::Increment;
use std::cell::RefCell;

/// Each of them is a mechanization alone, and so is visited.
impl Side for Every {
    fn narrow(&mut self, sample: &Increment<f64>, carried: &mut Carried) -> Vec<u8> {
        self.visit(Narrow(sample, carried)).unwrap_or_default()
    }

    fn take(&mut self, number: u32, sample: Bytes, read: &mut Reader) -> Result<Taken, Refusal> {
        self.visit(Take(number, sample, read)).unwrap_or(Err(Refusal::Configuration))
    }

    fn take_unread(&mut self, number: u32, sample: Bytes) -> Result<Taken, Refusal> {
        Fleet::take(self, number, sample)
    }

    fn finish(&mut self, samples: u32, read: &mut Reader) -> Result<Taken, Refusal> {
        self.visit(Finish(samples, read)).unwrap_or(Err(Refusal::Configuration))
    }

    fn vertical(&mut self, vertical: [f64; 2]) -> Vec<u8> {
        self.visit(Vertical(vertical)).unwrap_or_default()
    }

    fn hold(&mut self, vertical: Bytes) -> Result<(), Refusal> {
        Fleet::hold(self, vertical)
    }

    fn standing(&self) -> Standing {
        let mut flight = *self;
        flight.visit(Stand).unwrap_or_default()
    }

    fn words(&self, read: &mut dyn FnMut(u64)) {
        Fleet::words(self, read);
    }

    fn restore(&mut self, write: &mut dyn FnMut(u64) -> u64) -> Result<(), Refusal> {
        Fleet::restore(self, write);
        Fleet::check(self)
    }

    fn bridged(&self) -> u32 {
        Fleet::bridged(self)
    }
}

struct Narrow<'a>(&'a Increment<f64>, &'a mut Carried);

impl Visitor for Narrow<'_> {
    type Result = Vec<u8>;
    fn visit<M: Entry>(self, _: &mut LinkedFlight<M>) -> Vec<u8> {
        let Self(sample, carried) = self;
        scalars::<M::Real>(&carried.narrow::<M::Real>(sample))
    }
}

struct Take<'a, 'b>(u32, Bytes<'a>, &'a mut Reader<'b>);

impl Visitor for Take<'_, '_> {
    type Result = Result<Taken, Refusal>;
    fn visit<M: Entry>(self, flight: &mut LinkedFlight<M>) -> Self::Result {
        let Self(number, mut increment, read) = self;
        let sample = increment.increment().ok_or(Refusal::Malformed)?;
        flight.take(number, sample, |m, state, sample| navigator::push(m, state, sample, read))
    }
}

struct Finish<'a, 'b>(u32, &'a mut Reader<'b>);

impl Visitor for Finish<'_, '_> {
    type Result = Result<Taken, Refusal>;
    fn visit<M: Entry>(self, flight: &mut LinkedFlight<M>) -> Self::Result {
        let Self(samples, read) = self;
        let read = RefCell::new(read);
        flight.finish(
            samples,
            |m, state, sample| navigator::push(m, state, sample, *read.borrow_mut()),
            |m, state| navigator::finish(m, state, *read.borrow_mut()),
        )
    }
}

struct Vertical([f64; 2]);

impl Visitor for Vertical {
    type Result = Vec<u8>;
    fn visit<M: Entry>(self, _: &mut LinkedFlight<M>) -> Vec<u8> {
        let [hi, lo] = self.0.map(M::Real::narrow);
        scalars::<M::Real>(&Pair { hi, lo })
    }
}

struct Stand;

impl Visitor for Stand {
    type Result = Standing;
    fn visit<M: Entry>(self, flight: &mut LinkedFlight<M>) -> Standing {
        Standing {
            // When a sample ends, the host's clock says.
            time_ns: 0,
            taken: flight.taken(),
            came: flight.came(),
            integrated: flight.integrated(),
            digest: flight.digest(),
            solution: scalars::<M::Real>(&flight.output()),
        }
    }
}
