//! Runs in batches: what is flown is handed on while the rest flies, and memory does not grow with the runs.
//!
//! A run depends only on its number, so batches do not show.

use super::fleet;
use super::group::{Ground, Unit};
use super::kept::Kept;
use crate::navigator::Unavailable;
use std::ops::Range;

/// Samples of a batch, over its runs: some seconds.
const SAMPLES: u64 = 50_000_000;
/// Runs of a batch, at least: they share the cost of their motion.
const FEWEST: u64 = 128;

/// How runs are flown.
#[derive(Clone, Copy, Debug)]
pub struct Means<'a> {
    /// Abreast or one by one.
    pub unit: Unit,
    /// On so many threads.
    pub threads: usize,
    /// Read when so many samples have been taken.
    pub stops: &'a [u64],
    /// Runs of a batch; some seconds' worth of them unless told.
    pub batch: Option<u64>,
}

/// Flies the runs of a range of numbers; `done` gets each batch, in order, and `progress` the samples flown
/// over all runs.
pub fn fly<E: From<Unavailable>>(
    ground: &Ground,
    runs: Range<u64>,
    means: Means,
    progress: &dyn Fn(u64),
    done: &mut dyn FnMut(Kept) -> Result<(), E>,
) -> Result<(), E> {
    let samples = ground.scene.samples();
    let Means { unit, threads, stops, batch } = means;
    let size = batch.unwrap_or_else(|| size(samples, (unit.runs() * threads) as u64)).max(1);
    let mut first = runs.start;
    while first < runs.end {
        let batch = first..runs.end.min(first + size);
        let so_far = (first - runs.start) * samples;
        let reach = |taken: u64| progress(so_far + taken * (batch.end - batch.start));
        let flown = fleet::fly_range(ground, batch.clone(), unit, threads, stops, &reach)?;
        first = batch.end;
        done(Kept::new(batch, flown))?;
    }
    Ok(())
}

/// Runs of a batch: a multiple of what flies at once.
fn size(samples: u64, at_once: u64) -> u64 {
    let wanted = (SAMPLES / samples.max(1)).max(FEWEST);
    wanted.div_ceil(at_once.max(1)) * at_once.max(1)
}
