//! All runs of an ensemble, on all processors: in groups, each flown by whichever thread is free.
//!
//! A run depends only on its number, so the result does not depend on threads or lanes.

use super::group::{Ground, Unit};
use super::held::Held;
use super::runs::{Failure, Group};
use super::{instants, saturated};
use crate::navigator::Unavailable;
use crate::scene::Vertical;
use schuler::drift::compare::{Drift, drift};
use std::ops::Range;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;

/// Samples whose perfect increments are worked out at once, for all runs.
const STRETCH: u64 = 4096;

/// Every run's drift at one instant.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    /// Samples integrated until then.
    pub samples: u64,
    /// Computed less true, in order of the runs that reached their end.
    pub drifts: Vec<Drift>,
}

/// A finished ensemble.
#[derive(Clone, Debug, PartialEq)]
pub struct Flown {
    /// In order of time; the last is the end.
    pub readings: Vec<Reading>,
    /// Samples in which a sensor was at its limit, over all runs; of a run that failed, up to the sample that it
    /// did not take.
    pub saturated: u64,
    /// The runs that did not reach their end, in order.
    pub failed: Vec<Failure>,
}

/// Flies runs 0 to `runs` − 1, and reads the block ends nearest to `instants` equally spaced times.
pub fn fly(
    ground: &Ground,
    runs: u64,
    unit: Unit,
    threads: usize,
    instants: u64,
    progress: &dyn Fn(u64),
) -> Result<Flown, Unavailable> {
    fly_range(ground, 0..runs, unit, threads, &instants::equal(ground, instants), progress)
}

/// Flies the runs of a range of numbers, and reads them when so many samples have been taken.
pub fn fly_range(
    ground: &Ground,
    runs: Range<u64>,
    unit: Unit,
    threads: usize,
    stops: &[u64],
    progress: &dyn Fn(u64),
) -> Result<Flown, Unavailable> {
    let samples = ground.scene.samples();
    let mut groups = Vec::new();
    let mut ranges = Vec::new();
    for first in runs.clone().step_by(unit.runs()) {
        let numbers = first..runs.end.min(first + unit.runs() as u64);
        // A unit that is not there, or not for this window, leaves each run to itself.
        if let Some(group) = ground.start(unit, numbers.clone())? {
            groups.push(group);
            ranges.push(numbers);
        } else {
            for run in numbers {
                groups.extend(ground.start(Unit::Alone, run..run + 1)?);
                ranges.push(run..run + 1);
            }
        }
    }
    let mut stops = stops.iter().copied().peekable();
    let mut readings: Vec<(u64, Vec<Option<Drift>>)> = Vec::new();
    let mut done = 0;
    while let Some(&stop) = stops.peek() {
        let end = stop.min(done + STRETCH);
        let perfect = ground.source.perfect_samples(done + 1..end + 1);
        // Navigation lies behind by what a window looks ahead.
        let integrated = groups.iter().map(|group| group.integrated()).max().unwrap_or(done);
        let held = (ground.scene.navigator.vertical == Vertical::Held)
            .then(|| Held::new(ground.source, integrated + 1..=end));
        stretch(&mut groups, threads, |group| group.fly(&perfect, held.as_ref()));
        if !groups.iter().any(|group| group.goes_on()) {
            break;
        }
        done = end;
        progress(done);
        if done == stop {
            stops.next();
            if done == samples {
                groups.iter_mut().for_each(|group| group.finish());
            }
            let last = readings.last().map_or(0, |(samples, _)| *samples);
            readings.extend(read(ground, &groups).filter(|(samples, _)| *samples > last));
        }
    }
    let failed: Vec<_> = groups.iter().flat_map(|group| group.failures()).collect();
    // The same runs at every instant: those that failed are in none.
    let has_failed = |place: usize| {
        failed.binary_search_by_key(&(runs.start + place as u64), |failure| failure.run).is_ok()
    };
    let readings = readings.into_iter().map(|(samples, drifts)| {
        let drifts = drifts.into_iter().enumerate().filter(|(place, _)| !has_failed(*place));
        Reading { samples, drifts: drifts.filter_map(|(_, drift)| drift).collect() }
    });
    Ok(Flown {
        readings: readings.collect(),
        saturated: saturated::in_all(ground, &groups, &ranges, &failed),
        failed,
    })
}

/// Does something with every group, on so many threads.
fn stretch(
    groups: &mut [Box<dyn Group + '_>],
    threads: usize,
    work: impl Fn(&mut dyn Group) + Sync,
) {
    let queue = Mutex::new(groups.iter_mut());
    let work = || {
        loop {
            let next = lock(&queue).next();
            let Some(group) = next else { break };
            work(group.as_mut());
        }
    };
    thread::scope(|scope| {
        for _ in 1..threads {
            scope.spawn(work);
        }
        work();
    });
}

/// What a panic elsewhere left is of no use; the panic itself goes on when its thread is joined.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Samples integrated, and every run's drift there; `None` of those that have failed.
fn read(ground: &Ground, groups: &[Box<dyn Group + '_>]) -> Option<(u64, Vec<Option<Drift>>)> {
    let samples = groups.iter().find(|group| group.goes_on())?.integrated();
    let truth = ground.source.truth(samples);
    let solutions = groups.iter().flat_map(|group| group.solutions());
    let drifts = solutions.map(|computed| computed.map(|computed| drift(&computed, &truth)));
    Some((samples, drifts.collect()))
}
