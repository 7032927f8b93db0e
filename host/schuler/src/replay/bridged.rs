//! Missing samples that were filled.

use schuler_simulator::recording::samples::Sample;

/// Missing samples that were filled from their neighbours.
#[derive(Clone, Copy, Debug, Default)]
pub struct Bridged {
    /// In how many gaps.
    pub gaps: u64,
    /// How many samples.
    pub samples: u64,
    /// Their length, s.
    pub time_s: f64,
    /// Length of the longest gap, s.
    pub longest_s: f64,
    last_line: u64,
}

impl Bridged {
    /// Counts one.
    pub fn add(&mut self, sample: &Sample) {
        if sample.line != self.last_line {
            self.gaps += 1;
            self.last_line = sample.line;
        }
        self.samples += 1;
        self.time_s += sample.interval_s;
        self.longest_s = self.longest_s.max(sample.interval_s * sample.missing as f64);
    }
}
