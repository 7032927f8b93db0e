//! `aided_ensemble`: many runs of an aided scene, and whether their errors are as the filters say.

use crate::ensemble::{Asked, asked};
use crate::error::Answer;
use crate::interrupt::Watch;
use crate::notebook;
use crate::scene::Scene;
use numpy::{PyArray1, PyArray2, PyArray3, PyArrayMethods as _};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use schuler_host::ensemble::aided::findings::Findings;
use schuler_host::ensemble::aided::{csv, page, shares, text};
use schuler_host::ensemble::conclusion::{command, threads};
use schuler_host::ensemble::files::Extra;
use schuler_host::ensemble::stops;
use schuler_host::ensemble::summary::{self, Told};
use schuler_simulator::aided::batches::{Means, fly_range};
use schuler_simulator::aided::kept::AidedRuns;
use schuler_simulator::aided::runs::{GROUPS, Scenes, Together};
use schuler_simulator::ensemble::group::{Ground, Unit};
use schuler_simulator::ensemble::part::block::Content as _;
use schuler_simulator::flight::Nine;
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::scene::WindowShape;
use schuler_simulator::simulate::FlightError;
use schuler_simulator::source::Source;

/// Numbers of an instant.
const NINE: usize = Nine::NAMES.len();

/// Aided runs beside what their filters say. Arrays have a row for each instant.
#[pyclass(frozen, module = "schuler")]
pub struct AidedEnsemble {
    found: Found,
    /// Of the instants.
    #[pyo3(get)]
    time_s: Py<PyArray1<f64>>,
    /// Instant, run, number: computed less true, of the runs that reached their end.
    #[pyo3(get)]
    drift: Py<PyArray3<f64>>,
    /// Root of the mean square over the runs.
    #[pyo3(get)]
    rms: Py<PyArray2<f64>>,
    /// Root of the mean variance that the filters say.
    #[pyo3(get)]
    sigma: Py<PyArray2<f64>>,
    /// Instant, group: the mean of eᵀP⁻¹e by its degrees of freedom.
    #[pyo3(get)]
    nees: Py<PyArray2<f64>>,
    /// Instant, group, two: where 95 % of such means lie.
    #[pyo3(get)]
    nees_expected: Py<PyArray3<f64>>,
    /// `time_s`, `rms`, `sigma`, `nees` and `nees_expected` of smoothed runs, at the instants that smoothers reach.
    #[pyo3(get)]
    smoothed: Option<Py<PyDict>>,
}

/// What comes of it, without the interpreter.
struct Found {
    scene: schuler_simulator::scene::Scene,
    kept: AidedRuns,
    findings: Findings,
    sentences: Vec<String>,
    command: Vec<String>,
    window: WindowShape,
    text: String,
}

#[pymethods]
impl AidedEnsemble {
    #[getter]
    fn scene(&self) -> Scene {
        Scene { scene: self.found.scene.clone() }
    }

    /// Runs that were flown.
    #[getter]
    fn runs(&self) -> u64 {
        self.found.kept.numbers.end
    }

    /// Names of the nine.
    #[getter]
    fn names(&self) -> Vec<&'static str> {
        Nine::NAMES.to_vec()
    }

    /// Names of the groups that NEES is told of.
    #[getter]
    fn groups(&self) -> Vec<&'static str> {
        GROUPS.to_vec()
    }

    /// Number, sample and reason of each run that did not reach its end.
    #[getter]
    fn failed(&self) -> Vec<(u64, u64, String)> {
        let failed = self.found.kept.failed.iter();
        failed.map(|failed| (failed.run, failed.sample, failed.why.to_string())).collect()
    }

    /// Tests of NEES: how many, and how many fail.
    #[getter]
    fn tests(&self) -> (usize, usize) {
        (self.found.findings.verdict.tests, self.found.findings.verdict.failed)
    }

    /// How errors part from what the filters say, in sentences.
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
        notebook::summary(py, &summary::text(&self.found.told(), &[]))
    }

    /// `ensemble.html`.
    fn report(&self, py: Python<'_>) -> String {
        py.detach(|| page::page(&self.found.told(), &self.found.findings))
    }

    fn __str__(&self) -> &str {
        &self.found.text
    }

    fn __repr__(&self) -> String {
        let (tests, fail) = self.tests();
        let (runs, name) = (self.runs(), &self.found.scene.name);
        format!("<schuler.AidedEnsemble of {runs} runs of {name}: {fail} of {tests} tests fail>")
    }

    fn _repr_html_(&self, py: Python<'_>) -> String {
        notebook::framed(&self.report(py))
    }
}

