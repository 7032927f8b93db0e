//! `run`: a flight from start to end, beside truth and theory.

use crate::error::{Answer, Fault};
use crate::interrupt::Watch;
use crate::notebook;
use crate::options;
use crate::scene::{self, Scene};
use crate::table::{Rows, Table};
use pyo3::exceptions::PyOSError;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};
use schuler_host::cli::Every;
use schuler_host::report::files::end_covariance;
use schuler_host::report::html::{self, Shown};
use schuler_host::report::sensors::Sensors;
use schuler_host::report::thinned::Thinned;
use schuler_host::report::traces::Traces;
use schuler_host::report::{plot, summary};
use schuler_simulator::flight::{self, Instant, Nine};
use schuler_simulator::recording::navigation::{COLUMNS, NavigationRow};
use schuler_simulator::scene::Scene as Flown;
use schuler_simulator::simulate::{FlightError, Simulation};

/// A flight: what it leaves, its rows as tables.
#[pyclass(frozen, module = "schuler")]
pub struct Flight {
    flight: flight::Flight,
    tables: Option<Tables>,
    /// What the page shows of every row.
    traces: Traces,
    /// The number of the run, whose sensors the page shows.
    run: u64,
}

/// Drift beside theory, computed and true motion.
struct Tables {
    drift: Py<Table>,
    nav: Py<Table>,
    truth: Py<Table>,
}

/// The same while they grow.
struct Growing {
    drift: Rows,
    nav: Rows,
    truth: Rows,
    kept: Thinned,
}

impl Growing {
    fn new(scene: &Flown, every: Option<Every>) -> Self {
        let rows = 1 + scene.samples();
        let rows = every.map_or(rows, |every| 1 + every.kept(rows, 1.0 / scene.rate_hz));
        let of = |suffix: &'static str| Nine::NAMES.map(|name| format!("{name}{suffix}"));
        let names: Vec<_> = ["time_s".to_owned()]
            .into_iter()
            .chain(of(""))
            .chain(of("_mean"))
            .chain(of("_sigma"))
            .collect();
        Self {
            drift: Rows::new(&names, rows),
            nav: Rows::new(&COLUMNS, rows),
            truth: Rows::new(&COLUMNS, rows),
            kept: Thinned::new(every, 0.0),
        }
    }

    fn row(&mut self, instant: &Instant) {
        if self.kept.keeps(instant) {
            self.add(instant);
        }
    }

    fn add(&mut self, instant: &Instant) {
        let Instant { time_s, drift, mean, sigma, computed, truth, .. } = instant;
        self.drift.add(&[*time_s]);
        for nine in [drift, mean, sigma] {
            self.drift.add(&nine.numbers());
        }
        self.nav.add(&NavigationRow::new(*time_s, computed).columns());
        self.truth.add(&NavigationRow::new(*time_s, truth).columns());
    }

    fn tables(mut self, py: Python<'_>) -> PyResult<Tables> {
        if let Some(last) = self.kept.last() {
            self.add(&last);
        }
        let Self { drift, nav, truth, .. } = self;
        Ok(Tables { drift: drift.table(py)?, nav: nav.table(py)?, truth: truth.table(py)? })
    }
}

/// What was flown, and what ended it early.
type End = (flight::Flight, Result<(), FlightError>);

/// Flies a scene as far as it goes.
fn fly(
    scene: &Flown,
    force_all: bool,
    run: u64,
    (rows, traces): (&mut Option<Growing>, &mut Traces),
    watch: &mut Watch,
) -> Result<End, FlightError> {
    let mut observe = |instant: &Instant| {
        traces.row(instant);
        if let Some(rows) = rows {
            rows.row(instant);
        }
        watch.look()
    };
    Simulation::of_run(scene, force_all, run)?.fly_as_far(&mut observe, &|_| {})
}

