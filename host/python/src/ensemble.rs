//! `ensemble`: many runs of a scene, and whether they scatter as theory says.

use crate::error::{Answer, Fault, theory};
use crate::scene::{self, Scene};
use numpy::{PyArray1, PyArray2, PyArray3, PyArrayMethods as _};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use schuler_host::ensemble::statistics::{self, Comparison, Verdict};
use schuler_host::ensemble::{check, table};
use schuler_report::svg::escape;
use schuler_simulator::ensemble::fleet::{self, Flown};
use schuler_simulator::ensemble::group::{Ground, Unit};
use schuler_simulator::flight::Nine;
use schuler_simulator::scene::{Precision, Scene as Asked};
use schuler_simulator::simulate::nine;
use schuler_simulator::source::Source;
use std::num::NonZero;
use std::ops::RangeInclusive;
use std::thread;

/// Runs, as the command line takes them.
const RUNS: RangeInclusive<u64> = 4..=10_000_000;
/// At how many times the drift is read, unless told.
const INSTANTS: u64 = 8;
/// At how many times, at most.
const MOST_INSTANTS: u64 = 100_000;
/// Numbers of an instant.
const NINE: usize = Nine::NAMES.len();

/// Runs of a scene beside theory. Arrays have a row for each instant, and the nine numbers of `drift.csv`.
#[pyclass(frozen, get_all, module = "schuler")]
pub struct Ensemble {
    scene: Py<Scene>,
    /// Runs that were flown.
    runs: u64,
    /// Names of the nine.
    names: Vec<&'static str>,
    /// Of the instants.
    time_s: Py<PyArray1<f64>>,
    /// Instant, run, number: computed less true, of the runs that reached their end.
    drift: Py<PyArray3<f64>>,
    /// Over the runs.
    mean: Py<PyArray2<f64>>,
    /// Over the runs.
    sigma: Py<PyArray2<f64>>,
    /// What theory expects; not a number where it has ended.
    mean_theory: Py<PyArray2<f64>>,
    /// What theory expects; not a number where it has ended.
    sigma_theory: Py<PyArray2<f64>>,
    /// Number, sample and reason of each run that did not reach its end.
    failed: Vec<(u64, u64, String)>,
    /// χ² tests against theory: how many, and how many fail.
    tests: (usize, usize),
    /// What the program prints.
    text: String,
}

#[pymethods]
impl Ensemble {
    fn __str__(&self) -> &str {
        &self.text
    }

    fn __repr__(&self) -> String {
        let (tests, fail) = self.tests;
        let name = &self.scene.get().scene.name;
        format!("<schuler.Ensemble of {} runs of {name}: {fail} of {tests} tests fail>", self.runs)
    }

    fn _repr_html_(&self) -> String {
        format!("<pre>{}</pre>", escape(&self.text))
    }
}

/// Flies many runs of a scene.
#[pyfunction]
#[pyo3(signature = (scene=None, runs=64, *, instants=INSTANTS, threads=None, **options))]
pub fn ensemble(
    py: Python<'_>,
    scene: Option<&Bound<'_, PyAny>>,
    runs: u64,
    instants: u64,
    threads: Option<usize>,
    options: Option<&Bound<'_, PyDict>>,
) -> Answer<Ensemble> {
    let scene = scene::of(scene, options)?;
    if !RUNS.contains(&runs) {
        let accepted = format!("an integer from {} to {}", RUNS.start(), RUNS.end());
        return Err(Fault::argument("--runs", "is not a number of runs", accepted));
    }
    if !(1..=MOST_INSTANTS).contains(&instants) {
        let accepted = format!("an integer from 1 to {MOST_INSTANTS}");
        return Err(Fault::argument("instants", format!("{instants} is out of range"), accepted));
    }
    check(&scene)?;
    let found = py.detach(|| found(&scene, runs, instants, threads))?;
    found.ensemble(py, scene, runs)
}

/// What comes of it, without the interpreter.
struct Found {
    flown: Flown,
    times_s: Vec<f64>,
    comparisons: Vec<Comparison>,
    text: String,
}

fn found(scene: &Asked, runs: u64, instants: u64, threads: Option<usize>) -> Answer<Found> {
    let source = Source::new(scene, false)?;
    let ground = Ground::new(scene, &source);
    ground.start(Unit::Alone, 0..1)?;
    let unit = ground.widest(runs);
    let processors = || thread::available_parallelism().map_or(1, NonZero::get);
    let threads = threads.unwrap_or_else(processors).max(1);
    let flown = fleet::fly(&ground, runs, unit, threads, instants, &|_| {})?;
    let ended = runs - flown.failed.len() as u64;
    // Of a single run there is no spread.
    let readings = if ended > 1 { flown.readings.as_slice() } else { &[] };
    let mut theory = theory(scene)?.for_runs(ended.max(1));
    let time_s = |sample: u64| source.time_s(sample);
    let mut comparisons = statistics::compare(readings, time_s, &mut theory);
    let precision = scene.navigator.precision;
    let mut note = String::new();
    if precision != Precision::F64 {
        // What rounding adds is not theory's.
        comparisons.iter_mut().for_each(|comparison| comparison.tests = None);
        note =
            format!("not tested: rounding in {precision}, which theory leaves out, may matter\n");
    }
    let text = table::table(&comparisons, ended)
        + &note
        + &table::failures(&flown.failed, scene.seed, runs, time_s);
    let times_s = flown.readings.iter().map(|reading| time_s(reading.samples)).collect();
    Ok(Found { flown, times_s, comparisons, text })
}

impl Found {
    fn ensemble(self, py: Python<'_>, scene: Asked, runs: u64) -> Answer<Ensemble> {
        let Self { flown, times_s, comparisons, text } = self;
        let instants = times_s.len();
        let ended = flown.readings.first().map_or(0, |reading| reading.drifts.len());
        let drifts = flown.readings.iter().flat_map(|reading| &reading.drifts);
        let drift: Vec<f64> = drifts.flat_map(|drift| nine(drift).numbers()).collect();
        let of = |number: fn(&Comparison) -> f64| -> PyResult<Py<PyArray2<f64>>> {
            let numbers: Vec<f64> = comparisons.iter().map(number).collect();
            let rows = numbers.len() / NINE;
            Ok(PyArray1::from_vec(py, numbers).reshape([rows, NINE])?.unbind())
        };
        let verdict = Verdict::new(&comparisons);
        let failed = flown.failed.iter().map(|f| (f.run, f.sample, f.why.to_string())).collect();
        Ok(Ensemble {
            scene: Py::new(py, Scene { scene })?,
            runs,
            names: Nine::NAMES.to_vec(),
            time_s: PyArray1::from_vec(py, times_s).unbind(),
            drift: PyArray1::from_vec(py, drift).reshape([instants, ended, NINE])?.unbind(),
            mean: of(|comparison| comparison.mean)?,
            sigma: of(|comparison| comparison.sigma)?,
            mean_theory: of(|comparison| comparison.mean_theory)?,
            sigma_theory: of(|comparison| comparison.sigma_theory)?,
            failed,
            tests: (verdict.tests, verdict.failed),
            text,
        })
    }
}