/// Flies many runs of an aided scene.
#[pyfunction]
#[pyo3(signature = (scene=None, runs=None, *, at=None, budget=None, threads=None, **options))]
pub fn aided_ensemble(
    py: Python<'_>,
    scene: Option<&Bound<'_, PyAny>>,
    runs: Option<&Bound<'_, PyAny>>,
    at: Option<&Bound<'_, PyAny>>,
    budget: Option<&Bound<'_, PyAny>>,
    threads: Option<&Bound<'_, PyAny>>,
    options: Option<&Bound<'_, PyDict>>,
) -> Answer<AidedEnsemble> {
    let asked = asked([scene, runs, at, budget, threads], options)?;
    if !asked.scene.aiding.is_there() {
        let complaint = Complaint::new(
            "is not aided",
            "a scene with [gnss] or the like; ensemble() flies others",
        );
        return Err(InputError::option("scene", complaint).into());
    }
    let mut watch = Watch::new();
    let found = py.detach(|| Found::new(asked, &mut watch));
    watch.raised()?;
    found?.ensemble(py)
}

impl Found {
    fn new(Asked { scene, args }: Asked, watch: &mut Watch) -> Result<Self, FlightError> {
        let source = Source::new(&scene, false)?;
        let ground = Ground::new(&scene, &source);
        let stops = stops(&ground, &args.at);
        let threads = threads(args.threads, Unit::Alone, args.runs);
        let means = Means { threads, stops: &stops, batch: None };
        let mut kept = AidedRuns::none(0);
        let scenes = Scenes::of(&scene, &source);
        fly_range(scenes, 0..args.runs, means, &|_| {}, &mut |batch| {
            // Batches of one flight follow one another.
            let _ = kept.join(batch);
            watch.ask().map_err(FlightError::from)
        })?;
        let shares = shares(&scene, &kept, args.budget, means, &|_| {})?;
        let findings = Findings::new(&kept, scene.rate_hz, shares);
        let sentences = findings.sentences();
        let text = text(&scene, &kept, &findings, &sentences);
        let command = command(&args, Extra::default(), args.budget);
        let window = ground.plan.window;
        Ok(Self { kept, findings, sentences, command, window, text, scene })
    }

    fn told(&self) -> Told<'_> {
        let Self { scene, kept, findings, sentences, command, window, .. } = self;
        Told {
            scene,
            command,
            window: *window,
            runs: [kept.numbers.end, kept.failed.len() as u64],
            saturated: findings.saturated,
            tests: [0; 3],
            together: [findings.verdict.tests, findings.verdict.failed],
            accuracy: findings.accuracy.last(),
            sentences,
            measurements: Some(&findings.report),
        }
    }

    fn ensemble(self, py: Python<'_>) -> Answer<AidedEnsemble> {
        let findings = &self.findings;
        let instants = &findings.instants;
        let count = instants.len();
        let drifts = findings.values.iter().flat_map(|values| values.numbers.as_flattened());
        let drift = PyArray1::from_vec(py, drifts.copied().collect());
        let drift = drift.reshape([count, self.kept.ended.len(), NINE])?.unbind();
        let [rms, sigma] = both(py, instants)?;
        let smoothed = match findings.smoothed.is_empty() {
            true => None,
            false => Some(smoothed(py, &findings.smoothed)?),
        };
        Ok(AidedEnsemble {
            time_s: times(py, instants),
            drift,
            rms,
            sigma,
            nees: nees(py, instants)?,
            nees_expected: expected(py, instants)?,
            smoothed,
            found: self,
        })
    }
}

fn times(py: Python<'_>, instants: &[Together]) -> Py<PyArray1<f64>> {
    PyArray1::from_vec(py, instants.iter().map(|at| at.time_s).collect()).unbind()
}

/// Rms and σ of each instant, in the units of files.
fn both(py: Python<'_>, instants: &[Together]) -> PyResult<[Py<PyArray2<f64>>; 2]> {
    let nine = |of: fn(&Together) -> &[f64; NINE]| -> PyResult<Py<PyArray2<f64>>> {
        let numbers = instants.iter().flat_map(|at| csv::of_files(of(at))).collect();
        Ok(PyArray1::from_vec(py, numbers).reshape([instants.len(), NINE])?.unbind())
    };
    Ok([nine(|at| &at.rms)?, nine(|at| &at.sigma)?])
}

fn nees(py: Python<'_>, instants: &[Together]) -> PyResult<Py<PyArray2<f64>>> {
    let numbers = instants.iter().flat_map(|at| at.nees).collect();
    Ok(PyArray1::from_vec(py, numbers).reshape([instants.len(), GROUPS.len()])?.unbind())
}

fn expected(py: Python<'_>, instants: &[Together]) -> PyResult<Py<PyArray3<f64>>> {
    let numbers = instants.iter().flat_map(|at| at.expected.as_flattened()).copied().collect();
    Ok(PyArray1::from_vec(py, numbers).reshape([instants.len(), GROUPS.len(), 2])?.unbind())
}

fn smoothed(py: Python<'_>, instants: &[Together]) -> PyResult<Py<PyDict>> {
    let dict = PyDict::new(py);
    let [rms, sigma] = both(py, instants)?;
    dict.set_item("time_s", times(py, instants))?;
    dict.set_item("rms", rms)?;
    dict.set_item("sigma", sigma)?;
    dict.set_item("nees", nees(py, instants)?)?;
    dict.set_item("nees_expected", expected(py, instants)?)?;
    Ok(dict.unbind())
}
