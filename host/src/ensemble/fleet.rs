//! All runs of an ensemble, on all processors: in groups, each flown by whichever thread is free.
//!
//! A run depends on its number alone, so neither threads nor lanes show in the result.

use super::group::{Ground, Group, Unit};
use crate::simulate::FlightError;
use schuler::drift::compare::{Drift, drift};
use schuler::sample::Increment;
use schuler::strapdown::mechanization::Rejected;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;

/// Samples whose perfect increments are worked out at once, for all runs.
const STRETCH: u64 = 4096;

/// Every run's drift at one instant.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    /// Samples integrated until then.
    pub samples: u64,
    /// Computed less true, in order of the runs.
    pub drifts: Vec<Drift>,
}

/// A finished ensemble.
#[derive(Clone, Debug, PartialEq)]
pub struct Flown {
    /// In order of time; the last is the end.
    pub readings: Vec<Reading>,
    /// Samples in which a sensor was at its limit, over all runs.
    pub saturated: u64,
}

/// A sample that some run refused: its number, the group of the run, and why.
type Refusal = (u64, usize, Rejected);

/// Flies runs 0 to `runs` − 1, and reads the block ends nearest to `instants` equally spaced times.
pub fn fly(
    ground: &Ground,
    runs: u64,
    unit: Unit,
    threads: usize,
    instants: u64,
    progress: &dyn Fn(u64),
) -> Result<Flown, FlightError> {
    let samples = ground.scene.samples();
    let mut groups = Vec::new();
    for first in (0..runs).step_by(unit.runs()) {
        let numbers = first..runs.min(first + unit.runs() as u64);
        // A unit that is not there, or not for this window, leaves each run to itself.
        if let Some(group) = ground.start(unit, numbers.clone())? {
            groups.push(group);
        } else {
            for run in numbers {
                groups.extend(ground.start(Unit::Alone, run..run + 1)?);
            }
        }
    }
    let mut stops = stops(ground, samples, instants).into_iter().peekable();
    let mut readings: Vec<Reading> = Vec::new();
    let mut done = 0;
    while let Some(&stop) = stops.peek() {
        let end = stop.min(done + STRETCH);
        let time_s = |sample| ground.source.time_s(sample);
        let perfect: Vec<_> = (done..end).map(|n| ground.source.perfect_sample(n + 1)).collect();
        if let Some((sample, _, why)) = stretch(&mut groups, &perfect, done, threads) {
            return Err(FlightError::Rejected { sample, time_s: time_s(sample), why });
        }
        done = end;
        progress(done);
        if done == stop {
            stops.next();
            if done == samples {
                groups.iter_mut().for_each(|group| group.finish());
            }
            let last = readings.last().map_or(0, |reading| reading.samples);
            readings.extend(read(ground, &groups).filter(|reading| reading.samples > last));
        }
    }
    Ok(Flown { readings, saturated: groups.iter().map(|group| group.saturated()).sum() })
}

/// How many samples are to be taken until each instant's block is complete: increasing, all at last.
fn stops(ground: &Ground, samples: u64, instants: u64) -> Vec<u64> {
    let (block, ahead) = (ground.plan.window.block as u64, ground.plan.window.lookahead as u64);
    let nearest = |instant: u64| {
        let sample = samples as f64 * instant as f64 / instants as f64;
        (sample / block as f64).round() as u64 * block + ahead
    };
    let mut stops: Vec<u64> =
        (1..instants).map(nearest).filter(|&stop| stop > ahead && stop < samples).collect();
    stops.push(samples);
    stops.dedup();
    stops
}

/// Flies every group over a stretch; of what is refused, the first sample.
fn stretch(
    groups: &mut [Box<dyn Group + '_>],
    perfect: &[Increment<f64>],
    done: u64,
    threads: usize,
) -> Option<Refusal> {
    let queue = Mutex::new(groups.iter_mut().enumerate());
    let refusals: Mutex<Vec<Refusal>> = Mutex::default();
    let work = || {
        loop {
            let next = lock(&queue).next();
            let Some((number, group)) = next else { break };
            if let Err(refused) = group.fly(perfect) {
                let sample = done + refused.taken as u64 + 1;
                lock(&refusals).push((sample, number, refused.reason));
            }
        }
    };
    thread::scope(|scope| {
        for _ in 1..threads {
            scope.spawn(work);
        }
        work();
    });
    let refusals = lock(&refusals);
    refusals.iter().min_by_key(|(sample, group, _)| (*sample, *group)).copied()
}

/// What a panic elsewhere left is of no use; the panic itself goes on when its thread is joined.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Every run's drift where it stands.
fn read(ground: &Ground, groups: &[Box<dyn Group + '_>]) -> Option<Reading> {
    let samples = groups.first()?.integrated();
    let truth = ground.source.truth(samples);
    let solutions = groups.iter().flat_map(|group| group.solutions());
    Some(Reading { samples, drifts: solutions.map(|computed| drift(&computed, &truth)).collect() })
}
