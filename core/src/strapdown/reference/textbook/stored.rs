//! The byte form of the textbook's state.

use super::body::Compensated;
use super::{TextbookFrame, TextbookState};
use crate::record::{Record, record};

impl<R: Record> Record for Compensated<R> {
    record!(rotation, velocity);
}

impl<F: TextbookFrame<Real: Record> + Record> Record for TextbookState<F> {
    fn record(&mut self, name: &'static str, visit: &mut impl FnMut(&'static str, u64) -> u64) {
        self.frame.record(name, visit);
        self.previous.record("previous", visit);
        self.integrated.record("integrated", visit);
    }
}
