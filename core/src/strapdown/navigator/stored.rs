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

impl<F: Frame<Real: Record> + Record, W: Window> Record for State<F, W> {
    fn record(&mut self, name: &'static str, visit: &mut impl FnMut(&'static str, u64) -> u64) {
        self.frame.record(name, visit);
        for sample in self.samples.as_mut() {
            sample.record("samples", visit);
        }
        self.filled.record("filled", visit);
        self.pending.record("pending", visit);
        self.integrated.record("integrated", visit);
        self.seeded.record("seeded", visit);
        self.intervals.each(|name, number| number.record(name, visit));
        self.edges.record("edges", visit);
    }
}
