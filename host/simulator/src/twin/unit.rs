//! A unit that stands still, and identifies itself.

use super::side::Side;
use super::{Standing, scalars};
use crate::navigator::Reader;
use schuler::allan::octaves::Point;
use schuler::flight::carried::Carried;
use schuler::link::bytes::Bytes;
use schuler::link::fleet::Fleet;
use schuler::link::flight::Taken;
use schuler::link::identification::{Identification, Identified};
use schuler::link::refusal::Refusal;
use schuler::sample::Increment;

impl<R: Identified> Side for Identification<R> {
    fn narrow(&mut self, sample: &Increment<f64>, carried: &mut Carried) -> Vec<u8> {
        scalars::<R>(&carried.narrow::<R>(sample))
    }

    fn take(&mut self, number: u32, sample: Bytes, _: &mut Reader) -> Result<Taken, Refusal> {
        Fleet::take(self, number, sample)
    }

    fn take_unread(&mut self, number: u32, sample: Bytes) -> Result<Taken, Refusal> {
        Fleet::take(self, number, sample)
    }

    fn finish(&mut self, samples: u32, _: &mut Reader) -> Result<Taken, Refusal> {
        Fleet::finish(self, samples)
    }

    fn hold(&mut self, vertical: Bytes) -> Result<(), Refusal> {
        Fleet::hold(self, vertical)
    }

    fn points(&self) -> Option<[Vec<Point<f64>>; 6]> {
        Some(self.axes().map(|axis| {
            let wide = |point: Point<R>| Point {
                samples: point.samples,
                tau_s: point.tau_s.widen(),
                variance: point.variance.widen(),
                differences: point.differences,
            };
            axis.points().map(wide).collect()
        }))
    }

    fn standing(&self) -> Standing {
        Standing {
            // When a sample ends, the host's clock says.
            time_ns: 0,
            taken: Fleet::taken(self),
            came: self.came(),
            integrated: Fleet::taken(self).into(),
            digest: self.digest(),
            solution: Vec::new(),
        }
    }

    fn words(&self, read: &mut dyn FnMut(u64)) {
        Fleet::words(self, read);
    }

    fn restore(&mut self, write: &mut dyn FnMut(u64) -> u64) -> Result<(), Refusal> {
        Fleet::restore(self, write);
        Fleet::check(self)
    }

    fn bridged(&self) -> u32 {
        0
    }
}
