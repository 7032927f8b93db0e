//! Real time: each sample at its own instant.

use std::thread;
use std::time::{Duration, Instant};

/// A clock that began with the flight.
#[derive(Clone, Copy, Debug)]
pub struct Pace {
    start: Instant,
    interval_s: f64,
}

impl Pace {
    /// From now on, so many samples per second.
    pub fn new(rate_hz: f64) -> Self {
        Self { start: Instant::now(), interval_s: 1.0 / rate_hz }
    }

    /// Waits for the end of a sample: the instant at which it goes out, later if others were late.
    pub fn wait(&self, sample: u32) -> Instant {
        let due = self.start + Duration::from_secs_f64(f64::from(sample) * self.interval_s);
        thread::sleep(due.saturating_duration_since(Instant::now()));
        Instant::now()
    }
}
