//! `ensemble.json`: an ensemble in numbers, for programs.

use super::accuracy::Accuracy;
use super::findings::Findings;
use crate::report::head::{Head, Navigated};
use crate::report::summary;
use schuler_simulator::aided::report::Report;
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
    consistency_tests: ConsistencyTests,
    #[serde(skip_serializing_if = "Option::is_none")]
    r#final: Option<Final>,
    verdict: &'a [String],
    /// Of aided runs: what became of their measurements.
    #[serde(skip_serializing_if = "Option::is_none")]
    measurements: Option<&'a Report>,
}

/// χ² tests against theory.
#[derive(Serialize)]
struct Tests {
    done: usize,
    failed: usize,
    left_out: usize,
}

/// Tests of states together.
#[derive(Serialize)]
struct ConsistencyTests {
    done: usize,
    failed: usize,
}

/// Circular and vertical error at the end; null where theory has ended.
#[derive(Serialize)]
struct Final {
    time_s: f64,
    cep50_m: f64,
    cep95_m: f64,
    vertical95_m: f64,
    cep50_nmi_h: f64,
    cep50_theory_m: Option<f64>,
    cep95_theory_m: Option<f64>,
    vertical95_theory_m: Option<f64>,
}

impl Final {
    fn new(accuracy: &Accuracy) -> Self {
        let Accuracy { time_s, cep50, cep95, vertical95 } = accuracy;
        let known = |x: f64| (!x.is_nan()).then_some(x);
        Self {
            time_s: *time_s,
            cep50_m: cep50.runs.value,
            cep95_m: cep95.runs.value,
            vertical95_m: vertical95.runs.value,
            cep50_nmi_h: accuracy.nmi_h(cep50.runs.value),
            cep50_theory_m: known(cep50.theory),
            cep95_theory_m: known(cep95.theory),
            vertical95_theory_m: known(vertical95.theory),
        }
    }
}

/// What is told of an ensemble, whatever it is compared with.
pub struct Told<'a> {
    /// What was flown.
    pub scene: &'a Scene,
    /// The command that flies it, an argument each, after the program's name.
    pub command: &'a [String],
    /// The window.
    pub window: WindowShape,
    /// Runs in all, and those that did not reach their end.
    pub runs: [u64; 2],
    /// Samples in which a sensor was at its limit.
    pub saturated: u64,
    /// Tests against theory: done, failed, left out.
    pub tests: [usize; 3],
    /// Tests of states together: done, failed.
    pub together: [usize; 2],
    /// At the end.
    pub accuracy: Option<&'a Accuracy>,
    /// What was found out, in sentences.
    pub sentences: &'a [String],
    /// Of aided runs: what became of their measurements.
    pub measurements: Option<&'a Report>,
}

/// The summary as JSON, which names the files that belong together.
pub fn text(told: &Told, files: &[&str]) -> String {
    let Told { scene, command, window, runs, saturated, .. } = *told;
    let [runs, failed_runs] = runs;
    let ([done, failed, left_out], [together, together_failed]) = (told.tests, told.together);
    summary::text(&Summary {
        head: Head::of_command("ensemble", files, command),
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
        tests: Tests { done, failed, left_out },
        consistency_tests: ConsistencyTests { done: together, failed: together_failed },
        r#final: told.accuracy.map(Final::new),
        verdict: told.sentences,
        measurements: told.measurements,
    })
}

/// What came of an ensemble that is compared with theory.
pub struct Outcome<'a> {
    /// What was flown.
    pub scene: &'a Scene,
    /// The command that flies it, an argument each, after the program's name.
    pub command: &'a [String],
    /// The window.
    pub window: WindowShape,
    /// Runs in all, and those that did not reach their end.
    pub runs: [u64; 2],
    /// Samples in which a sensor was at its limit.
    pub saturated: u64,
    /// What was found out.
    pub findings: &'a Findings,
    /// The same in sentences.
    pub sentences: &'a [String],
}

/// The summary as JSON, which names the files that belong together.
pub fn json(outcome: &Outcome, files: &[&str]) -> String {
    let Outcome { scene, command, window, runs, saturated, findings, sentences } = *outcome;
    let Findings { verdict, together, left_out, instants, .. } = findings;
    let told = Told {
        scene,
        command,
        window,
        runs,
        saturated,
        tests: [verdict.tests, verdict.failed, *left_out],
        together: [together.tests, together.failed],
        accuracy: instants.last().map(|at| &at.accuracy),
        sentences,
        measurements: None,
    };
    text(&told, files)
}
