//! `align`: level and north from samples at rest.

use crate::arrays::{Samples, increment};
use crate::error::{Answer, Fault};
use crate::options;
use crate::state::State;
use pyo3::exceptions::PyUserWarning;
use pyo3::prelude::*;
use schuler::alignment::judge::judge;
use schuler::alignment::place::Place;
use schuler::alignment::units::Kind;
use schuler_simulator::input::Range;
use schuler_simulator::output::heard::{Heard, overheard};
use schuler_simulator::rest::align as rest;
use schuler_simulator::scene::limits;
use schuler_simulator::units::DEGREE;
use std::ffi::CString;

/// A heading that is known, degrees.
const HEADING: Range = Range::from_to(-360.0, 360.0, "degrees, from -360 to 360");

/// The attitude that was found.
#[pyclass(frozen, get_all, module = "schuler")]
pub struct Aligned {
    /// At rest, where it was said to be.
    state: Py<State>,
    /// Standard deviation of roll and pitch, °.
    level_sigma_deg: f64,
    /// Standard deviation of the heading, °; `None` where it was given.
    heading_sigma_deg: Option<f64>,
    /// What the program prints.
    text: String,
}

#[pymethods]
impl Aligned {
    fn __repr__(&self) -> String {
        format!("<schuler.Aligned: {}>", self.text.lines().next().unwrap_or_default())
    }
}

/// Finds level and north at rest.
#[pyfunction]
#[pyo3(signature = (increments, rate, initial, *, heading=None))]
pub fn align(
    py: Python<'_>,
    increments: &Bound<'_, PyAny>,
    rate: &Bound<'_, PyAny>,
    initial: &Bound<'_, PyAny>,
    heading: Option<&Bound<'_, PyAny>>,
) -> Answer<Aligned> {
    let samples = Samples::new(increments)?;
    let view = samples.view();
    let interval_s = 1.0 / options::number("rate", rate, &limits::RATE_HZ)?;
    let heading = heading.map(|given| options::number("heading", given, &HEADING)).transpose()?;
    let initial = State::of(initial)?.row();
    let ((aligned, still), heard) = py.detach(|| {
        let count = view.nrows();
        let mut still = rest::gather(count as f64 * interval_s);
        view.rows().into_iter().for_each(|row| still.add(&increment(row), interval_s));
        let heading = heading.map(|heading| heading * DEGREE);
        let (kind, name) = (Kind::Increments, "increments");
        overheard(|| (rest::align(&still, kind, name, &initial, heading, count, 0), still))
    });
    let text = warned(py, heard)?;
    let aligned = aligned?;
    let readings = still
        .readings()
        .ok_or_else(|| Fault::argument("increments", "are none", "samples at rest"))?;
    let quality = judge(&readings, Kind::Increments, &Place::new(initial.position)).quality;
    let heading_sigma = heading.is_none().then_some(quality.heading_sigma / DEGREE);
    Ok(Aligned {
        state: Py::new(py, State::of_row(&aligned))?,
        level_sigma_deg: quality.level_sigma / DEGREE,
        heading_sigma_deg: heading_sigma,
        text,
    })
}

/// Warnings as Python has them, and the text beside them.
pub fn warned(py: Python<'_>, heard: Heard) -> Answer<String> {
    let Heard { text, warnings } = heard;
    let category = py.get_type::<PyUserWarning>();
    for warning in warnings {
        // What is said to people has no zero byte.
        let warning = CString::new(warning).unwrap_or_default();
        PyErr::warn(py, category.as_any(), &warning, 1)?;
    }
    Ok(text)
}
