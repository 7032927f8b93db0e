//! The values that are kept of every run, and their concatenation by the runs' numbers.

use super::fleet::{Flown, Reading};
use super::part::block::{Content, Line, Unfit};
use super::runs::Failure;
use schuler::drift::compare::Drift;
use schuler::drift::linear::ErrorState;
use schuler::link::refusal::Refusal;
use std::ops::Range;

/// Numbers of a drift.
const NINE: usize = 9;

/// What is kept of the runs of a range of numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Kept {
    /// Their numbers.
    pub runs: Range<u64>,
    /// Every run's drift at the chosen instants; no reading where no run has reached its end.
    pub flown: Flown,
}

impl Kept {
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
}

impl Content for Kept {
    const IS_AIDED: bool = false;
    const AT_INSTANT: usize = NINE;
    const OF_RUN: usize = 0;

    fn none(first: u64) -> Self {
        let flown = Flown { readings: Vec::new(), saturated: 0, failed: Vec::new() };
        Self { runs: first..first, flown }
    }

    fn runs(&self) -> Range<u64> {
        self.runs.clone()
    }

    fn join(&mut self, later: Self) -> Result<(), Unfit> {
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

    fn line(&self) -> Line {
        let code = |failure: &Failure| Refusal::from(failure.why).code();
        let failed = self.flown.failed.iter();
        Line {
            first: self.runs.start,
            end: self.runs.end,
            samples: self.instants(),
            saturated: self.flown.saturated,
            failed: failed.map(|failure| (failure.run, failure.sample, code(failure))).collect(),
        }
    }

    fn numbers(&self) -> Vec<f64> {
        let readings = &self.flown.readings;
        let runs = readings.first().map_or(0, |reading| reading.drifts.len());
        let all =
            (0..runs).flat_map(|run| readings.iter().map(move |reading| &reading.drifts[run]));
        all.flat_map(numbers).collect()
    }

    fn of(line: Line, numbers: &[f64]) -> Option<Self> {
        if !numbers.iter().all(|x| x.is_finite()) {
            return None;
        }
        let instants = line.samples.len();
        let mut readings: Vec<Reading> =
            line.samples.iter().map(|&samples| Reading { samples, drifts: Vec::new() }).collect();
        for (place, numbers) in numbers.as_chunks::<NINE>().0.iter().enumerate() {
            readings.get_mut(place % instants)?.drifts.push(drift(*numbers));
        }
        let failure = |(run, sample, code)| match Refusal::from_code(code)? {
            Refusal::Rejected(why) => Some(Failure { run, sample, why }),
            _ => None,
        };
        let failed = line.failed.into_iter().map(failure).collect::<Option<_>>()?;
        let flown = Flown { readings, saturated: line.saturated, failed };
        Some(Self { runs: line.first..line.end, flown })
    }
}

/// Position, velocity and attitude.
fn numbers(drift: &Drift) -> [f64; NINE] {
    let Drift { position_ned: position, velocity_ned: velocity, attitude_ned: attitude } = *drift;
    ErrorState { position, velocity, attitude }.into_array()
}

fn drift(numbers: [f64; NINE]) -> Drift {
    let ErrorState { position, velocity, attitude } = numbers.into();
    Drift { position_ned: position, velocity_ned: velocity, attitude_ned: attitude }
}
