//! A progress bar for tasks of more than a second, if the output is a terminal.

use indicatif::{HumanDuration, ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};
use std::fmt::Write;
use std::io::IsTerminal;
use std::sync::OnceLock;
use std::time::{Duration, Instant};

/// Before this, nobody is shown a bar.
const PATIENCE: Duration = Duration::from_secs(1);

/// The progress of a loop over samples.
pub struct Progress {
    start: Instant,
    samples: u64,
    bar: OnceLock<ProgressBar>,
    wanted: bool,
}

impl Progress {
    /// Towards a number of samples.
    pub fn new(samples: u64) -> Self {
        let wanted = std::io::stderr().is_terminal();
        Self { start: Instant::now(), samples, bar: OnceLock::new(), wanted }
    }

    /// So many samples are done.
    pub fn reach(&self, sample: u64) {
        if self.wanted && sample.is_multiple_of(4096) && self.start.elapsed() > PATIENCE {
            self.bar.get_or_init(|| bar(self.samples, self.start)).set_position(sample);
        }
    }

    /// Takes the bar away.
    pub fn finish(&self) {
        if let Some(bar) = self.bar.get() {
            bar.finish_and_clear();
        }
    }
}

fn bar(samples: u64, start: Instant) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(samples), ProgressDrawTarget::stderr());
    // By the mean pace since the start, which the bar itself has not seen.
    let left = move |state: &ProgressState, to: &mut dyn Write| {
        let fraction = f64::from(state.fraction().max(1e-6));
        let left = start.elapsed().mul_f64((1.0 - fraction) / fraction);
        // The bar's own buffer takes all.
        let _ = write!(to, "{}", HumanDuration(left));
    };
    match ProgressStyle::with_template("{wide_bar} {percent:>3} % of {len} samples, {left} left") {
        Ok(style) => bar.with_style(style.with_key("left", left)),
        Err(_) => bar,
    }
}

/// The progress of a row of cases, of which each may take long.
pub struct CaseProgress {
    bar: Option<ProgressBar>,
}

impl CaseProgress {
    /// Towards a number of cases.
    pub fn new(cases: u64) -> Self {
        if !std::io::stderr().is_terminal() {
            return Self { bar: None };
        }
        let bar = ProgressBar::with_draw_target(Some(cases), ProgressDrawTarget::stderr());
        let style = ProgressStyle::with_template("{pos} of {len} done, {elapsed}: {wide_msg}");
        bar.enable_steady_tick(Duration::from_millis(500));
        Self { bar: Some(style.map_or(bar.clone(), |style| bar.with_style(style))) }
    }

    /// A case begins.
    pub fn begin(&self, name: &str) {
        if let Some(bar) = &self.bar {
            bar.set_prefix(name.to_owned());
            bar.set_message(name.to_owned());
        }
    }

    /// So many of a case's samples are done.
    pub fn reach(&self, done: u64, all: u64) {
        if let Some(bar) = &self.bar
            && done.is_multiple_of(65536)
            && done > 0
        {
            bar.set_message(format!("{} % of {}", 100 * done / all.max(1), bar.prefix()));
        }
    }

    /// A case is done; `print` says what it came to, with the line out of the way.
    pub fn end<T>(&self, print: impl FnOnce() -> T) -> T {
        match &self.bar {
            Some(bar) => {
                bar.inc(1);
                bar.suspend(print)
            }
            None => print(),
        }
    }

    /// Takes the line away.
    pub fn finish(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}
