//! A wait for an answer, with anything else that may arrive.

use std::time::{Duration, Instant};

/// The shortest wait that a line is asked for: some take 0 for no limit.
const LEAST: Duration = Duration::from_millis(1);

/// A wait with an end, which nothing that comes puts off.
#[derive(Clone, Copy, Debug)]
pub struct Wait {
    until: Instant,
    is_over: bool,
}

impl Wait {
    /// From now on.
    pub fn new(patience: Duration) -> Self {
        Self { until: Instant::now() + patience, is_over: false }
    }

    /// What is left of it. At its end it is asked for once more, for what has come by then; after that
    /// there is nothing left.
    pub fn left(&mut self) -> Option<Duration> {
        if self.is_over {
            return None;
        }
        let left = self.until.saturating_duration_since(Instant::now());
        self.is_over = left.is_zero();
        Some(left.max(LEAST))
    }
}
