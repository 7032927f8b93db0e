//! Runs on all processors, each by whichever thread is free.

use std::num::NonZero;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;

/// What every run gives, in their order; or the first that fails, with its number. `done` gets how many there are.
pub fn all<T: Send, E: Send>(
    runs: u64,
    one: &(dyn Fn(u64) -> Result<T, E> + Sync),
    done: &(dyn Fn(u64) + Sync),
) -> Result<Vec<T>, (u64, E)> {
    let threads = thread::available_parallelism().map_or(1, NonZero::get) as u64;
    let (next, ended) = (AtomicU64::new(0), AtomicU64::new(0));
    let work = || {
        let mut results = Vec::new();
        loop {
            let run = next.fetch_add(1, Ordering::Relaxed);
            if run >= runs {
                return results;
            }
            let result = one(run);
            if result.is_err() {
                next.store(runs, Ordering::Relaxed);
            }
            results.push((run, result));
            done(ended.fetch_add(1, Ordering::Relaxed) + 1);
        }
    };
    let mut results = thread::scope(|scope| {
        let others: Vec<_> = (1..threads.min(runs)).map(|_| scope.spawn(work)).collect();
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
