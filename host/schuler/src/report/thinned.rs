//! The instants of a run that tables keep.

use super::every::{Every, Sieve};
use schuler_simulator::flight::Instant;

/// Keeps the first instant, the last, and those in between that are wanted.
#[derive(Debug)]
pub struct Thinned {
    sieve: Sieve,
    left_out: Option<Instant>,
    is_begun: bool,
}

impl Thinned {
    /// Of a run that starts at a time, s.
    pub fn new(every: Option<Every>, start_s: f64) -> Self {
        Self { sieve: Sieve::new(every, start_s), left_out: None, is_begun: false }
    }

    /// Whether the next instant is kept.
    pub fn keeps(&mut self, instant: &Instant) -> bool {
        let is_kept = !self.is_begun || self.sieve.keeps(instant.time_s);
        self.is_begun = true;
        self.left_out = (!is_kept).then_some(*instant);
        is_kept
    }

    /// The last instant, where it was left out.
    pub fn last(&mut self) -> Option<Instant> {
        self.left_out.take()
    }
}
