//! The byte form of a navigator's state: a restored state continues bit for bit.

use crate::math::real::Real;
use crate::record::{Record, record};
use crate::sample::Increment;
use crate::strapdown::block::body::BodyMotion;
use crate::strapdown::block::intervals::Intervals as _;
use crate::strapdown::block::newton::Edges;
use crate::strapdown::block::newton::Used;
use crate::strapdown::block::window::Window;
use crate::strapdown::frame::Frame;
use crate::strapdown::navigator::State;
use crate::strapdown::navigator::stream::Progress;

impl<R: Record> Record for Increment<R> {
    record!(angle_b, velocity_b);
}

impl<R: Real + Record> Record for BodyMotion<R> {
    record!(rotation, rotation_low, velocity, velocity_low, position);
}

impl<R: Record> Record for Used<R> {
    record!(gyro, accelerometer);
}

impl<R: Record> Record for Edges<R> {
    record!(first, last);
}

/// Its counts. The samples at the edges follow the intervals.
impl<R> Record for Progress<R> {
    record!(filled, pending, integrated, seeded);
}

impl<F: Frame<Real: Record> + Record, W: Window> Record for State<F, W> {
    fn record(&self, name: &'static str, read: &mut impl FnMut(&'static str, u64)) {
        self.frame.record(name, read);
        self.samples.as_ref().record("samples", read);
        self.progress.record(name, read);
        self.intervals.record_kept(read);
        self.progress.edges.record("edges", read);
    }
    fn restore(&mut self, name: &'static str, write: &mut impl FnMut(&'static str, u64) -> u64) {
        self.frame.restore(name, write);
        self.samples.as_mut().restore("samples", write);
        self.progress.restore(name, write);
        self.intervals.restore_kept(write);
        self.progress.edges.restore("edges", write);
    }
}
