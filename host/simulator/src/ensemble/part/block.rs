//! A block of runs in bytes: its line, and the numbers behind it.

use serde::{Deserialize, Serialize};
use std::ops::Range;

/// Bytes of a number.
const NUMBER: usize = 8;

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

/// Runs of consecutive numbers, as a part has them.
pub trait Content: Sized {
    /// Whether they are aided.
    const IS_AIDED: bool;
    /// How many numbers there are of each run at each instant.
    const AT_INSTANT: usize;
    /// How many there are of each run besides.
    const OF_RUN: usize;

    /// None yet: the next run is that of a number.
    fn none(first: u64) -> Self;
    /// The runs.
    fn runs(&self) -> Range<u64>;
    /// Takes the runs that follow.
    fn join(&mut self, later: Self) -> Result<(), Unfit>;
    /// What a block of them says first.
    fn line(&self) -> Line;
    /// The numbers of the runs that reached their end, run by run.
    fn numbers(&self) -> Vec<f64>;
    /// Of both; `None` where a reason is none, or a number cannot be what it should.
    fn of(line: Line, numbers: &[f64]) -> Option<Self>;
}

/// The line before a block's numbers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Line {
    /// The number of the first run.
    pub first: u64,
    /// The number after that of the last.
    pub end: u64,
    /// Samples integrated at each reading; none where no run reached its end.
    pub samples: Vec<u64>,
    /// Samples in which a sensor was at its limit.
    pub saturated: u64,
    /// Runs that failed: the number, the sample that was not taken, and why, by the code of [`Refusal`](schuler::link::refusal::Refusal).
    pub failed: Vec<(u64, u64, u8)>,
}

impl Line {
    /// Runs that reached their end; `None` where the line contradicts itself.
    fn survivors(&self) -> Option<u64> {
        let inside = self.failed.iter().all(|(run, ..)| (self.first..self.end).contains(run));
        let ordered = self.failed.is_sorted_by(|a, b| a.0 < b.0);
        let increasing = self.samples.is_sorted_by(|a, b| a < b);
        let survivors = self.end.checked_sub(self.first)?.checked_sub(self.failed.len() as u64)?;
        let read = (survivors > 0) != self.samples.is_empty();
        (inside && ordered && increasing && read && self.first < self.end).then_some(survivors)
    }

    /// How many numbers there are behind it; `None` where it contradicts itself.
    fn numbers<C: Content>(&self) -> Option<usize> {
        let instants = self.samples.len().checked_mul(C::AT_INSTANT)?;
        let numbers = usize::try_from(self.survivors()?).ok()?;
        numbers.checked_mul(instants.checked_add(C::OF_RUN)?)
    }

    /// Bytes of the numbers behind it; `None` where it contradicts itself.
    pub fn bytes<C: Content>(&self) -> Option<usize> {
        self.numbers::<C>()?.checked_mul(NUMBER)
    }
}

/// The numbers of runs in bytes.
pub fn bytes<C: Content>(runs: &C) -> Vec<u8> {
    runs.numbers().into_iter().flat_map(f64::to_le_bytes).collect()
}

/// The runs of a line with the bytes behind it; `None` where something is no number or no reason.
pub fn runs<C: Content>(line: Line, bytes: &[u8]) -> Option<C> {
    let numbers: Vec<f64> =
        bytes.as_chunks::<NUMBER>().0.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect();
    let is_whole = line.numbers::<C>() == Some(numbers.len());
    if is_whole { C::of(line, &numbers) } else { None }
}
