//! `ensemble`: many runs of a scene, and whether they scatter as theory says.

use crate::error::{Answer, Fault};
use crate::interrupt::Watch;
use crate::options::{OF_ENSEMBLE, Options};
use crate::scene::{self, Scene};
use crate::table::{Rows, Table};
use crate::{notebook, options};
use numpy::{PyArray1, PyArray2, PyArray3, PyArrayMethods as _};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use schuler_host::cli::{EnsembleArgs, Times};
use schuler_host::ensemble::conclusion::{self, command, threads};
use schuler_host::ensemble::files::Extra;
use schuler_host::ensemble::findings::{At, Findings};
use schuler_host::ensemble::sentences::sentences;
use schuler_host::ensemble::spread::Matrix;
use schuler_host::ensemble::statistics::Comparison;
use schuler_host::ensemble::summary::{self, Outcome};
use schuler_host::ensemble::{check, csv, page, stops};
use schuler_simulator::ensemble::batches::{self, Means};
use schuler_simulator::ensemble::group::{Ground, Unit};
use schuler_simulator::ensemble::kept::Kept;
use schuler_simulator::ensemble::part::block::Content as _;
use schuler_simulator::flight::Nine;
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::scene::{Scene as Flown, WindowShape};
use schuler_simulator::simulate::{FlightError, nine};
use schuler_simulator::source::Source;

/// At how many times the drift is read, unless told.
const TIMES: Times = Times::Equal(8);
/// Numbers of an instant.
const NINE: usize = Nine::NAMES.len();
/// Runs of a scene beside theory. Arrays have a row for each instant, and the nine numbers of `drift.csv`.
#[pyclass(frozen, module = "schuler")]
pub struct Ensemble {
    found: Found,
    /// Of the instants.
    #[pyo3(get)]
    time_s: Py<PyArray1<f64>>,
    /// Instant, run, number: computed less true, of the runs that reached their end.
    #[pyo3(get)]
    drift: Py<PyArray3<f64>>,
    /// Over the runs.
    #[pyo3(get)]
    mean: Py<PyArray2<f64>>,
    /// Over the runs.
    #[pyo3(get)]
    sigma: Py<PyArray2<f64>>,
    /// What theory expects; not a number where it has ended.
    #[pyo3(get)]
    mean_theory: Py<PyArray2<f64>>,
    /// What theory expects; not a number where it has ended.
    #[pyo3(get)]
    sigma_theory: Py<PyArray2<f64>>,
    /// Instant, number, number: over the runs.
    #[pyo3(get)]
    covariance: Py<PyArray3<f64>>,
    /// What theory expects; not a number where it has ended.
    #[pyo3(get)]
    covariance_theory: Py<PyArray3<f64>>,
    /// Circles and heights that hold a share of the runs, at each instant: `accuracy.csv`.
    #[pyo3(get)]
    accuracy: Py<Table>,
}

/// What comes of it, without the interpreter.
struct Found {
    scene: Flown,
    kept: Kept,
    times_s: Vec<f64>,
    findings: Findings,
    sentences: Vec<String>,
    command: Vec<String>,
    window: WindowShape,
    text: String,
}

#[pymethods]
impl Ensemble {
    #[getter]
    fn scene(&self) -> Scene {
        Scene { scene: self.found.scene.clone() }
    }

    /// Runs that were flown.
    #[getter]
    fn runs(&self) -> u64 {
        self.found.kept.runs.end
    }

