//! Consecutive samples, and how a case takes them.

use super::case::Craft;
use schuler::sample::{Increment, Rates};
use schuler::strapdown::limits::Rejected;
use schuler_simulator::navigator::Reader;
use schuler_simulator::source::Source;

/// Some samples in a row.
pub struct Chunk {
    increments: Vec<Increment<f64>>,
    rates: Vec<Rates<f64>>,
}

impl Chunk {
    /// Those after `before` up to `end`.
    pub fn new(source: &Source, before: u64, end: u64) -> Self {
        let perfect = |n| source.perfect_sample(n);
        let rates = |n| source.rates(n);
        Self {
            increments: (before + 1..=end).map(perfect).collect(),
            rates: (before + 1..=end).map(rates).collect(),
        }
    }
}

impl Craft {
    /// Takes the rates at the start, if it flies on rates.
    pub fn push_rates(&mut self, rates: &Rates<f64>, read: &mut Reader) -> Result<(), Rejected> {
        match self {
            Self::Increments(_) => Ok(()),
            Self::Rates(navigator) => navigator.push(rates, read),
        }
    }

    /// Flies a chunk.
    pub fn advance(&mut self, chunk: &Chunk, read: &mut Reader) -> Result<(), Rejected> {
        match self {
            Self::Increments(craft) => {
                chunk.increments.iter().try_for_each(|n| craft.push(n, read))
            }
            Self::Rates(craft) => chunk.rates.iter().try_for_each(|n| craft.push(n, read)),
        }
    }

    /// Completes the rows that wait for samples.
    pub fn finish(&mut self, read: &mut Reader) {
        if let Self::Increments(navigator) = self {
            navigator.finish(read);
        }
    }
}
