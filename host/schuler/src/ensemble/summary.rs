//! `ensemble.json`: an ensemble in numbers, for programs.

use super::statistics::Verdict;
use crate::report::head::{Head, Navigated};
use crate::report::summary;
use schuler_simulator::scene::{Scene, WindowShape};
use serde::Serialize;

/// The file's name. A run's `summary.json` may lie in the same folder.
pub const NAME: &str = "ensemble.json";

#[derive(Serialize)]
struct Summary<'a> {
    #[serde(flatten)]
    head: Head<'a>,
    scene: &'a str,
    scene_sha256: &'a str,
    runs: u64,
    failed_runs: u64,
    samples: u64,
    duration_s: f64,
    rate_hz: f64,
    seed: u64,
    #[serde(flatten)]
    navigated: Navigated,
    saturated: u64,
    tests: Tests,
}

/// χ² tests against theory.
#[derive(Serialize)]
struct Tests {
    done: usize,
    failed: usize,
    left_out: usize,
}

/// What came of an ensemble.
pub struct Outcome<'a> {
    /// What was flown.
    pub scene: &'a Scene,
    /// The window.
    pub window: WindowShape,
    /// Runs in all, and those that did not reach their end.
    pub runs: [u64; 2],
    /// Samples in which a sensor was at its limit.
    pub saturated: u64,
    /// The tests.
    pub verdict: &'a Verdict,
    /// Comparisons without tests, because rounding matters.
    pub left_out: usize,
}

/// The summary as JSON, which names the files that belong together.
pub fn json(outcome: &Outcome, files: &[&str]) -> String {
    let Outcome { scene, window, runs: [runs, failed_runs], saturated, verdict, left_out } =
        *outcome;
    summary::text(&Summary {
        head: Head::new("ensemble", files),
        scene: &scene.name,
        scene_sha256: &scene.text_sha256,
        runs,
        failed_runs,
        samples: scene.samples(),
        duration_s: scene.duration_s,
        rate_hz: scene.rate_hz,
        seed: scene.seed,
        navigated: Navigated::new(&scene.navigator, Some(window)),
        saturated,
        tests: Tests { done: verdict.tests, failed: verdict.failed, left_out },
    })
}
