//! The host's twin of the target: the same code, fed with the same bytes.
//!
//! | file | what it has |
//! |---|---|
//! | [`application`] | the target's application on this machine |
//! | `side` | what the twins of all kinds do |
//! | `chosen` | the one that a beginning asks for |
//! | `plain` | navigation by inertia alone |
//! | `aided` | navigation that measurements aid |
//! | `unit` | a unit that stands still, and identifies itself |

mod aided;
pub mod application;
mod chosen;
mod plain;
mod side;
mod unit;

use crate::aided::report::Report;
use crate::aided::settings;
use crate::navigator::Reader;
use crate::scene::Scene;
use schuler::aiding::aided::measured::Measured;
use schuler::allan::octaves::Point;
use schuler::flight::carried::Carried;
use schuler::flight::configuration::{Configuration, Precision};
use schuler::link::bytes::Bytes;
use schuler::link::flight::Taken;
use schuler::link::gap::Policy;
use schuler::link::message::Start;
use schuler::link::offer::{Offer, Purpose};
use schuler::link::refusal::Refusal;
use schuler::math::compensated::Pair;
use schuler::math::real::Scalar;
use schuler::record::Record;
use schuler::sample::Increment;
use schuler::solution::Solution;
use side::Side;

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
#[derive(Clone, Debug, PartialEq)]
pub struct Beginning {
    /// What is flown.
    pub configuration: Configuration,
    purpose: Purpose,
    /// Samples per second, for whoever reads a clock.
    rate_hz: f64,
    /// The settings of an aided flight, as they cross the line.
    settings: Option<Vec<u8>>,
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
        let rate_hz = interval_s.reciprocal().hi;
        let purpose = Purpose::Navigation;
        Self { configuration, purpose, rate_hz, settings: None, order, gap, initial }
    }

    /// With the filter of a scene's aided navigator.
    pub fn aided(self, scene: &Scene) -> Self {
        let settings = match self.configuration.precision {
            Precision::F64 => words(&settings::of(scene)),
            Precision::F32 | Precision::F32x2 => {
                words(&settings::narrow::<f32>(&settings::of(scene)))
            }
        };
        let rate_hz = scene.rate_hz;
        Self { purpose: Purpose::Aiding, rate_hz, settings: Some(settings), ..self }
    }

    /// The identification of a unit at rest, in a precision.
    pub fn identification(precision: Precision, rate_hz: f64) -> Self {
        let Offer { purpose, configuration } = Offer::identification(precision);
        let interval_s = Pair::new(rate_hz).reciprocal();
        let initial = Solution::default();
        let plain = Self::new(configuration, 0, Policy::Refuse, interval_s, &initial);
        Self { purpose, rate_hz, ..plain }
    }

    /// The settings of an aided flight, as they cross the line.
    pub fn settings(&self) -> Option<&[u8]> {
        self.settings.as_deref()
    }

    /// Samples per second.
    pub fn rate_hz(&self) -> f64 {
        self.rate_hz
    }

    /// What a missing sample does.
    pub fn gap(&self) -> Policy {
        self.gap
    }

    /// The payload of a start.
    pub fn start(&self) -> Start<'_> {
        let Self { order, gap, initial, .. } = self;
        Start { offer: self.offer(), order: *order, gap: *gap, initial: Bytes(initial) }
    }

    /// What a target must offer for it.
    pub fn offer(&self) -> Offer {
        Offer { purpose: self.purpose, configuration: self.configuration }
    }
}

/// What is flown on this side.
pub struct Twin {
    side: Box<dyn Side>,
    carried: Carried,
}

impl Twin {
    /// At the start.
    pub fn start(beginning: &Beginning) -> Result<Self, Refusal> {
        Ok(Self { side: chosen::start(beginning)?, carried: Carried::default() })
    }

    /// The next sample in the navigator's digits, as it crosses the line: what rounding drops is added to
    /// the next one.
    pub fn narrow(&mut self, sample: &Increment<f64>) -> Vec<u8> {
        self.side.narrow(sample, &mut self.carried)
    }

