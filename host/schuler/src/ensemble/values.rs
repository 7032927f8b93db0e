//! The drifts of all runs at one instant, in the units of files.

use schuler_simulator::ensemble::fleet::Reading;
use schuler_simulator::simulate::nine;

/// Nine numbers of each run, m, m/s, arcsec.
#[derive(Clone, Debug, PartialEq)]
pub struct Values {
    /// The runs' numbers.
    pub runs: Vec<u64>,
    /// In the order of [`Nine::NAMES`](schuler_simulator::flight::Nine::NAMES).
    pub numbers: Vec<[f64; 9]>,
}

impl Values {
    /// Of a reading of runs of these numbers.
    pub fn new(reading: &Reading, runs: &[u64]) -> Self {
        let numbers = reading.drifts.iter().map(|drift| nine(drift).numbers()).collect();
        Self { runs: runs.to_vec(), numbers }
    }

    /// One of the nine, of every run.
    pub fn component(&self, i: usize) -> Vec<f64> {
        self.numbers.iter().map(|x| x[i]).collect()
    }
}
