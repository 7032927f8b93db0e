//! A progress bar for tasks of more than a second, if the output is a terminal: one line of its width.

use console::Term;
use indicatif::{HumanDuration, ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};
use std::fmt::Write;
use std::io::IsTerminal;
use std::sync::OnceLock;
use std::time::{Duration, Instant};

/// Before this, nobody is shown a bar.
const PATIENCE: Duration = Duration::from_secs(1);
/// A bar needs a terminal of so many columns; a narrower one has the words alone.
const ROOM: u16 = 60;

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
            let columns = Term::stderr().size().1;
            let on = ProgressDrawTarget::stderr;
            self.bar
                .get_or_init(|| bar(self.samples, self.start, on(), columns))
                .set_position(sample);
        }
    }

    /// Takes the bar away.
    pub fn finish(&self) {
        if let Some(bar) = self.bar.get() {
            bar.finish_and_clear();
        }
    }
}

fn bar(samples: u64, start: Instant, on: ProgressDrawTarget, columns: u16) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(samples), on);
    // By the mean pace since the start, which the bar itself has not seen.
    let words = move |state: &ProgressState, to: &mut dyn Write| {
        let fraction = f64::from(state.fraction().max(1e-6));
        let left = HumanDuration(start.elapsed().mul_f64((1.0 - fraction) / fraction));
        let percent = 100.0 * fraction;
        // The bar's own buffer takes all.
        let _ = write!(to, "{percent:>3.0} % of {samples} samples, {left} left");
    };
    let template = match columns {
        ROOM.. => "{wide_bar} {words}".to_owned(),
        // Cut to the width.
        _ => format!("{{words:{columns}!}}"),
    };
    match ProgressStyle::with_template(&template) {
        Ok(style) => bar.with_style(style.with_key("words", words)),
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
        let progress = Self::on(cases, ProgressDrawTarget::stderr());
        if let Some(bar) = &progress.bar {
            bar.enable_steady_tick(Duration::from_millis(500));
        }
        progress
    }

    fn on(cases: u64, on: ProgressDrawTarget) -> Self {
        let bar = ProgressBar::with_draw_target(Some(cases), on);
        let style = ProgressStyle::with_template("{pos} of {len} done, {elapsed}: {wide_msg}");
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

#[cfg(test)]
mod tests {
    use super::*;
    use indicatif::TermLike;
    use std::io;
    use std::sync::{Arc, Mutex};

    /// A terminal that remembers what is written on a line.
    #[derive(Clone, Debug)]
    struct Paper {
        columns: u16,
        lines: Arc<Mutex<Vec<String>>>,
    }

    impl TermLike for Paper {
        fn width(&self) -> u16 {
            self.columns
        }
        fn move_cursor_up(&self, _: usize) -> io::Result<()> {
            Ok(())
        }
        fn move_cursor_down(&self, _: usize) -> io::Result<()> {
            Ok(())
        }
        fn move_cursor_right(&self, _: usize) -> io::Result<()> {
            Ok(())
        }
        fn move_cursor_left(&self, _: usize) -> io::Result<()> {
            Ok(())
        }
        fn write_line(&self, text: &str) -> io::Result<()> {
            self.write_str(text)?;
            self.clear_line()
        }
        fn write_str(&self, text: &str) -> io::Result<()> {
            let mut lines = self.lines.lock().unwrap();
            match lines.last_mut() {
                Some(line) => line.push_str(text),
                None => lines.push(text.to_owned()),
            }
            Ok(())
        }
        fn clear_line(&self) -> io::Result<()> {
            self.lines.lock().unwrap().push(String::new());
            Ok(())
        }
        fn flush(&self) -> io::Result<()> {
            Ok(())
        }
    }

    /// What is drawn on a terminal of so many columns; none of it is wider.
    fn drawn(columns: u16, draw: impl FnOnce(ProgressDrawTarget)) -> String {
        let paper = Paper { columns, lines: Arc::default() };
        draw(ProgressDrawTarget::term_like(Box::new(paper.clone())));
        let lines = paper.lines.lock().unwrap();
        for line in lines.iter() {
            let width = line.trim_end().chars().count();
            assert!(width <= usize::from(columns), "{width} of {columns}: {line}");
        }
        lines.join("\n")
    }

    #[test]
    fn lines_do_not_wrap() {
        for columns in [20, 40, 59, 60, 80, 200] {
            let text = drawn(columns, |on| {
                let bar = bar(1_000_000_000, Instant::now(), on, columns);
                bar.set_position(370_000_000);
                bar.force_draw();
            });
            assert!(text.contains(" 37 % of 1000000000"), "{columns}: {text}");
            let text = drawn(columns, |on| {
                let progress = CaseProgress::on(270, on);
                progress.begin(&"a case with a very long name ".repeat(8));
                progress.reach(65536, 131_072);
                progress.end(|| ());
            });
            assert!(text.contains("of 270 done"), "{columns}: {text}");
        }
    }
}