    /// Takes a sample, and reads the rows that it completes.
    pub fn take(
        &mut self,
        number: u32,
        increment: &[u8],
        read: &mut Reader,
    ) -> Result<Taken, Refusal> {
        self.side.take(number, Bytes(increment), read)
    }

    /// Takes a sample; no row is read.
    pub fn take_unread(&mut self, number: u32, increment: &[u8]) -> Result<Taken, Refusal> {
        self.side.take_unread(number, Bytes(increment))
    }

    /// Ends the stream after so many samples, and reads the rows that are left.
    pub fn finish(&mut self, samples: u32, read: &mut Reader) -> Result<Taken, Refusal> {
        self.side.finish(samples, read)
    }

    /// Height (m) and vertical velocity (down, m/s) as they cross the line.
    pub fn vertical(&mut self, altitude_m: f64, down_m_s: f64) -> Vec<u8> {
        self.side.vertical([altitude_m, down_m_s])
    }

    /// Sets height and vertical velocity.
    pub fn hold(&mut self, vertical: &[u8]) -> Result<(), Refusal> {
        self.side.hold(Bytes(vertical))
    }

    /// Takes the settings of its filter.
    pub fn aid(&mut self, settings: &[u8]) -> Result<(), Refusal> {
        self.side.aid(Bytes(settings))
    }

    /// A measurement in the navigator's digits, as it crosses the line.
    pub fn measured(&self, measured: &Measured<f64>) -> Vec<u8> {
        self.side.measured(measured)
    }

    /// Takes the measurement of a number, from 1.
    pub fn measure(&mut self, number: u32, measured: &[u8]) -> Result<Taken, Refusal> {
        self.side.measure(number, Bytes(measured))
    }

    /// The covariance of its drift by its filter, if it has one: position, velocity, attitude, north, east, down,
    /// m, m/s, rad.
    pub fn covariance(&self) -> Option<[[f64; 9]; 9]> {
        self.side.covariance()
    }

    /// What became of the measurements, if there are any.
    pub fn report(&self) -> Option<Report> {
        self.side.report()
    }

    /// Its Allan sums, if it identifies itself: gyros x, y, z, then accelerometers.
    pub fn points(&self) -> Option<[Vec<Point<f64>>; 6]> {
        self.side.points()
    }

    /// Where it stands.
    pub fn standing(&self) -> Standing {
        self.side.standing()
    }

    /// The words of its state, as they cross the line.
    pub fn words(&self) -> Vec<u8> {
        let mut words = Vec::new();
        self.side.words(&mut |bits| words.extend_from_slice(&bits.to_le_bytes()));
        words
    }

    /// Writes [`words`](Self::words) over its state; refuses what cannot be one.
    pub fn restore(&mut self, words: &[u8]) -> Result<(), Refusal> {
        let (words, _) = words.as_chunks();
        let mut words = words.iter().map(|&bytes| u64::from_le_bytes(bytes));
        self.side.restore(&mut |_| words.next().unwrap_or_default())
    }

    /// Samples that were filled in.
    pub fn bridged(&self) -> u32 {
        self.side.bridged()
    }
}

/// An interval and an initial solution as they cross the line.
fn beginning<R: Scalar + Record>(interval_s: Pair<f64>, initial: &Solution<f64>) -> Vec<u8> {
    let interval_s = scalars::<R>(&Pair::<R>::narrow(interval_s));
    [interval_s, scalars::<R>(&Solution::<R>::narrow(initial))].concat()
}

/// A record's words as scalars on the line.
pub(crate) fn scalars<R: Scalar>(record: &impl Record) -> Vec<u8> {
    let mut bytes = Vec::new();
    record.record("", &mut |_, bits| {
        bytes.extend_from_slice(&bits.to_le_bytes()[..size_of::<R>()]);
    });
    bytes
}

/// A record's words, eight bytes each.
pub(crate) fn words(record: &impl Record) -> Vec<u8> {
    let mut bytes = Vec::new();
    record.record("", &mut |_, bits| bytes.extend_from_slice(&bits.to_le_bytes()));
    bytes
}
