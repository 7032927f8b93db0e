//! Real time: each sample at its own instant, and the time until its answer.

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

/// Median, 99th percentile and maximum of some times, in words; how many were longer than an interval.
pub fn latencies(times_s: &[f64], rate_hz: f64) -> String {
    let mut sorted = times_s.to_vec();
    sorted.sort_by(f64::total_cmp);
    let at = |part: f64| {
        let index = ((sorted.len() as f64 * part) as usize).min(sorted.len().saturating_sub(1));
        1e3 * sorted.get(index).copied().unwrap_or(0.0)
    };
    let late = sorted.iter().filter(|&&time_s| time_s * rate_hz > 1.0).count();
    format!(
        "latency: median {:.3} ms, 99 % within {:.3} ms, longest {:.3} ms; {late} of {} answers took \
         longer than a sample\n",
        at(0.5),
        at(0.99),
        at(1.0),
        sorted.len()
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percentiles_of_a_ramp() {
        let times_s: Vec<f64> = (1..=1000).rev().map(|k| f64::from(k) * 1e-6).collect();
        let text = latencies(&times_s, 2000.0);
        let expected =
            "median 0.501 ms, 99 % within 0.991 ms, longest 1.000 ms; 500 of 1000 answers";
        assert!(text.contains(expected), "{text}");
    }
}
