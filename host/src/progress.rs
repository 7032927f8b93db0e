//! A bar for what takes more than a second; none where the output is no terminal.

use indicatif::{HumanDuration, ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};
use std::cell::OnceCell;
use std::fmt::Write;
use std::io::IsTerminal;
use std::time::{Duration, Instant};

/// Before this, nobody is shown a bar.
const PATIENCE: Duration = Duration::from_secs(1);

/// The progress of a loop over samples.
pub struct Progress {
    start: Instant,
    samples: u64,
    bar: OnceCell<ProgressBar>,
    wanted: bool,
}

impl Progress {
    /// Towards a number of samples.
    pub fn new(samples: u64) -> Self {
        let wanted = std::io::stderr().is_terminal();
        Self { start: Instant::now(), samples, bar: OnceCell::new(), wanted }
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
    match ProgressStyle::with_template("{bar:40} {percent:>3} % of {len} samples, {left} left") {
        Ok(style) => bar.with_style(style.with_key("left", left)),
        Err(_) => bar,
    }
}
