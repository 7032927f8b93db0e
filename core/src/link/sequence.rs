//! Sequence numbers at the receiver: missing, repeated and late frames.
//!
//! ```
//! use schuler::link::counters::Counters;
//! use schuler::link::sequence::{Arrival, Sequence};
//!
//! let mut counters = Counters::default();
//! let mut received = Sequence::after(7);
//! assert_eq!(received.arrive(8, &mut counters), Arrival::New);
//! assert_eq!(received.arrive(8, &mut counters), Arrival::Duplicate);
//! assert_eq!(received.arrive(7, &mut counters), Arrival::Late);
//! ```

use super::counters::{Counters, count};

/// How a frame stands to those before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Arrival {
    /// Newer than all before.
    New,
    /// The last one again.
    Duplicate,
    /// Older than the last one.
    Late,
}

/// The last sequence number that came.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Sequence {
    last: Option<u32>,
}

impl Sequence {
    /// After a frame of this number.
    pub fn after(last: u32) -> Self {
        Self { last: Some(last) }
    }

    /// Places a frame among those before it, and counts what that shows. The first one may have any
    /// number.
    pub fn arrive(&mut self, number: u32, counters: &mut Counters) -> Arrival {
        let ahead = self.last.map_or(1, |last| number.wrapping_sub(last).cast_signed());
        match ahead {
            1.. => {
                counters.missing = counters.missing.saturating_add(ahead.unsigned_abs() - 1);
                self.last = Some(number);
                Arrival::New
            }
            0 => {
                count(&mut counters.duplicated);
                Arrival::Duplicate
            }
            _ => {
                count(&mut counters.late);
                Arrival::Late
            }
        }
    }
}
