//! What is kept of aided runs of consecutive numbers.

use super::report::{Count, Report, name};
use super::runs::{GROUPS, Read, Run};
use crate::ensemble::part::block::{Content, Line, Unfit};
use schuler::aiding::aided::fault::AidedFault;
use schuler::aiding::aided::measured::Sensor;
use schuler::link::refusal::Refusal;
use std::ops::Range;

/// Numbers of a reading: errors, variances, NEES.
const OF_READ: usize = 9 + 9 + GROUPS.len();
/// Numbers of an instant: filtered, smoothed.
const AT_INSTANT: usize = 2 * OF_READ;
/// Numbers of a sensor: taken, refused, lockouts, degrees of freedom, Σ NIS.
const OF_SENSOR: usize = 5;
/// Numbers of a run: its sensors', what came again, late, and found no room, saturated samples.
const OF_RUN: usize = OF_SENSOR * Sensor::ALL.len() + 4;

/// A run that could not go on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Failure {
    /// Its number, from 0.
    pub run: u64,
    /// The sample that it did not take, from 1.
    pub sample: u64,
    /// Why not.
    pub why: AidedFault,
}

/// Runs of consecutive numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct AidedRuns {
    /// Their numbers.
    pub numbers: Range<u64>,
    /// Those that reached their end, in order.
    pub ended: Vec<Run>,
    /// Those that did not, in order.
    pub failed: Vec<Failure>,
}

impl AidedRuns {
    /// The numbers of the runs that reached their end.
    pub fn of_ended(&self) -> Vec<u64> {
        let mut failed = self.failed.iter().map(|failure| failure.run).peekable();
        self.numbers.clone().filter(|run| failed.next_if_eq(run).is_none()).collect()
    }

    /// Samples integrated at each reading.
    pub fn instants(&self) -> Vec<u64> {
        let reads = self.ended.first().map_or([].as_slice(), |run| run.reads.as_slice());
        reads.iter().map(|read| read.samples).collect()
    }
}

impl Content for AidedRuns {
    const IS_AIDED: bool = true;
    const AT_INSTANT: usize = AT_INSTANT;
    const OF_RUN: usize = OF_RUN;

    fn none(first: u64) -> Self {
        Self { numbers: first..first, ended: Vec::new(), failed: Vec::new() }
    }

    fn runs(&self) -> Range<u64> {
        self.numbers.clone()
    }

    fn join(&mut self, later: Self) -> Result<(), Unfit> {
        if later.numbers.start != self.numbers.end {
            return Err(Unfit::Runs { next: self.numbers.end, first: later.numbers.start });
        }
        let is_read = !self.ended.is_empty() && !later.ended.is_empty();
        if is_read && self.instants() != later.instants() {
            return Err(Unfit::Instants);
        }
        self.numbers.end = later.numbers.end;
        self.ended.extend(later.ended);
        self.failed.extend(later.failed);
        Ok(())
    }

    fn line(&self) -> Line {
        let code = |failure: &Failure| Refusal::Aided(failure.why).code();
        let failed = self.failed.iter();
        Line {
            first: self.numbers.start,
            end: self.numbers.end,
            samples: self.instants(),
            saturated: self.ended.iter().map(|run| run.saturated).sum(),
            failed: failed.map(|failure| (failure.run, failure.sample, code(failure))).collect(),
        }
    }

    fn numbers(&self) -> Vec<f64> {
        let of_run = |run: &Run| {
            let none = [f64::NAN; OF_READ];
            let mut numbers = Vec::new();
            for (place, read) in run.reads.iter().enumerate() {
                numbers.extend(of_read(read));
                numbers.extend(run.smoothed.get(place).map_or(none, of_read));
            }
            numbers.extend(counts(&run.report));
            numbers.push(run.saturated as f64);
            numbers
        };
        self.ended.iter().flat_map(of_run).collect()
    }