/// Flies a scene, and compares its navigation with truth and theory.
#[pyfunction]
#[pyo3(signature = (scene=None, *, rows=true, every=None, force_all=false, run=0, **options))]
pub fn run(
    py: Python<'_>,
    scene: Option<&Bound<'_, PyAny>>,
    rows: bool,
    every: Option<&Bound<'_, PyAny>>,
    force_all: bool,
    run: u64,
    options: Option<&Bound<'_, PyDict>>,
) -> Answer<Flight> {
    let scene = scene::of(scene, options)?;
    let every = options::every(every)?;
    let (end, rows, traces, watch) = py.detach(|| {
        let mut rows = rows.then(|| Growing::new(&scene, every));
        let (mut traces, mut watch) = (Traces::default(), Watch::new());
        let end = fly(&scene, force_all, run, (&mut rows, &mut traces), &mut watch);
        (end, rows, traces, watch)
    });
    watch.raised()?;
    let (flight, end) = end?;
    let tables = rows.map(|rows| rows.tables(py)).transpose()?;
    let flown = Flight { flight, tables, traces, run };
    match end {
        Ok(()) => Ok(flown),
        Err(error) => {
            let flown = Py::new(py, flown)?.into_any();
            Err(Fault::Python(Fault::Flight(error).raised(Some(flown))))
        }
    }
}

impl Flight {
    fn tables(&self) -> Answer<&Tables> {
        let accepted = "run(…, rows=True)";
        self.tables.as_ref().ok_or_else(|| Fault::argument("rows", "were not kept", accepted))
    }
}

#[pymethods]
impl Flight {
    #[getter]
    fn scene(&self) -> Scene {
        Scene { scene: self.flight.scene.clone() }
    }

    #[getter]
    fn digest(&self) -> &str {
        &self.flight.digest
    }

    #[getter]
    fn samples(&self) -> u64 {
        self.flight.samples
    }

    #[getter]
    fn window(&self) -> Option<(usize, usize, usize)> {
        self.flight.window.map(|window| (window.history, window.block, window.lookahead))
    }

    #[getter]
    fn ended(&self) -> Option<&str> {
        self.flight.ended.as_ref().map(|ended| ended.reason.as_str())
    }

    #[getter]
    fn drift(&self, py: Python<'_>) -> Answer<Py<Table>> {
        Ok(self.tables()?.drift.clone_ref(py))
    }

    #[getter]
    fn nav(&self, py: Python<'_>) -> Answer<Py<Table>> {
        Ok(self.tables()?.nav.clone_ref(py))
    }

    #[getter]
    fn truth(&self, py: Python<'_>) -> Answer<Py<Table>> {
        Ok(self.tables()?.truth.clone_ref(py))
    }

    /// `summary.json` as a dict, without the command line and the files that there are none of.
    #[getter]
    fn summary<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        notebook::summary(py, &summary::json(&self.flight, &[], None))
    }

    /// `report.html`.
    fn report(&self, py: Python<'_>) -> String {
        py.detach(|| {
            let sensors = Sensors::of(&self.flight, self.run).ok();
            let covariance_m2 = end_covariance(&self.flight);
            let traces = self.traces.clone();
            html::page(&self.flight, &Shown { traces, sensors, covariance_m2, lockstep: None })
        })
    }

    /// `drift.png`.
    fn picture<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        let png = py.detach(|| plot::png(&self.flight));
        let png = png.map_err(|error| PyOSError::new_err(error.to_string()))?;
        Ok(PyBytes::new(py, &png))
    }

    /// What the program prints.
    fn __str__(&self) -> String {
        schuler_host::run::text(&self.flight)
    }

    fn __repr__(&self) -> String {
        let flight::Flight { scene, last, digest, .. } = &self.flight;
        let (name, seconds) = (&scene.name, last.time_s);
        format!("<schuler.Flight of {name}, {seconds} s, digest {digest}>")
    }

    fn _repr_html_(&self, py: Python<'_>) -> String {
        notebook::framed(&self.report(py))
    }
}
