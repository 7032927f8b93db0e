//! The byte form of a navigator's state: stored and read back, it goes on bit for bit.

use super::body::BodyMotion;
use super::frame::Frame;
use super::navigator::{Edges, State};
use super::newton::Used;
use super::textbook::body::Compensated;
use super::textbook::{TextbookFrame, TextbookState};
use super::unequal::Intervals as _;
use super::window::Window;
use crate::math::real::Real;
use crate::record::{Record, record};
use crate::sample::Increment;

impl<R: Record> Record for Increment<R> {
    record!(angle_b, velocity_b);
}

impl<R: Real + Record> Record for BodyMotion<R> {
    record!(rotation, rotation_low, velocity, velocity_low, position);
}

impl<R: Record> Record for Compensated<R> {
    record!(rotation, velocity);
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

impl<F: TextbookFrame<Real: Record> + Record> Record for TextbookState<F> {
    fn record(&mut self, name: &'static str, visit: &mut impl FnMut(&'static str, u64) -> u64) {
        self.frame.record(name, visit);
        self.previous.record("previous", visit);
        self.integrated.record("integrated", visit);
    }
}