    /// Names of the nine.
    #[getter]
    fn names(&self) -> Vec<&'static str> {
        Nine::NAMES.to_vec()
    }

    /// Number, sample and reason of each run that did not reach its end.
    #[getter]
    fn failed(&self) -> Vec<(u64, u64, String)> {
        let failed = self.found.kept.flown.failed.iter();
        failed.map(|failed| (failed.run, failed.sample, failed.why.to_string())).collect()
    }

    /// Tests against theory: how many, and how many fail.
    #[getter]
    fn tests(&self) -> (usize, usize) {
        let Findings { verdict, together, .. } = &self.found.findings;
        (verdict.tests + together.tests, verdict.failed + together.failed)
    }

    /// What parts from theory, in sentences.
    #[getter]
    fn verdict(&self) -> Vec<String> {
        self.found.sentences.clone()
    }

    /// What the program prints.
    #[getter]
    fn text(&self) -> &str {
        &self.found.text
    }

    /// `ensemble.json` as a dict, without the command line and the files that there are none of.
    #[getter]
    fn summary<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        notebook::summary(py, &summary::json(&self.found.outcome(), &[]))
    }

    /// `ensemble.html`.
    fn report(&self, py: Python<'_>) -> String {
        py.detach(|| page::page(&self.found.outcome()))
    }

    fn __str__(&self) -> &str {
        &self.found.text
    }

    fn __repr__(&self) -> String {
        let (tests, fail) = self.tests();
        let (runs, name) = (self.runs(), &self.found.scene.name);
        format!("<schuler.Ensemble of {runs} runs of {name}: {fail} of {tests} tests fail>")
    }

    fn _repr_html_(&self, py: Python<'_>) -> String {
        notebook::framed(&self.report(py))
    }
}

/// Flies many runs of a scene.
#[pyfunction]
#[pyo3(signature = (scene=None, runs=None, *, at=None, budget=None, threads=None, **options))]
pub fn ensemble(
    py: Python<'_>,
    scene: Option<&Bound<'_, PyAny>>,
    runs: Option<&Bound<'_, PyAny>>,
    at: Option<&Bound<'_, PyAny>>,
    budget: Option<&Bound<'_, PyAny>>,
    threads: Option<&Bound<'_, PyAny>>,
    options: Option<&Bound<'_, PyDict>>,
) -> Answer<Ensemble> {
    let Asked { scene, args } = asked([scene, runs, at, budget, threads], options)?;
    if scene.aiding.is_there() {
        let complaint = Complaint::new("is aided", "aided_ensemble(), or a scene that is not");
        return Err(InputError::option("scene", complaint).into());
    }
    let mut watch = Watch::new();
    let found = py.detach(|| Found::new(scene, &args, &mut watch));
    watch.raised()?;
    found?.ensemble(py)
}

/// A scene with its options, and the command line that flies it.
pub struct Asked {
    /// What is flown.
    pub scene: Flown,
    /// How often, read when.
    pub args: EnsembleArgs,
}

