//! A bar for what takes more than a second; none where the output is no terminal.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::cell::OnceCell;
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
            self.bar.get_or_init(|| bar(self.samples)).set_position(sample);
        }
    }

    /// Takes the bar away.
    pub fn finish(&self) {
        if let Some(bar) = self.bar.get() {
            bar.finish_and_clear();
        }
    }
}

fn bar(samples: u64) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(samples), ProgressDrawTarget::stderr());
    let template = "{bar:40} {percent:>3} % of {len} samples, {eta} left";
    match ProgressStyle::with_template(template) {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
