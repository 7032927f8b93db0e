//! What the twins of all kinds do, and which one it is.

use super::aided::Aboard;
use super::{Beginning, Standing};
use crate::aided::report::Report;
use crate::navigator::Reader;
use schuler::aiding::aided::measured::Measured;
use schuler::allan::octaves::Point;
use schuler::flight::carried::Carried;
use schuler::flight::configuration::{Axes, Precision};
use schuler::link::bytes::Bytes;
use schuler::link::fleet::{Every, Fleet};
use schuler::link::flight::Taken;
use schuler::link::identification::Identification;
use schuler::link::offer::Purpose;
use schuler::link::refusal::Refusal;
use schuler::navigators::{EarthFixedNavigator4, Navigator4};
use schuler::sample::Increment;

/// What is flown on this side.
pub(super) trait Side: Send {
    /// A sample in its digits.
    fn narrow(&mut self, sample: &Increment<f64>, carried: &mut Carried) -> Vec<u8>;
    /// Takes a sample, and reads the rows that it completes.
    fn take(&mut self, number: u32, sample: Bytes, read: &mut Reader) -> Result<Taken, Refusal>;
    /// Takes a sample; no row is read.
    fn take_unread(&mut self, number: u32, sample: Bytes) -> Result<Taken, Refusal>;
    /// Ends the stream, and reads the rows that are left.
    fn finish(&mut self, samples: u32, read: &mut Reader) -> Result<Taken, Refusal>;
    /// Height and vertical velocity in its digits.
    fn vertical(&mut self, _: [f64; 2]) -> Vec<u8> {
        Vec::new()
    }
    /// Sets them.
    fn hold(&mut self, vertical: Bytes) -> Result<(), Refusal>;
    /// Takes the settings of a filter.
    fn aid(&mut self, _: Bytes) -> Result<(), Refusal> {
        Err(Refusal::Unaided)
    }
    /// A measurement in its digits.
    fn measured(&self, _: &Measured<f64>) -> Vec<u8> {
        Vec::new()
    }
    /// Takes a measurement.
    fn measure(&mut self, _: u32, _: Bytes) -> Result<Taken, Refusal> {
        Err(Refusal::Unaided)
    }
    /// The covariance of its drift by its filter.
    fn covariance(&self) -> Option<[[f64; 9]; 9]> {
        None
    }
    /// What became of the measurements.
    fn report(&self) -> Option<Report> {
        None
    }
    /// Its Allan sums.
    fn points(&self) -> Option<[Vec<Point<f64>>; 6]> {
        None
    }
    /// Where it stands.
    fn standing(&self) -> Standing;
    /// The words of its state.
    fn words(&self, read: &mut dyn FnMut(u64));
    /// Writes them, and checks what is written.
    fn restore(&mut self, write: &mut dyn FnMut(u64) -> u64) -> Result<(), Refusal>;
    /// Samples filled in.
    fn bridged(&self) -> u32;
}

/// The side that a beginning asks for.
pub(super) fn start(beginning: &Beginning) -> Result<Box<dyn Side>, Refusal> {
    let (start, rate_hz) = (beginning.start(), beginning.rate_hz());
    let (precision, axes) = (beginning.configuration.precision, beginning.configuration.axes);
    match (start.offer.purpose, precision, axes) {
        (Purpose::Navigation, ..) => Ok(Box::new(Every::start(&start)?)),
        (Purpose::Aiding, Precision::F64, Axes::LocalLevel) => {
            Ok(Box::new(Aboard::<Navigator4<f64>>::start(&start, rate_hz)?))
        }
        (Purpose::Aiding, Precision::F64, Axes::EarthFixed) => {
            Ok(Box::new(Aboard::<EarthFixedNavigator4<f64>>::start(&start, rate_hz)?))
        }
        (Purpose::Aiding, _, Axes::LocalLevel) => {
            Ok(Box::new(Aboard::<Navigator4<f32>>::start(&start, rate_hz)?))
        }
        (Purpose::Aiding, _, Axes::EarthFixed) => {
            Ok(Box::new(Aboard::<EarthFixedNavigator4<f32>>::start(&start, rate_hz)?))
        }
        (Purpose::Identification, Precision::F64, _) => {
            Ok(Box::new(Identification::<f64>::start(&start)?))
        }
        (Purpose::Identification, ..) => Ok(Box::new(Identification::<f32>::start(&start)?)),
    }
}
