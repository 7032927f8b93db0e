//! The byte form of a navigator's state: stored and read back, it goes on bit for bit.

use super::frame::Frame;
use super::navigator::State;
use super::textbook::{TextbookFrame, TextbookState};
use super::window::Window;
use crate::record::Record;
use crate::sample::Increment;

impl<R: Record> Record for Increment<R> {
    fn record(&mut self, name: &'static str, visit: &mut impl FnMut(&'static str, u64) -> u64) {
        self.angle_b.record(name, visit);
        self.velocity_b.record(name, visit);
    }
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
    }
}

impl<F: TextbookFrame<Real: Record> + Record> Record for TextbookState<F> {
    fn record(&mut self, name: &'static str, visit: &mut impl FnMut(&'static str, u64) -> u64) {
        self.frame.record(name, visit);
        self.previous.record("previous", visit);
        self.integrated.record("integrated", visit);
    }
}
