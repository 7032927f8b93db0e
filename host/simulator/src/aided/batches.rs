//! Aided runs in batches: what is flown is handed on while the rest flies.
//!
//! A run depends only on its number, so neither batches nor threads show.

use super::kept::{AidedRuns, Failure};
use super::runs::{Ended, Scenes, fly};
use crate::input::InputError;
use crate::parallel;
use std::ops::Range;

/// How runs are flown.
#[derive(Clone, Copy, Debug)]
pub struct Means<'a> {
    /// On so many threads.
    pub threads: usize,
    /// Read when so many samples have been integrated.
    pub stops: &'a [u64],
    /// Runs of a batch; some seconds' worth of them unless told.
    pub batch: Option<u64>,
}

/// Samples of a batch, over its runs: some seconds.
const SAMPLES: u64 = 4_000_000;
/// Runs of a batch, at least.
const FEWEST: u64 = 16;

/// Flies the runs of a range of numbers; `done` gets each batch, in order, and `progress` how many have ended.
pub fn fly_range<E: From<InputError>>(
    scenes: Scenes,
    runs: Range<u64>,
    means: Means,
    progress: &(dyn Fn(u64) + Sync),
    done: &mut dyn FnMut(AidedRuns) -> Result<(), E>,
) -> Result<(), E> {
    let Means { threads, stops, batch } = means;
    let size = batch.unwrap_or_else(|| (SAMPLES / scenes.flown.samples().max(1)).max(FEWEST));
    let one = |run| match fly(scenes, run, stops) {
        Ok(run) => Ok(Ok(run)),
        Err(Ended::Sample(sample, why)) => Ok(Err(Failure { run, sample, why })),
        Err(Ended::Start(error)) => Err(error),
    };
    let mut first = runs.start;
    while first < runs.end {
        let numbers = first..runs.end.min(first.saturating_add(size.max(1)));
        let so_far = first - runs.start;
        let reach = |flown: u64| progress(so_far + flown);
        let flown = parallel::all(numbers.clone(), threads, &one, &reach);
        let mut batch = AidedRuns { numbers, ended: Vec::new(), failed: Vec::new() };
        for run in flown.map_err(|(_, error)| error)? {
            match run {
                Ok(run) => batch.ended.push(run),
                Err(failure) => batch.failed.push(failure),
            }
        }
        first = batch.numbers.end;
        done(batch)?;
    }
    Ok(())
}
