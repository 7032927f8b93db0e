//! The host's twin of the target: the same code, fed with the same bytes.

pub mod application;

use crate::navigator::{self, Reader};
use schuler::flight::carried::Carried;
use schuler::flight::catalogue::Entry;
use schuler::flight::configuration::{Configuration, Precision};
use schuler::link::bytes::Bytes;
use schuler::link::fleet::{Every, Fleet, Visitor};
use schuler::link::flight::{LinkedFlight, Taken};
use schuler::link::gap::Policy;
use schuler::link::message::Start;
use schuler::link::refusal::Refusal;
use schuler::math::compensated::Pair;
use schuler::math::real::Scalar;
use schuler::record::Record;
use schuler::sample::Increment;
use schuler::solution::Solution;
use std::cell::RefCell;

/// Where a navigator stands: [`schuler::link::message::Standing`] with its own bytes.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Standing {
    /// End of the last sample that came, ns.
    pub time_ns: u64,
    /// Number of the last sample.
    pub taken: u32,
    /// Of the last 32 a bit each: whether it came.
    pub came: u32,
    /// Samples behind the solution.
    pub integrated: u64,
    /// Digest of every state so far.
    pub digest: u64,
    /// The solution's scalars.
    pub solution: Vec<u8>,
}

/// How a flight is started on either side.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Beginning {
    /// What is flown.
    pub configuration: Configuration,
    order: u8,
    gap: Policy,
    /// Interval and initial solution as they cross the line.
    initial: Vec<u8>,
}

impl Beginning {
    /// From an interval in seconds and an initial solution, narrowed once.
    pub fn new(
        configuration: Configuration,
        order: usize,
        gap: Policy,
        interval_s: Pair<f64>,
        initial: &Solution<f64>,
    ) -> Self {
        let initial = if configuration.precision == Precision::F64 {
            beginning::<f64>(interval_s, initial)
        } else {
            beginning::<f32>(interval_s, initial)
        };
        // No window has a series of more terms.
        let order = order.min(usize::from(u8::MAX)) as u8;
        Self { configuration, order, gap, initial }
    }

    /// What a missing sample does.
    pub fn gap(&self) -> Policy {
        self.gap
    }

    /// The payload of a start.
    pub fn start(&self) -> Start<'_> {
        let Self { configuration, order, gap, initial } = self;
        Start { configuration: *configuration, order: *order, gap: *gap, initial: Bytes(initial) }
    }
}

/// What is flown on this side.
#[derive(Clone)]
pub struct Twin {
    flight: Every,
    carried: Carried,
}

impl Twin {
    /// At the start.
    pub fn start(beginning: &Beginning) -> Result<Self, Refusal> {
        Ok(Self { flight: Every::start(&beginning.start())?, carried: Carried::default() })
    }

    /// The next sample in the navigator's digits, as it crosses the line: what rounding drops is added to
    /// the next one.
    pub fn narrow(&mut self, sample: &Increment<f64>) -> Vec<u8> {
        self.flight.visit(Narrow(sample, &mut self.carried))
    }

    /// Takes a sample, and reads the rows that it completes.
    pub fn take(
        &mut self,
        number: u32,
        increment: &[u8],
        read: &mut Reader,
    ) -> Result<Taken, Refusal> {
        self.flight.visit(Take(number, Bytes(increment), read))
    }

    /// Takes a sample; no row is read.
    pub fn take_unread(&mut self, number: u32, increment: &[u8]) -> Result<Taken, Refusal> {
        self.flight.take(number, Bytes(increment))
    }

    /// Ends the stream after so many samples, and reads the rows that are left.
    pub fn finish(&mut self, samples: u32, read: &mut Reader) -> Result<Taken, Refusal> {
        self.flight.visit(Finish(samples, read))
    }

    /// Height (m) and vertical velocity (down, m/s) as they cross the line.
    pub fn vertical(&mut self, altitude_m: f64, down_m_s: f64) -> Vec<u8> {
        self.flight.visit(Vertical([altitude_m, down_m_s]))
    }

    /// Sets height and vertical velocity.
    pub fn hold(&mut self, vertical: &[u8]) -> Result<(), Refusal> {
        self.flight.hold(Bytes(vertical))
    }

    /// Where it stands.
    pub fn standing(&self) -> Standing {
        let mut flight = self.flight;
        flight.visit(Stand)
    }

    /// The words of its state, as they cross the line.
    pub fn words(&self) -> Vec<u8> {
        let mut words = Vec::new();
        self.flight.words(&mut |bits| words.extend_from_slice(&bits.to_le_bytes()));
        words
    }

    /// Writes [`words`](Self::words) over its state; refuses what cannot be one.
    pub fn restore(&mut self, words: &[u8]) -> Result<(), Refusal> {
        let (words, _) = words.as_chunks();
        let mut words = words.iter().map(|&bytes| u64::from_le_bytes(bytes));
        self.flight.restore(&mut |_| words.next().unwrap_or_default());
        self.flight.check()
    }

    /// Samples that were filled in.
    pub fn bridged(&self) -> u32 {
        self.flight.bridged()
    }
}

/// An interval and an initial solution as they cross the line.
fn beginning<R: Scalar + Record>(interval_s: Pair<f64>, initial: &Solution<f64>) -> Vec<u8> {
    let interval_s = scalars::<R>(&Pair::<R>::narrow(interval_s));
    [interval_s, scalars::<R>(&Solution::<R>::narrow(initial))].concat()
}

/// A record's words as scalars on the line.
fn scalars<R: Scalar>(record: &impl Record) -> Vec<u8> {
    let mut bytes = Vec::new();
    record.record("", &mut |_, bits| {
        bytes.extend_from_slice(&bits.to_le_bytes()[..size_of::<R>()]);
    });
    bytes
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
