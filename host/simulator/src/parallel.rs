//! Runs on all processors, each by whichever thread is free.

use std::num::NonZero;
use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;

/// What every run gives, in their order; or the first that fails, with its number. `done` gets how many there are.
pub fn all<T: Send, E: Send>(
    runs: Range<u64>,
    threads: usize,
    one: &(dyn Fn(u64) -> Result<T, E> + Sync),
    done: &(dyn Fn(u64) + Sync),
) -> Result<Vec<T>, (u64, E)> {
    let (next, ended) = (AtomicU64::new(runs.start), AtomicU64::new(0));
    let count = runs.end.saturating_sub(runs.start);
    let work = || {
        let mut results = Vec::new();
        loop {
            let run = next.fetch_add(1, Ordering::Relaxed);
            if run >= runs.end {
                return results;
            }
            let result = one(run);
            if result.is_err() {
                next.store(runs.end, Ordering::Relaxed);
            }
            results.push((run, result));
            done(ended.fetch_add(1, Ordering::Relaxed) + 1);
        }
    };
    let mut results = thread::scope(|scope| {
        let others: Vec<_> = (1..count.min(threads as u64)).map(|_| scope.spawn(work)).collect();
        let mut results = work();
        for other in others {
            match other.join() {
                Ok(more) => results.extend(more),
                Err(panic) => std::panic::resume_unwind(panic),
            }
        }
        results
    });
    results.sort_by_key(|(run, _)| *run);
    results.into_iter().map(|(run, result)| result.map_err(|error| (run, error))).collect()
}

/// As many threads as there are processors.
pub fn processors() -> usize {
    thread::available_parallelism().map_or(1, NonZero::get)
}
