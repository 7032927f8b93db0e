//! `allan` and `datasheet`: what a sensor is made of, by measurement and by its data sheet.

use crate::error::{Answer, Fault};
use crate::log::Logs;
use crate::notebook;
use crate::options::{self, Options};
use crate::recorded::{Source, kept};
use crate::scene;
use crate::table::{Rows, Table};
use crate::toml;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyMapping};
use schuler_host::allan::{Axis, Findings};
use schuler_simulator::allan::record::{SceneError, of_recording, of_scene};
use schuler_simulator::allan::still::AXES;
use schuler_simulator::datasheet::sections;
use schuler_simulator::input::{InputError, read_text};
use schuler_simulator::recording::foreign::Given;
use schuler_simulator::rest::units::Units;
use schuler_simulator::scene::Scene;
use schuler_simulator::simulate::FlightError;
use std::path::PathBuf;

/// The columns of an axis, in SI.
const COLUMNS: [&str; 7] =
    ["tau_s", "differences", "deviation", "lower_95", "upper_95", "fitted", "configured"];

/// The Allan deviation of a sensor, and what it shows.
#[pyclass(frozen, module = "schuler")]
pub struct Allan {
    axes: Py<PyDict>,
    findings: Findings,
}

#[pymethods]
impl Allan {
    /// Axes that show something, each with a table: rad/s, m/s².
    #[getter]
    fn axes(&self, py: Python<'_>) -> Py<PyDict> {
        self.axes.clone_ref(py)
    }

    /// The sections of a scene that stand for the sensor.
    #[getter]
    fn sections<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        parsed(py, &self.findings.sections)
    }

    /// What the program prints.
    #[getter]
    fn text(&self) -> &str {
        &self.findings.text
    }

    /// `allan.html`.
    fn report(&self) -> String {
        self.findings.page()
    }

    fn __str__(&self) -> &str {
        &self.findings.text
    }

    fn __repr__(&self) -> String {
        format!("<schuler.Allan of {}>", self.findings.title)
    }

    fn _repr_html_(&self) -> String {
        notebook::framed(&self.report())
    }
}

/// A TOML text as a dict.
fn parsed<'py>(py: Python<'py>, text: &str) -> PyResult<Bound<'py, PyAny>> {
    py.import("tomllib")?.call_method1("loads", (text,))
}

/// Measures a scene's sensors, or a recording at rest; with both, compares them.
#[pyfunction]
#[pyo3(signature = (scene=None, *, imu=None, span=None, units=None, **options))]
pub fn allan(
    py: Python<'_>,
    scene: Option<&Bound<'_, PyAny>>,
    imu: Option<&Bound<'_, PyAny>>,
    span: Option<[f64; 2]>,
    units: Option<&str>,
    options: Option<&Bound<'_, PyDict>>,
) -> Answer<Allan> {
    let findings = match imu {
        None => {
            let scene = scene::of(scene, options)?;
            py.detach(|| by_scene(scene))?
        }
        Some(imu) => {
            // Options of the scene are none where a recording takes its place.
            let rate_hz = Options::among(&["rate"], options)?.flight.rate;
            let scene = scene.map(|scene| scene::of(Some(scene), None)).transpose()?;
            let folder = tempfile::tempdir().map_err(|error| kept(&error))?;
            let source = Source::new(imu, &folder)?;
            let units = units.map(Units::parse).transpose();
            let units = units.map_err(|complaint| Fault::option("--units", complaint))?;
            let span = span.map(|span_s| options::span("--span", span_s)).transpose()?;
            let given = Given { units: units.unwrap_or_default(), ..Given::default() };
            py.detach(|| -> Result<_, FlightError> {
                let recording = source.open(&given)?;
                let record = of_recording(&recording, rate_hz, span)?;
                Findings::new(recording.name, record, scene.as_ref(), true)
            })?
        }
    };
    let axes = PyDict::new(py);
    for (axis, name) in findings.axes.iter().zip(AXES) {
        if let Some(axis) = axis {
            axes.set_item(name, table(py, axis)?)?;
        }
    }
    Ok(Allan { axes: axes.unbind(), findings })
}

fn by_scene(scene: Scene) -> Result<Findings, FlightError> {
    let record = of_scene(&scene).map_err(|error| match error {
        SceneError::Source(error) => FlightError::from(error),
        SceneError::Complaint(complaint) => InputError::option(&scene.name, complaint).into(),
    })?;
    Findings::new(scene.name.clone(), record, Some(&scene), false)
}

fn table(py: Python<'_>, axis: &Axis) -> PyResult<Py<Table>> {
    let mut rows = Rows::new(&COLUMNS, axis.points.len() as u64);
    for (place, point) in axis.points.iter().enumerate() {
        rows.add(&[point.tau_s, point.differences as f64]);
        rows.add(&axis.beside(place, point));
    }
    rows.table(py)
}

/// The sections of a scene for a data sheet: a path, a TOML text or a dict.
#[pyfunction]
pub fn datasheet<'py>(py: Python<'py>, sheet: &Bound<'py, PyAny>) -> Answer<Bound<'py, PyAny>> {
    let text = if let Ok(table) = sheet.cast::<PyMapping>() {
        let file = "sheet";
        let text = toml::document(table, &mut Logs::default())?;
        sections(file, &text).map_err(|mut error| {
            (error.file, error.line) = (None, None);
            error
        })?
    } else {
        let path: PathBuf = sheet.extract()?;
        let name = path.display().to_string();
        if name.contains(['\n', '=']) {
            sections("sheet.toml", &name)?
        } else {
            sections(&name, &read_text(&name)?)?
        }
    };
    Ok(parsed(py, &text)?)
}