/// From the arguments scene, runs, at, budget, threads, and options.
pub fn asked(
    [scene, runs, at, budget, threads]: [Option<&Bound<'_, PyAny>>; 5],
    options: Option<&Bound<'_, PyDict>>,
) -> Answer<Asked> {
    let options = Options::among(OF_ENSEMBLE, options)?;
    let mut scene = scene::of(scene, None)?;
    options.apply(&mut scene)?;
    let count = |option, given| options::parsed(option, given, schuler_host::cli::runs);
    let args = EnsembleArgs {
        command: None,
        scene: Some(scene.name.clone()),
        runs: count("--runs", runs)?.unwrap_or(RUNS),
        at: times(at)?.unwrap_or(TIMES),
        out: None,
        keep: false,
        svg: false,
        budget: count("--budget", budget)?,
        shard: None,
        resume: false,
        batch: None,
        threads: options::parsed("--threads", threads, schuler_host::cli::threads)?,
        flight: options.flight,
        navigator: options.navigator,
        vertical: options.handling.vertical,
    };
    args.check(&scene)?;
    check(&scene)?;
    Ok(Asked { scene, args })
}

/// Runs, unless told.
const RUNS: u64 = 64;

/// When runs are read: a number of times, times in seconds, or either as text.
fn times(at: Option<&Bound<'_, PyAny>>) -> Answer<Option<Times>> {
    if let Some(at) = at
        && let Ok(times_s) = at.extract::<Vec<f64>>()
    {
        let times: Vec<_> = times_s.iter().map(|time_s| format!("{time_s}s")).collect();
        let times = Times::parse(&times.join(","));
        return Ok(Some(times.map_err(|complaint| Fault::option("--at", complaint))?));
    }
    options::parsed("--at", at, Times::parse)
}

impl Found {
    fn new(scene: Flown, args: &EnsembleArgs, watch: &mut Watch) -> Result<Self, FlightError> {
        let source = Source::new(&scene, false)?;
        let ground = Ground::new(&scene, &source);
        let stops = stops(&ground, &args.at);
        let unit = ground.widest(args.runs);
        let threads = threads(args.threads, unit, args.runs);
        let means = Means { unit, threads, stops: &stops, batch: None };
        ground.start(Unit::Alone, 0..1)?;
        let mut kept = Kept::none(0);
        batches::fly(&ground, 0..args.runs, means, &|_| {}, &mut |batch| {
            // Batches of one flight follow one another.
            let _ = kept.join(batch);
            watch.ask().map_err(FlightError::from)
        })?;
        let findings = Findings::new(&ground, &kept, args.budget, means)?;
        let sentences = sentences(&findings);
        let text = conclusion::text(&ground, &kept, &findings, &sentences);
        let readings = kept.flown.readings.iter();
        let times_s = readings.map(|reading| source.time_s(reading.samples)).collect();
        let (window, command) = (ground.plan.window, command(args, Extra::default(), args.budget));
        Ok(Self { kept, times_s, findings, sentences, command, window, text, scene })
    }

    fn outcome(&self) -> Outcome<'_> {
        Outcome {
            scene: &self.scene,
            command: &self.command,
            window: self.window,
            runs: [self.kept.runs.end, self.kept.flown.failed.len() as u64],
            saturated: self.kept.flown.saturated,
            findings: &self.findings,
            sentences: &self.sentences,
        }
    }

    fn ensemble(self, py: Python<'_>) -> Answer<Ensemble> {
        let Self { kept, times_s, findings, .. } = &self;
        let ended = kept.flown.readings.first().map_or(0, |reading| reading.drifts.len());
        let drifts = kept.flown.readings.iter().flat_map(|reading| &reading.drifts);
        let drift = drifts.flat_map(|drift| nine(drift).numbers()).collect();
        let of = |number: fn(&Comparison) -> f64| -> PyResult<Py<PyArray2<f64>>> {
            let numbers: Vec<f64> = findings.comparisons.iter().map(number).collect();
            let rows = numbers.len() / NINE;
            Ok(PyArray1::from_vec(py, numbers).reshape([rows, NINE])?.unbind())
        };
        let cube = |numbers: Vec<f64>, shape: [usize; 3]| -> PyResult<Py<PyArray3<f64>>> {
            Ok(PyArray1::from_vec(py, numbers).reshape(shape)?.unbind())
        };
        let matrices = |matrix: fn(&At) -> &Matrix| {
            let numbers = findings.instants.iter().flat_map(matrix).flatten().copied().collect();
            cube(numbers, [findings.instants.len(), NINE, NINE])
        };
        let mut accuracy = Rows::new(&csv::ACCURACY, findings.instants.len() as u64);
        findings.instants.iter().for_each(|at| accuracy.add(&csv::accuracy_of(at)));
        Ok(Ensemble {
            time_s: PyArray1::from_slice(py, times_s).unbind(),
            drift: cube(drift, [times_s.len(), ended, NINE])?,
            mean: of(|comparison| comparison.mean)?,
            sigma: of(|comparison| comparison.sigma)?,
            mean_theory: of(|comparison| comparison.mean_theory)?,
            sigma_theory: of(|comparison| comparison.sigma_theory)?,
            covariance: matrices(|at| &at.spread.covariance)?,
            covariance_theory: matrices(|at| &at.covariance_theory)?,
            accuracy: accuracy.table(py)?,
            found: self,
        })
    }
}
