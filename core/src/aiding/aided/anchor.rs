//! A velocity to compare the next one with.

use crate::math::vector::Vector;
use crate::record::{Record, record};

/// The velocity at the last measurement of it, after its correction; before the first, that of the start.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Anchor<R> {
    /// Samples at that time.
    pub samples: u64,
    /// North, east, down, m/s.
    pub velocity_ned: Vector<R>,
    /// Its standard deviation, m/s.
    pub sigma: R,
}

impl<R: Record> Record for Anchor<R> {
    record!(samples, velocity_ned, sigma);
}
