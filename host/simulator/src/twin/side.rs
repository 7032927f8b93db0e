//! What the twins of all kinds do.

use super::Standing;
use crate::aided::report::Report;
use crate::navigator::Reader;
use schuler::aiding::aided::measured::Measured;
use schuler::allan::octaves::Point;
use schuler::flight::carried::Carried;
use schuler::link::bytes::Bytes;
use schuler::link::flight::Taken;
use schuler::link::refusal::Refusal;
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
