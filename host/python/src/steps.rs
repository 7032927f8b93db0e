//! `steps`: a navigator shown step by step, in bits, for the audit of a port.

use crate::arrays::{Samples, increment};
use crate::error::{Answer, refused};
use crate::navigator;
use crate::state::State;
use numpy::{PyArray1, PyArray2, PyArrayMethods as _};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use schuler::digest::Digest;
use schuler::math::compensated::Pair;
use schuler_simulator::navigator::stepping::{self, Words};

/// Steps of a navigator: what a chain of `schuler audit` has.
#[pyclass(frozen, module = "schuler")]
pub struct Steps {
    /// Its name.
    #[pyo3(get)]
    name: String,
    /// How many samples are behind each step.
    #[pyo3(get)]
    sample: Py<PyArray1<u64>>,
    body: Stage,
    nav: Stage,
}

/// A stage as it grows.
#[derive(Default)]
struct Growing {
    fields: Vec<&'static str>,
    words: Vec<u64>,
    digest: Digest,
}

/// A stage: a row of words for each step.
struct Stage {
    fields: Vec<&'static str>,
    words: Py<PyArray2<u64>>,
    digest: String,
}

impl Growing {
    fn add(&mut self, words: &Words) {
        if self.fields.is_empty() {
            self.fields = words.iter().map(|(field, _)| *field).collect();
        }
        self.words.extend(words.iter().map(|(_, word)| *word));
        self.digest.add_words(words.iter().map(|(_, word)| *word));
    }

    fn stage(self, py: Python<'_>, steps: usize) -> PyResult<Stage> {
        let Self { fields, words, digest } = self;
        let words = PyArray1::from_vec(py, words).reshape([steps, fields.len()])?.unbind();
        Ok(Stage { fields, words, digest: format!("{:016x}", digest.value()) })
    }
}

#[pymethods]
impl Steps {
    /// Names of the words of `body`, in order.
    #[getter]
    fn body_fields<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, &self.body.fields)
    }

    /// Names of the words of `nav`, in order.
    #[getter]
    fn nav_fields<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, &self.nav.fields)
    }

    /// The body's motion over each step, in bits.
    #[getter]
    fn body(&self, py: Python<'_>) -> Py<PyArray2<u64>> {
        self.body.words.clone_ref(py)
    }

    /// The state after each step, in bits.
    #[getter]
    fn nav(&self, py: Python<'_>) -> Py<PyArray2<u64>> {
        self.nav.words.clone_ref(py)
    }

    /// Of all of `body`, as a chain has it.
    #[getter]
    fn body_digest(&self) -> &str {
        &self.body.digest
    }

    /// Of all of `nav`, as a chain has it.
    #[getter]
    fn nav_digest(&self) -> &str {
        &self.nav.digest
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let steps = self.sample.bind(py).len()?;
        Ok(format!("<schuler.Steps of {}: {steps}, digest {}>", self.name, self.nav.digest))
    }
}

/// Flies samples from a state, and shows every step.
#[pyfunction]
#[pyo3(signature = (initial, rate, increments, *, name=None, **options))]
pub fn steps(
    py: Python<'_>,
    initial: &Bound<'_, PyAny>,
    rate: f64,
    increments: &Bound<'_, PyAny>,
    name: Option<&str>,
    options: Option<&Bound<'_, PyDict>>,
) -> Answer<Steps> {
    let initial = State::of(initial)?;
    let rate_hz = navigator::rate(rate)?;
    let configuration = navigator::configuration(name, options)?;
    let samples = Samples::new(increments)?;
    let view = samples.view();
    let interval_s = Pair::new(rate_hz).reciprocal();
    let (numbers, body, nav) = py.detach(|| -> Answer<_> {
        let mut steps = stepping::start(&configuration, interval_s, &initial.solution)?;
        let (mut numbers, mut body, mut nav) = (Vec::new(), Growing::default(), Growing::default());
        let mut see = |number: u64, body_words: &Words, nav_words: &Words| {
            numbers.push(number);
            body.add(body_words);
            nav.add(nav_words);
        };
        for (place, row) in view.rows().into_iter().enumerate() {
            steps.push(&increment(row), &mut see).map_err(|why| {
                let end_s = initial.time_s() + (place + 1) as f64 / rate_hz;
                refused(navigator::said(place as u64, end_s, why), None)
            })?;
        }
        steps.finish(&mut see);
        Ok((numbers, body, nav))
    })?;
    let count = numbers.len();
    Ok(Steps {
        name: configuration.to_string(),
        sample: PyArray1::from_vec(py, numbers).unbind(),
        body: body.stage(py, count)?,
        nav: nav.stage(py, count)?,
    })
}
