//! What becomes of the measurements of an aided flight, and what its filter finds.

use crate::notebook;
use crate::table::{Rows, Table};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use schuler_host::aided::lines;
use schuler_simulator::aided::columns::KINDS;
use schuler_simulator::aided::report::{Judgement, Report};
use schuler_simulator::output::NumberRows;

/// Columns of the verdicts.
const VERDICTS: [&str; 7] =
    ["time_s", "age_s", "degrees", "nis", "limit", "accepted", "locked_out"];

/// What is left of an aided flight, without the interpreter.
pub struct Left {
    /// What became of the measurements.
    pub report: Report,
    /// Each of them.
    pub judged: Vec<Judgement>,
    /// What was estimated beside the motion.
    pub estimates: NumberRows,
    /// The smoothed states, if there are any.
    pub smoothed: Option<NumberRows>,
    /// How far off it was after each span without fixes.
    pub withheld: Option<NumberRows>,
}

/// An aided flight beside its rows.
#[pyclass(frozen, module = "schuler")]
pub struct Aided {
    report: Report,
    /// Verdicts by what was measured.
    #[pyo3(get)]
    judged: Py<PyDict>,
    /// Biases and what else was estimated, each with its standard deviation.
    #[pyo3(get)]
    estimates: Py<Table>,
    /// The states in the light of all measurements.
    #[pyo3(get)]
    smoothed: Option<Py<Table>>,
    /// How far off it was at the last position of each span that was withheld.
    #[pyo3(get)]
    withheld: Option<Py<Table>>,
}

impl Aided {
    /// As Python has it.
    pub fn new(py: Python<'_>, left: Left) -> PyResult<Py<Self>> {
        let Left { report, judged, estimates, smoothed, withheld } = left;
        let table = |rows: NumberRows| Rows::from(rows).table(py);
        let by_kind = PyDict::new(py);
        for (word, kind, _) in KINDS {
            let mut rows = Rows::new(&VERDICTS, 0);
            for one in judged.iter().filter(|one| one.kind == kind) {
                let flags = [one.accepted, one.locked_out].map(|flag| f64::from(u8::from(flag)));
                rows.add(&[one.time_s, one.age_s, f64::from(kind.degrees()), one.nis, one.limit]);
                rows.add(&flags);
            }
            if rows.len() > 0 {
                by_kind.set_item(word, rows.table(py)?)?;
            }
        }
        let aided = Self {
            report,
            judged: by_kind.unbind(),
            estimates: table(estimates)?,
            smoothed: smoothed.map(table).transpose()?,
            withheld: withheld.map(table).transpose()?,
        };
        Py::new(py, aided)
    }
}

#[pymethods]
impl Aided {
    /// Counts by sensor with their NIS, what came too late, lockouts, and smoothed errors beside the filter's.
    #[getter]
    fn summary<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        // Numbers and names alone: this cannot fail.
        notebook::summary(py, &serde_json::to_string(&self.report).unwrap_or_default())
    }

    /// What the program prints of it.
    fn __str__(&self) -> String {
        lines(&self.report)
    }

    fn __repr__(&self) -> String {
        let taken: u64 = self.report.sensors.iter().map(|count| count.accepted).sum();
        let refused: u64 = self.report.sensors.iter().map(|count| count.refused).sum();
        format!("<schuler.Aided: {taken} measurements taken, {refused} refused>")
    }
}
