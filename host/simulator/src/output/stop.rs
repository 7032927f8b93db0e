//! What is removed when the program is told to stop, so that nothing unfinished is left.
//!
//! An unfinished file has no name if the file system allows that (`aside`). Files with a name, and processes
//! that were started, are listed here.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// What would stay behind.
#[derive(Debug)]
enum Left {
    File(PathBuf),
    Process(u32),
}

/// All that would stay behind, each with a number of its own.
static LEFT: Mutex<Vec<(usize, Left)>> = Mutex::new(Vec::new());
static NUMBER: AtomicUsize = AtomicUsize::new(0);
/// Held while files take their places, and by whoever stops the program.
static GATE: Mutex<()> = Mutex::new(());
/// Files that have taken their place.
static PLACED: AtomicUsize = AtomicUsize::new(0);
/// What stays of unfinished work, for people.
static STAYS: Mutex<Option<String>> = Mutex::new(None);

/// An entry in the list; dropped, it is none of the list's business any more.
#[derive(Debug)]
pub struct Listed(usize);

impl Listed {
    /// A file that is to go.
    pub fn file(path: &Path) -> Self {
        Self::new(Left::File(path.to_owned()))
    }

    /// A process that is to end, by its number.
    pub fn process(id: u32) -> Self {
        Self::new(Left::Process(id))
    }

    fn new(left: Left) -> Self {
        let number = NUMBER.fetch_add(1, Ordering::Relaxed);
        lock(&LEFT).push((number, left));
        Self(number)
    }
}

impl Drop for Listed {
    fn drop(&mut self) {
        lock(&LEFT).retain(|(number, _)| *number != self.0);
    }
}

/// A list is whole whoever panicked beside it.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Does what must not be stopped halfway.
pub(super) fn undisturbed<T>(work: impl FnOnce() -> T) -> T {
    let _gate = lock(&GATE);
    work()
}

/// A file has taken its place.
pub(super) fn placed() {
    PLACED.fetch_add(1, Ordering::Relaxed);
}

/// A program that is stopped from here on leaves something that can be gone on with.
pub(super) fn leave(what: String) {
    *lock(&STAYS) = Some(what);
}

/// Takes away all that is listed: the program ends without its destructors.
pub(super) fn clear() {
    for (_, left) in lock(&LEFT).drain(..) {
        // What is gone already cannot be taken away.
        match left {
            Left::File(path) => drop(std::fs::remove_file(path)),
            Left::Process(id) => end(id),
        }
    }
}

#[cfg(unix)]
fn end(id: u32) {
    use rustix::process::{Pid, Signal, kill_process};
    if let Some(id) = i32::try_from(id).ok().and_then(Pid::from_raw) {
        let _ = kill_process(id, Signal::KILL);
    }
}

#[cfg(not(unix))]
fn end(_: u32) {}

/// From here on SIGINT, SIGTERM and SIGHUP end the program as they do by themselves, but leave nothing
/// behind and say so. One that is ignored, as under `nohup`, stays ignored.
#[cfg(unix)]
pub fn watch() {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    use signal_hook::iterator::Signals;
    let ignored = ignored();
    let heeded =
        [SIGINT, SIGTERM, SIGHUP].into_iter().filter(|signal| ignored >> (signal - 1) & 1 == 0);
    // Who cannot be told is ended by the signal itself.
    let Ok(mut signals) = Signals::new(heeded) else { return };
    std::thread::spawn(move || {
        let Some(signal) = signals.forever().next() else { return };
        let _gate = lock(&GATE);
        clear();
        let what = match (lock(&STAYS).take(), PLACED.load(Ordering::Relaxed)) {
            (Some(stays), _) => stays,
            (None, 0) => "nothing was written".to_owned(),
            (None, _) => "what was not finished is taken away".to_owned(),
        };
        let name = signal_hook::low_level::signal_name(signal).unwrap_or("a signal");
        let line = format!("schuler: stopped by {name}: {what}\n");
        // A terminal that has hung up hears nothing.
        let _ = std::io::Write::write_all(&mut std::io::stderr(), line.as_bytes());
        let _ = signal_hook::low_level::emulate_default_handler(signal);
    });
}

/// Where there are no such signals.
#[cfg(not(unix))]
pub fn watch() {}

/// The signals that this process was started to ignore, a bit for each from 1, as far as the system says.
#[cfg(unix)]
fn ignored() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or(0)
}