    fn of(line: Line, numbers: &[f64]) -> Option<Self> {
        let of_run = AT_INSTANT * line.samples.len() + OF_RUN;
        let run = |numbers: &[f64]| -> Option<Run> {
            let (reads, counts) = numbers.split_at_checked(of_run - OF_RUN)?;
            let (saturated, counts) = counts.split_last()?;
            let (filtered, smoothed) = both(reads, &line.samples)?;
            Some(Run {
                reads: filtered,
                smoothed,
                report: report(counts)?,
                saturated: count(*saturated)?,
            })
        };
        let ended = numbers.chunks_exact(of_run).map(run).collect::<Option<_>>()?;
        let failure = |&(run, sample, code)| {
            let why = match Refusal::from_code(code)? {
                Refusal::Rejected(why) => AidedFault::Rejected(why),
                Refusal::Aided(why) => why,
                _ => return None,
            };
            Some(Failure { run, sample, why })
        };
        let failed = line.failed.iter().map(failure).collect::<Option<_>>()?;
        Some(Self { numbers: line.first..line.end, ended, failed })
    }
}

fn of_read(read: &Read) -> [f64; OF_READ] {
    let mut numbers = read.error.into_iter().chain(read.variance).chain(read.nees);
    std::array::from_fn(|_| numbers.next().unwrap_or(f64::NAN))
}

/// Readings of a run, filtered and smoothed. `None` where an error or a variance of the filter is no number: NEES may be
/// none, of a covariance that is not regular, and so may be what a smoother does not reach.
fn both(numbers: &[f64], samples: &[u64]) -> Option<(Vec<Read>, Vec<Read>)> {
    let (mut filtered, mut smoothed) = (Vec::new(), Vec::new());
    for (numbers, &samples) in numbers.as_chunks::<AT_INSTANT>().0.iter().zip(samples) {
        let (first, second) = numbers.split_at(OF_READ);
        filtered.push(read(samples, first));
        smoothed.push(read(samples, second));
    }
    let mut known = filtered.iter().flat_map(|read| read.error.iter().chain(&read.variance));
    if !known.all(|x| x.is_finite()) {
        return None;
    }
    let is_there = smoothed.iter().any(|read| read.error[0].is_finite());
    Some((filtered, if is_there { smoothed } else { Vec::new() }))
}

fn read(samples: u64, numbers: &[f64]) -> Read {
    let mut numbers = numbers.iter().copied();
    let mut next = || numbers.next().unwrap_or(f64::NAN);
    Read {
        samples,
        error: std::array::from_fn(|_| next()),
        variance: std::array::from_fn(|_| next()),
        nees: std::array::from_fn(|_| next()),
    }
}

fn counts(report: &Report) -> Vec<f64> {
    let of_sensor = |sensor: Sensor| {
        let count = report.sensors.iter().find(|count| count.sensor == name(sensor));
        let Count { accepted, refused, lockouts, degrees, nis, .. } =
            count.copied().unwrap_or_default();
        let [a, b, c, d] = [accepted, refused, lockouts, degrees].map(|count| count as f64);
        [a, b, c, d, nis]
    };
    let sensors = Sensor::ALL.into_iter().flat_map(of_sensor);
    sensors.chain([report.again, report.late, report.dropped].map(|count| count as f64)).collect()
}

/// A count; `None` of what none is.
fn count(x: f64) -> Option<u64> {
    (x.fract() == 0.0 && (0.0..2_f64.powi(53)).contains(&x)).then_some(x as u64)
}

/// `None` where a count is none.
fn report(numbers: &[f64]) -> Option<Report> {
    let (sensors, transport) = numbers.as_chunks::<OF_SENSOR>();
    let &[again, late, dropped] = transport else { return None };
    let mut report = Report {
        again: count(again)?,
        late: count(late)?,
        dropped: count(dropped)?,
        ..Report::default()
    };
    let sensors = Sensor::ALL.into_iter().zip(sensors);
    for (sensor, &[accepted, refused, lockouts, degrees, nis]) in sensors {
        let count = Count {
            sensor: name(sensor),
            accepted: count(accepted)?,
            refused: count(refused)?,
            lockouts: count(lockouts)?,
            degrees: count(degrees)?,
            nis,
        };
        report.sensors.extend((count.accepted + count.refused > 0).then_some(count));
    }
    Some(report)
}
