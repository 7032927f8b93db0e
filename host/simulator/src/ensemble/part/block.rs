//! A block of runs in bytes: its line, and the drifts behind it.

use super::super::fleet::{Flown, Reading};
use super::super::kept::Kept;
use super::super::runs::Failure;
use schuler::drift::compare::Drift;
use schuler::drift::linear::ErrorState;
use schuler::link::refusal::Refusal;
use serde::{Deserialize, Serialize};

/// Bytes of a drift.
pub const DRIFT: usize = 9 * 8;

/// The line before a block's drifts.
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
    /// Runs that failed: the number, the sample that was not taken, and why, by the code of [`Refusal`].
    pub failed: Vec<(u64, u64, u8)>,
}

impl Line {
    /// Of runs.
    pub fn new(kept: &Kept) -> Self {
        let code = |failure: &Failure| Refusal::from(failure.why).code();
        let failed = kept.flown.failed.iter();
        Self {
            first: kept.runs.start,
            end: kept.runs.end,
            samples: kept.instants(),
            saturated: kept.flown.saturated,
            failed: failed.map(|failure| (failure.run, failure.sample, code(failure))).collect(),
        }
    }

    /// Runs that reached their end; `None` where the line contradicts itself.
    fn survivors(&self) -> Option<u64> {
        let inside = self.failed.iter().all(|(run, ..)| (self.first..self.end).contains(run));
        let ordered = self.failed.is_sorted_by(|a, b| a.0 < b.0);
        let increasing = self.samples.is_sorted_by(|a, b| a < b);
        let survivors = self.end.checked_sub(self.first)?.checked_sub(self.failed.len() as u64)?;
        let read = (survivors > 0) != self.samples.is_empty();
        (inside && ordered && increasing && read && self.first < self.end).then_some(survivors)
    }

    /// Bytes of the drifts behind it; `None` where it contradicts itself.
    pub fn bytes(&self) -> Option<usize> {
        let drifts = self.survivors()?.checked_mul(self.samples.len() as u64)?;
        usize::try_from(drifts).ok()?.checked_mul(DRIFT)
    }

    /// The runs, with their drifts; `None` where something is no number or no reason.
    pub fn runs(self, bytes: &[u8]) -> Option<Kept> {
        let instants = self.samples.len();
        let mut readings: Vec<Reading> =
            self.samples.iter().map(|&samples| Reading { samples, drifts: Vec::new() }).collect();
        for (place, bytes) in bytes.as_chunks::<DRIFT>().0.iter().enumerate() {
            readings.get_mut(place % instants)?.drifts.push(drift(bytes)?);
        }
        let failure = |(run, sample, code)| match Refusal::from_code(code)? {
            Refusal::Rejected(why) => Some(Failure { run, sample, why }),
            _ => None,
        };
        let failed = self.failed.into_iter().map(failure).collect::<Option<_>>()?;
        let flown = Flown { readings, saturated: self.saturated, failed };
        Some(Kept { runs: self.first..self.end, flown })
    }
}

/// The drifts of runs, run by run.
pub fn drifts(kept: &Kept) -> Vec<u8> {
    let readings = &kept.flown.readings;
    let runs = readings.first().map_or(0, |reading| reading.drifts.len());
    let all = (0..runs).flat_map(|run| readings.iter().map(move |reading| &reading.drifts[run]));
    all.flat_map(|drift| numbers(drift).map(f64::to_le_bytes)).flatten().collect()
}

/// Position, velocity and attitude.
fn numbers(drift: &Drift) -> [f64; 9] {
    let Drift { position_ned: position, velocity_ned: velocity, attitude_ned: attitude } = *drift;
    ErrorState { position, velocity, attitude }.into_array()
}

fn drift(bytes: &[u8; DRIFT]) -> Option<Drift> {
    let mut numbers = [0.0; 9];
    for (number, bytes) in numbers.iter_mut().zip(bytes.as_chunks::<8>().0) {
        *number = f64::from_le_bytes(*bytes);
    }
    let ErrorState { position, velocity, attitude } = numbers.into();
    let drift = Drift { position_ned: position, velocity_ned: velocity, attitude_ned: attitude };
    numbers.iter().all(|number| number.is_finite()).then_some(drift)
}
