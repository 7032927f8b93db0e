//! `align`: level, north and biases from samples at rest.

use crate::arrays::{Samples, increment};
use crate::error::{Answer, Fault};
use crate::options;
use crate::state::State;
use pyo3::exceptions::PyUserWarning;
use pyo3::prelude::*;
use schuler::alignment::judge::judge;
use schuler::alignment::place::Place;
use schuler::alignment::units::Kind;
use schuler::math::compensated::Pair;
use schuler::math::vector::Vector;
use schuler::units::MICRO_G;
use schuler_simulator::input::{InputError, Range};
use schuler_simulator::output::heard::{Heard, overheard};
use schuler_simulator::rest::align as rest;
use schuler_simulator::rest::align::Heading;
use schuler_simulator::rest::fine::{Refined, Stretch};
use schuler_simulator::scene::limits;
use schuler_simulator::units::{DEGREE, DEGREE_PER_HOUR};
use std::ffi::CString;

/// A heading that is known, degrees.
const HEADING: Range = Range::from_to(-360.0, 360.0, "degrees, from -360 to 360");

/// The attitude that was found.
#[pyclass(frozen, get_all, module = "schuler")]
pub struct Aligned {
    /// At rest, where it was said to be.
    state: Py<State>,
    /// Standard deviation of level, °.
    level_sigma_deg: f64,
    /// Standard deviation of the heading, °; `None` where it was given.
    heading_sigma_deg: Option<f64>,
    /// Biases of the gyros, °/h; `None` of the means alone.
    gyro_bias_deg_h: Option<[f64; 3]>,
    /// Their standard deviations, °/h.
    gyro_bias_sigma_deg_h: Option<[f64; 3]>,
    /// Biases of the accelerometers, µg; `None` of the means alone.
    accelerometer_bias_ug: Option<[f64; 3]>,
    /// Their standard deviations, µg.
    accelerometer_bias_sigma_ug: Option<[f64; 3]>,
    /// What the program prints.
    text: String,
}

#[pymethods]
impl Aligned {
    fn __repr__(&self) -> String {
        format!("<schuler.Aligned: {}>", self.text.lines().next().unwrap_or_default())
    }
}

/// Finds level, north and biases at rest.
#[pyfunction]
#[pyo3(signature = (increments, rate, initial, *, heading=None, coarse=false))]
pub fn align(
    py: Python<'_>,
    increments: &Bound<'_, PyAny>,
    rate: &Bound<'_, PyAny>,
    initial: &Bound<'_, PyAny>,
    heading: Option<&Bound<'_, PyAny>>,
    coarse: bool,
) -> Answer<Aligned> {
    let samples = Samples::new(increments)?;
    let view = samples.view();
    let rate_hz = options::number("rate", rate, &limits::RATE_HZ)?;
    let heading = heading.map(|given| options::number("heading", given, &HEADING)).transpose()?;
    let initial = State::of(initial)?.row();
    let (found, heard) = py.detach(|| {
        let count = view.nrows();
        let (interval_s, interval) = (1.0 / rate_hz, Pair::new(rate_hz).reciprocal());
        let mut still = rest::gather(count as f64 * interval_s);
        let mut stretch = Stretch::new(interval);
        for row in view.rows() {
            let sample = increment(row);
            still.add(&sample, interval_s);
            stretch.add(&sample);
        }
        let stated = |heading| Heading::Known(heading * DEGREE);
        let heading = heading.map_or(Heading::FoundOrStated, stated);
        let (kind, name) = (Kind::Increments, "increments");
        let fine = (!coarse).then_some(&stretch);
        overheard(|| {
            let found = rest::align(&still, kind, name, &initial, heading, count, 0, fine)?;
            Ok::<_, InputError>((found, still.readings()))
        })
    });
    let text = warned(py, heard)?;
    let ((row, refined), readings) = found?;
    let readings =
        readings.ok_or_else(|| Fault::argument("increments", "are none", "samples at rest"))?;
    let quality = judge(&readings, Kind::Increments, &Place::new(initial.position)).quality;
    let [level_sigma, heading_sigma] = match &refined {
        Some(Refined { aligned, .. }) => {
            let [north, east] = aligned.level_sigma;
            [north.max(east), aligned.heading_sigma]
        }
        None => [quality.level_sigma, quality.heading_sigma],
    };
    let biases = |of: fn(&Refined) -> Vector<f64>, unit: f64| {
        refined.as_ref().map(|refined| of(refined).map(|x| x / unit).into_array())
    };
    Ok(Aligned {
        state: Py::new(py, State::of_row(&row))?,
        level_sigma_deg: level_sigma / DEGREE,
        heading_sigma_deg: heading.is_none().then_some(heading_sigma / DEGREE),
        gyro_bias_deg_h: biases(|found| found.aligned.gyro_bias[0], DEGREE_PER_HOUR),
        gyro_bias_sigma_deg_h: biases(|found| found.aligned.gyro_bias[1], DEGREE_PER_HOUR),
        accelerometer_bias_ug: biases(|found| found.aligned.accelerometer_bias[0], MICRO_G),
        accelerometer_bias_sigma_ug: biases(|found| found.aligned.accelerometer_bias[1], MICRO_G),
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
