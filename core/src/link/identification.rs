//! A unit that stands still identifies itself: the Allan sums of its six axes, sample by sample.
//!
//! It is started, fed and restored as a flight is. Its state are the sums: who reads it has the deviation of each axis,
//! bit for bit.
//!
//! ```
//! use schuler::link::identification::Identification;
//! use schuler::link::flight::Taken;
//! use schuler::math::vector::Vector;
//! use schuler::sample::Increment;
//!
//! let mut unit = Identification::<f32>::new(0.01)?;
//! for (number, x) in (1..).zip([1e-3, 3e-3, 2e-3, 2e-3]) {
//!     let sample = Increment { angle_b: Vector::new(x, 0.0, 0.0), velocity_b: Vector::ZERO };
//!     assert_eq!(unit.take(number, &sample), Ok(Taken::Flown));
//! }
//! let [gyro_x, ..] = unit.axes();
//! assert_eq!((gyro_x.samples(), gyro_x.points().count()), (4, 2));
//! # Ok::<(), schuler::allan::octaves::Refused>(())
//! ```

use super::bytes::Bytes;
use super::count::Count;
use super::fleet::{Fleet, Visitor};
use super::flight::Taken;
use super::frame::Writer;
use super::message::Start;
use super::offer::Offer;
use super::refusal::Refusal;
use crate::allan::octaves::{Octaves, Refused, Sums};
use crate::digest::Digest;
use crate::flight::configuration::Precision;
use crate::record::{Record, record};
use crate::sample::Increment;

/// The Allan sums of three gyros and three accelerometers.
#[derive(Clone, Copy, Debug)]
pub struct Identification<R: Sums> {
    axes: [Octaves<R>; 6],
    /// Of every sample.
    digest: Digest,
    count: Count,
}

#[cfg(feature = "defmt")]
impl<R: Sums> defmt::Format for Identification<R> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "Identification {{ count: {} }}", self.count);
    }
}

/// A scalar in whose precision units identify themselves.
pub trait Identified: Sums + Record + Send + 'static {
    /// The precision.
    const PRECISION: Precision;
}

impl Identified for f32 {
    const PRECISION: Precision = Precision::F32;
}

impl Identified for f64 {
    const PRECISION: Precision = Precision::F64;
}

impl<R: Sums + Record> Identification<R> {
    /// For samples of an interval, s.
    pub fn new(interval_s: R) -> Result<Self, Refused> {
        let axis = Octaves::new(interval_s)?;
        Ok(Self { axes: [axis; 6], digest: Digest::default(), count: Count::default() })
    }

    /// Gyros x, y, z, then accelerometers.
    pub fn axes(&self) -> &[Octaves<R>; 6] {
        &self.axes
    }

    /// Of the last 32 samples a bit each: none of them is missing.
    pub fn came(&self) -> u32 {
        self.count.came()
    }

    /// Digest of every sample so far.
    pub fn digest(&self) -> u64 {
        self.digest.value()
    }

    /// Takes the sample of a number, from 1. None may be missing: what is filled in would look like a sensor.
    pub fn take(&mut self, number: u32, sample: &Increment<R>) -> Result<Taken, Refusal> {
        match self.count.before(number)? {
            None => return Ok(Taken::Again),
            Some(0) => {}
            Some(_) => return Err(Refusal::Gap),
        }
        let (angle, velocity) = (sample.angle_b.into_array(), sample.velocity_b.into_array());
        let six = || angle.into_iter().chain(velocity);
        if !six().all(Octaves::<R>::takes) {
            return Err(Refusal::Malformed);
        }
        for (axis, increment) in self.axes.iter_mut().zip(six()) {
            axis.add(increment).map_err(|_| Refusal::Malformed)?;
        }
        self.digest.add(sample);
        self.count.take(number, 0);
        Ok(Taken::Flown)
    }
}

impl<R: Identified> Fleet for Identification<R> {
    fn offers(offer: &mut impl FnMut(Offer)) {
        offer(Offer::identification(R::PRECISION));
    }

    fn start(start: &Start) -> Result<Self, Refusal> {
        if start.offer != Offer::identification(R::PRECISION) {
            return Err(Refusal::Configuration);
        }
        let (interval_s, _) = start.beginning::<R>()?;
        Self::new(interval_s.hi).map_err(|_| Refusal::Malformed)
    }

    fn take(&mut self, number: u32, mut increment: Bytes) -> Result<Taken, Refusal> {
        let sample = increment.increment().ok_or(Refusal::Malformed)?;
        increment.end().ok_or(Refusal::Malformed)?;
        Identification::take(self, number, &sample)
    }

    fn hold(&mut self, _: Bytes) -> Result<(), Refusal> {
        // Who stands still holds nothing.
        Err(Refusal::Malformed)
    }

    fn finish(&mut self, samples: u32) -> Result<Taken, Refusal> {
        match self.count.before_end(samples) {
            Ok(None) => Ok(Taken::Again),
            Ok(Some(0)) => {
                self.count.end(samples, 0);
                Ok(Taken::Flown)
            }
            _ => Err(Refusal::Count),
        }
    }

    fn taken(&self) -> u32 {
        self.count.taken()
    }

    fn bridged(&self) -> u32 {
        0
    }

    fn write(&self, to: &mut Writer) {
        self.count.write(self.count.taken().into(), to);
        to.u64(self.digest());
    }

    fn words(&self, read: &mut dyn FnMut(u64)) {
        self.record("", &mut |_, bits| read(bits));
    }

    fn restore(&mut self, write: &mut dyn FnMut(u64) -> u64) {
        Record::restore(self, "", &mut |_, bits| write(bits));
    }

    fn check(&self) -> Result<(), Refusal> {
        let counted = |axis: &Octaves<R>| axis.samples() == self.count.taken().into();
        for axis in &self.axes {
            axis.check()?;
        }
        let sound = self.axes.iter().all(counted)
            && self.digest.is_plausible()
            && self.count.is_plausible();
        if sound { Ok(()) } else { Err(Refusal::Damaged) }
    }

    fn visit<V: Visitor>(&mut self, _: V) -> Option<V::Result> {
        None
    }
}

impl<R: Sums + Record> Record for Identification<R> {
    record!(axes, digest, count);
}
