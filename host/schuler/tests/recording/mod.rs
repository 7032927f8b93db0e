//! Recordings: what their files may say, and that what is written reads back.

#![expect(clippy::excessive_precision, reason = "expected values keep their printed digits")]

mod clock;
mod csv;
mod foreign;
mod gaps;
mod measure;
mod navigation;
mod output;
mod psins;
mod rates;
mod reference;
mod replay;
mod stamps;
mod truth;

use schuler_simulator::input::InputError;
use schuler_simulator::recording::csv::INCREMENTS;
use schuler_simulator::recording::rows::Recording;
use schuler_simulator::recording::samples::{Sample, Samples};
use schuler_simulator::recording::survey::Survey;
use std::path::Path;

/// The whole of a recording.
const WHOLE: (f64, f64) = (f64::NEG_INFINITY, f64::INFINITY);

/// A recording gone through as a replay does.
fn read(
    name: &str,
    text: &str,
    rate_hz: Option<f64>,
    origin_s: Option<f64>,
) -> Result<(Survey, Vec<Sample>, Recording), InputError> {
    let recording = Recording::of_text(name, text)?;
    let survey = Survey::of(&recording, rate_hz.map(|rate_hz| 1.0 / rate_hz), WHOLE)?;
    let mut samples = Samples::new(&recording, &survey, origin_s)?;
    let mut list = Vec::new();
    while let Some(sample) = samples.advance()? {
        list.push(sample);
    }
    Ok((survey, list, recording))
}

/// A recording that reads well.
#[track_caller]
fn good(text: &str, origin_s: Option<f64>) -> (Survey, Vec<Sample>) {
    let (survey, samples, _) =
        read("imu.csv", text, None, origin_s).unwrap_or_else(|e| panic!("{e}"));
    (survey, samples)
}

/// Specific force at rest, m/s².
const REST: f64 = -9.8;

/// A file of increments at rest: samples that end at some times after another, by the stamps given.
fn at_rest(from_s: f64, ends_s: &[f64], stamp: impl Fn(f64) -> String) -> String {
    let mut text = INCREMENTS.join(",") + "\n";
    let mut before_s = from_s;
    for &end_s in ends_s {
        let step_s = end_s - before_s;
        text += &format!("{},{},0,0,0,0,{}\n", stamp(end_s), 5e-5 * step_s, REST * step_s);
        before_s = end_s;
    }
    text
}

/// Times of a constant rate after a start, s.
fn even(from_s: f64, rate_hz: f64, count: u32) -> Vec<f64> {
    (1..=count).map(|i| from_s + f64::from(i) / rate_hz).collect()
}

/// How far something at rest seems to fall, at most, m: where what is felt and the clock disagree.
fn fall(samples: &[Sample]) -> f64 {
    let (mut velocity, mut position, mut worst) = (0.0, 0.0, 0.0f64);
    for sample in samples {
        let gained = sample.increment.velocity_b.z - REST * sample.interval_s;
        position += (velocity + 0.5 * gained) * sample.interval_s;
        velocity += gained;
        worst = worst.max(f64::abs(position));
    }
    worst
}

/// Numbers from 0 to 1 without a pattern.
fn scattered(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / 2f64.powi(53)
    }
}

/// A path in a folder of its own that goes when the test ends.
fn scratch() -> tempfile::TempDir {
    tempfile::tempdir().expect("a temporary folder")
}

fn text(path: &Path) -> &str {
    path.to_str().expect("temporary folders have plain names")
}

#[track_caller]
fn near(value: f64, expected: f64, tolerance: f64) {
    assert!((value - expected).abs() <= tolerance, "{value} is not {expected} ± {tolerance:e}");
}
