//! Counters of errors on the link.
//!
//! One rule for every number of 32 bits that counts up on the link:
//!
//! | what | at its end | such as |
//! |---|---|---|
//! | the number of a frame, or of a start | wraps to 0: only differences are looked at | [`Header::sequence`](super::frame::Header::sequence), `boot` |
//! | a statistic | stays at its largest value: it never looks as if nothing had happened | everything in [`Counters`] |
//! | the number of a sample | is refused: a sample counts once, or not at all | [`Bridge`](super::gap::Bridge)'s missing ones |
//!
//! ```
//! use schuler::link::counters::Dropped;
//!
//! let dropped = Dropped { check: u32::MAX, short: 1, ..Dropped::default() };
//! assert_eq!(dropped.total(), u32::MAX);
//! ```

use crate::record::{Record, record};

/// One more of a statistic.
#[inline]
pub(super) fn count(statistic: &mut u32) {
    *statistic = statistic.saturating_add(1);
}

/// Frames that a decoder dropped, by reason.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Dropped {
    /// The stuffing leads beyond its end, or ends too soon.
    pub stuffing: u32,
    /// The CRC does not match.
    pub check: u32,
    /// Longer than any frame.
    pub long: u32,
    /// Shorter than any frame.
    pub short: u32,
    /// An unknown kind of frame.
    pub kind: u32,
}

impl Dropped {
    /// All of them.
    pub fn total(&self) -> u32 {
        let Self { stuffing, check, long, short, kind } = *self;
        [check, long, short, kind].into_iter().fold(stuffing, u32::saturating_add)
    }
}

impl Record for Dropped {
    record!(stuffing, check, long, short, kind);
}

/// Errors that a receiver noticed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Counters {
    /// Dropped frames.
    pub dropped: Dropped,
    /// Sequence numbers that were jumped over: frames lost, broken, or overtaken.
    pub missing: u32,
    /// Frames that came a second time.
    pub duplicated: u32,
    /// Frames that came after a later one.
    pub late: u32,
    /// Samples asked for again that had been taken already.
    pub repeated: u32,
    /// Samples that never came, bridged.
    pub bridged: u32,
}

impl Record for Counters {
    record!(dropped, missing, duplicated, late, repeated, bridged);
}
