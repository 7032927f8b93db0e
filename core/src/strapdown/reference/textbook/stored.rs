//! The byte form of the textbook's state.

use super::body::Compensated;
use super::{TextbookFrame, TextbookState};
use crate::record::{Record, record};

impl<R: Record> Record for Compensated<R> {
    record!(rotation, velocity);
}

impl<F: TextbookFrame<Real: Record> + Record> Record for TextbookState<F> {
    record!(frame; previous, integrated);
}
