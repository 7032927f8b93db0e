//! Recorded inertial data: reading it, writing it, and the state it starts from.

pub mod csv;
pub mod navigation;
pub mod psins;
pub mod quadrature;

use crate::input::{Complaint, InputError, read_text};
use crate::rest::units::Units;
use navigation::NavigationRow;
use schuler::alignment::units::Kind;
use schuler::sample::Increment;
use std::path::Path;

/// One recorded sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// The end of its interval, s.
    pub time_s: f64,
    /// The line in its file, from 1.
    pub line: u64,
    /// Increments over its interval: forward, right, down; rad, m/s.
    pub increment: Increment<f64>,
}

/// A stream of samples from a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Recording {
    /// The file, for errors about its samples.
    pub file: String,
    /// The sample interval: the mean step of the longest stretch without a gap, s.
    pub interval_s: f64,
    /// In the order of time, at least two.
    pub samples: Vec<Sample>,
    /// What the file's samples are, or are said to be.
    pub kind: Kind,
    /// The state that the file itself says it starts from.
    pub initial: Option<NavigationRow>,
}

/// A step of time that is not the sample interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gap {
    /// Index of the sample that ends it.
    pub index: usize,
    /// Its length, s.
    pub step_s: f64,
    /// Samples that are missing; 0 where the step is short.
    pub missing: u64,
}

impl Recording {
    /// From a file, its numbers in units of their own.
    pub fn read_in(file: &str, units: &Units) -> Result<Self, InputError> {
        let text = read_text(file)?;
        let mut recording = Self::parse(file, &text, units.kind)?;
        for sample in &mut recording.samples {
            sample.increment = units.apply(&sample.increment);
        }
        Ok(recording)
    }

    /// From a file: a PSINS `.imu` (by its ending or its `%`), else a CSV of increments or rates.
    pub fn read(file: &str) -> Result<Self, InputError> {
        Self::read_in(file, &Units::default())
    }

    fn parse(file: &str, text: &str, kind: Option<Kind>) -> Result<Self, InputError> {
        let is_psins = Path::new(file).extension().is_some_and(|e| e.eq_ignore_ascii_case("imu"))
            || text.trim_start().starts_with('%');
        match kind {
            Some(Kind::Rates) if is_psins => {
                let what = "a PSINS .imu holds increments";
                Err(InputError::option("--units", Complaint::new(what, "units without rates")))
            }
            _ if is_psins => psins::parse(file, text),
            kind => csv::parse_as(file, text, kind),
        }
    }

    fn new(
        file: &str,
        samples: Vec<Sample>,
        interval_s: Option<f64>,
        initial: Option<NavigationRow>,
    ) -> Result<Self, InputError> {
        let complain = |what: String| {
            InputError::file(file, Complaint::new(what, "two samples or more, at most 1 s each"))
        };
        if samples.len() < 2 {
            return Err(complain(format!("has {} samples", samples.len())));
        }
        let interval_s = interval_s.unwrap_or_else(|| sample_interval(&samples));
        if interval_s > 1.0 {
            return Err(complain(format!("has samples of {interval_s} s")));
        }
        Ok(Self { file: file.to_owned(), interval_s, samples, kind: Kind::Increments, initial })
    }

    /// Where the first sample's interval starts, s.
    pub fn start_s(&self) -> f64 {
        self.samples.first().map_or(0.0, |first| first.time_s) - self.interval_s
    }

    /// The end of the last sample, s.
    pub fn end_s(&self) -> f64 {
        self.samples.last().map_or(0.0, |last| last.time_s)
    }

    /// The steps that differ from the sample interval by more than three quarters of it. Smaller
    /// differences are taken for jitter and rounding of the time stamps.
    pub fn gaps(&self) -> impl Iterator<Item = Gap> {
        self.samples.windows(2).enumerate().filter_map(|(i, pair)| {
            let step_s = pair[1].time_s - pair[0].time_s;
            is_gap(step_s, self.interval_s).then(|| {
                let steps = (step_s / self.interval_s).round().max(1.0);
                Gap { index: i + 1, step_s, missing: steps as u64 - 1 }
            })
        })
    }

    /// An error about one of its samples.
    pub fn error(&self, index: usize, complaint: Complaint) -> InputError {
        match self.samples.get(index) {
            Some(sample) => InputError::line(&self.file, sample.line, complaint),
            None => InputError::file(&self.file, complaint),
        }
    }
}

fn is_gap(step_s: f64, interval_s: f64) -> bool {
    (step_s - interval_s).abs() > 0.75 * interval_s
}

/// The stretches without a gap, in order.
fn stretches(samples: &[Sample], interval_s: f64) -> impl Iterator<Item = &[Sample]> {
    samples.chunk_by(move |a, b| !is_gap(b.time_s - a.time_s, interval_s))
}

/// The mean step of the longest stretch without a gap, gaps being told by the median step.
fn sample_interval(samples: &[Sample]) -> f64 {
    let mut steps: Vec<_> = samples.windows(2).map(|p| p[1].time_s - p[0].time_s).collect();
    let middle = (steps.len() - 1) / 2;
    let median = *steps.select_nth_unstable_by(middle, f64::total_cmp).1;
    let longest = stretches(samples, median).max_by_key(|stretch| stretch.len()).unwrap_or(&[]);
    let [first, .., last] = longest else { return median };
    let span = last.time_s - first.time_s;
    let mean = span / (longest.len() - 1) as f64;
    // Most rates are whole numbers: one is taken if it lies within the time stamps' own rounding.
    let whole = 1.0 / (1.0 / mean).round();
    let rounding = 2.0 * f64::EPSILON * (1.0 + first.time_s.abs().max(last.time_s.abs()) / span);
    if (whole / mean - 1.0).abs() <= rounding { whole } else { mean }
}
