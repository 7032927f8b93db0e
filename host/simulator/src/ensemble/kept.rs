//! The values that are kept of every run, and their concatenation by the runs' numbers.

use super::fleet::{Flown, Reading};
use std::ops::Range;

/// What is kept of the runs of a range of numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Kept {
    /// Their numbers.
    pub runs: Range<u64>,
    /// Every run's drift at the chosen instants; no reading where no run has reached its end.
    pub flown: Flown,
}

/// Parts that do not fit one another.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unfit {
    /// The later part begins with another run than the one after the last.
    Runs {
        /// The run that should be the first.
        next: u64,
        /// The run that is.
        first: u64,
    },
    /// They were read at other instants.
    Instants,
}

impl Kept {
    /// Nothing yet: the next run is that of a number.
    pub fn none(first: u64) -> Self {
        let flown = Flown { readings: Vec::new(), saturated: 0, failed: Vec::new() };
        Self { runs: first..first, flown }
    }

    /// Of the runs of a range, as they were flown.
    pub fn new(runs: Range<u64>, mut flown: Flown) -> Self {
        flown.readings.retain(|reading| !reading.drifts.is_empty());
        Self { runs, flown }
    }

    /// How many samples had been integrated at each reading.
    pub fn instants(&self) -> Vec<u64> {
        self.flown.readings.iter().map(|reading| reading.samples).collect()
    }

    /// The numbers of the runs that reached their end, in the order of their drifts.
    pub fn numbers(&self) -> Vec<u64> {
        let mut failed = self.flown.failed.iter().map(|failure| failure.run).peekable();
        self.runs.clone().filter(|run| failed.next_if_eq(run).is_none()).collect()
    }

    /// Takes the runs that follow.
    pub fn join(&mut self, later: Self) -> Result<(), Unfit> {
        let Self { runs, flown } = later;
        if runs.start != self.runs.end {
            return Err(Unfit::Runs { next: self.runs.end, first: runs.start });
        }
        let mine = &mut self.flown;
        if mine.readings.is_empty() {
            mine.readings = flown.readings;
        } else if !flown.readings.is_empty() {
            let same = |(mine, theirs): (&Reading, &Reading)| mine.samples == theirs.samples;
            if mine.readings.len() != flown.readings.len()
                || !mine.readings.iter().zip(&flown.readings).all(same)
            {
                return Err(Unfit::Instants);
            }
            for (mine, theirs) in mine.readings.iter_mut().zip(flown.readings) {
                mine.drifts.extend(theirs.drifts);
            }
        }
        mine.saturated += flown.saturated;
        mine.failed.extend(flown.failed);
        self.runs.end = runs.end;
        Ok(())
    }
}
