//! Counters of errors on the link.

use crate::record::{Record, record};

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
        self.stuffing + self.check + self.long + self.short + self.kind
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
