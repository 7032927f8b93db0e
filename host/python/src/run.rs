//! `run`: a flight from start to end, beside truth and theory.

use crate::aided::{Aided, Left};
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
use schuler_simulator::aided::rows;
use schuler_simulator::flight::{self, Instant, Nine};
use schuler_simulator::output::NumberRows;
use schuler_simulator::recording::navigation::{COLUMNS, NavigationRow};
use schuler_simulator::scene::Scene as Flown;
use schuler_simulator::simulate::{Claims, FlightError, Simulation};
use std::sync::OnceLock;

/// A flight: what it leaves, its rows as tables.
#[pyclass(frozen, module = "schuler")]
pub struct Flight {
    flight: flight::Flight,
    tables: Option<Tables>,
    /// What the page shows of every row.
    traces: Traces,
    /// The number of the run, whose sensors the page shows.
    run: u64,
    /// What became of the measurements.
    aided: Option<Py<Aided>>,
    /// The page, once it was asked for.
    page: OnceLock<String>,
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
    estimates: NumberRows,
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
            estimates: NumberRows::default(),
            kept: Thinned::new(every, 0.0),
        }
    }

    fn row(&mut self, instant: &Instant, claims: Option<&Claims>) {
        if self.kept.keeps(instant) {
            self.add(instant, claims);
        }
    }

    fn add(&mut self, instant: &Instant, claims: Option<&Claims>) {
        let Instant { time_s, drift, mean, sigma, computed, truth, .. } = instant;
        self.drift.add(&[*time_s]);
        for nine in [drift, mean, sigma] {
            self.drift.add(&nine.numbers());
        }
        self.nav.add(&NavigationRow::new(*time_s, computed).columns());
        self.truth.add(&NavigationRow::new(*time_s, truth).columns());
        if let Some(claims) = claims {
            estimated(&mut self.estimates, *time_s, claims);
        }
    }

    /// The last row, if it is none yet: nothing comes after it.
    fn end(&mut self, claims: Option<&Claims>) {
        if let Some(last) = self.kept.last() {
            self.add(&last, claims);
        }
    }

    fn tables(self, py: Python<'_>) -> PyResult<Tables> {
        let Self { drift, nav, truth, .. } = self;
        Ok(Tables { drift: drift.table(py)?, nav: nav.table(py)?, truth: truth.table(py)? })
    }
}

/// What a filter estimates beside the motion, at a time, s.
fn estimated(rows: &mut NumberRows, time_s: f64, claims: &Claims) {
    if rows.names.is_empty() {
        rows.names.push("time_s".to_owned());
        rows.names.extend(claims.estimated.borrow().iter().cloned());
    }
    rows.add(&[time_s]);
    rows.add(&claims.estimates.borrow());
}

/// What was flown, what is left if it was aided, and what ended it early.
type End = (flight::Flight, Option<Left>, Result<(), FlightError>);

/// Flies a scene as far as it goes.
fn fly(
    scene: &Flown,
    force_all: bool,
    run: u64,
    (rows, traces): (&mut Option<Growing>, &mut Traces),
    watch: &mut Watch,
) -> Result<End, FlightError> {
    let simulation = Simulation::of_run(scene, force_all, run)?;
    let claims = simulation.claims();
    let mut observe = |instant: &Instant| {
        traces.row(instant);
        if let Some(rows) = rows {
            rows.row(instant, claims.as_ref());
        }
        watch.look()
    };
    let (flight, end) = simulation.fly_as_far(&mut observe, &|_| {})?;
    if let Some(rows) = rows {
        rows.end(claims.as_ref());
    }
    let left = claims.zip(flight.aided.clone()).map(|(claims, report)| {
        let mut estimates = match rows {
            Some(rows) => std::mem::take(&mut rows.estimates),
            None => NumberRows::default(),
        };
        if estimates.is_empty() {
            estimated(&mut estimates, flight.last.time_s, &claims);
        }
        let states = claims.smoothed.take();
        let smoothed = scene
            .aiding
            .filter
            .smoother
            .then(|| rows::smoothed(&states, |samples| samples as f64 / scene.rate_hz));
        Left { report, judged: claims.judged.take(), estimates, smoothed, withheld: None }
    });
    Ok((flight, left, end))
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
    let (flight, left, end) = end?;
    let aided = left.map(|left| Aided::new(py, left)).transpose()?;
    let tables = rows.map(|rows| rows.tables(py)).transpose()?;
    let flown = Flight { flight, tables, traces, run, aided, page: OnceLock::new() };
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

    /// What became of the measurements that aided it, if any.
    #[getter]
    fn aided(&self, py: Python<'_>) -> Option<Py<Aided>> {
        self.aided.as_ref().map(|aided| aided.clone_ref(py))
    }

    /// `summary.json` as a dict, without the command line and the files that there are none of.
    #[getter]
    fn summary<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        notebook::summary(py, &summary::json(&self.flight, &[], None))
    }

    /// `report.html`. The sensors' samples are drawn once more for it, the first time.
    fn report(&self, py: Python<'_>) -> &str {
        let page = || {
            let sensors = Sensors::of(&self.flight, self.run).ok();
            let covariance_m2 = end_covariance(&self.flight);
            let traces = self.traces.clone();
            html::page(&self.flight, &Shown { traces, sensors, covariance_m2, lockstep: None })
        };
        py.detach(|| self.page.get_or_init(page))
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
        notebook::framed(self.report(py))
    }
}
