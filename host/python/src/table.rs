//! Numbers by rows and columns: one array, its columns by name.

use crate::error::Answer;
use numpy::{PyArray1, PyArray2, PyArrayMethods as _};
use pyo3::exceptions::PyKeyError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyIterator, PyTuple};
use schuler_report::page::panel;
use schuler_simulator::input::document::did_you_mean;
use schuler_simulator::number::parameter;
use schuler_simulator::output::NumberRows;

/// Rows being gathered, without the interpreter.
#[derive(Clone, Debug)]
pub struct Rows {
    names: Vec<String>,
    numbers: Vec<f64>,
}

impl Rows {
    /// With these columns and room for so many rows.
    pub fn new<S: AsRef<str>>(names: &[S], rows: u64) -> Self {
        let names: Vec<_> = names.iter().map(|name| name.as_ref().to_owned()).collect();
        let room = usize::try_from(rows).unwrap_or(0).saturating_mul(names.len());
        // Where there is no such room, the rows may yet be fewer.
        let mut numbers = Vec::new();
        let _ = numbers.try_reserve_exact(room);
        Self { names, numbers }
    }

    /// The next row, a number for each column; it may come in parts.
    pub fn add(&mut self, numbers: &[f64]) {
        self.numbers.extend_from_slice(numbers);
    }

    /// How many rows there are.
    pub fn len(&self) -> usize {
        self.numbers.len() / self.names.len().max(1)
    }

    /// As Python has it; the numbers are not copied.
    pub fn table(self, py: Python<'_>) -> PyResult<Py<Table>> {
        let rows = self.len();
        let Self { names, numbers } = self;
        let columns = names.len();
        let array = PyArray1::from_vec(py, numbers).reshape([rows, columns])?;
        Py::new(py, Table { names, array: array.unbind() })
    }
}

impl From<NumberRows> for Rows {
    fn from(NumberRows { names, numbers }: NumberRows) -> Self {
        Self { names, numbers }
    }
}

/// A table of numbers.
#[pyclass(frozen, mapping, module = "schuler")]
pub struct Table {
    names: Vec<String>,
    array: Py<PyArray2<f64>>,
}

impl Table {
    /// The names of its columns.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The numbers, if the columns are these.
    pub fn with_columns(&self, names: &[&str]) -> Option<&Py<PyArray2<f64>>> {
        self.names.iter().eq(names).then_some(&self.array)
    }
}

#[pymethods]
impl Table {
    #[getter]
    fn columns<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, &self.names)
    }

    #[getter]
    fn array(&self, py: Python<'_>) -> Py<PyArray2<f64>> {
        self.array.clone_ref(py)
    }

    fn keys<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        self.columns(py)
    }

    fn __getitem__<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
        let place = self.names.iter().position(|known| known == name).ok_or_else(|| {
            let known: Vec<_> = self.names.iter().map(String::as_str).collect();
            let hint = did_you_mean(name, &known);
            PyKeyError::new_err(format!("there is no column {name:?}{hint}; there are {known:?}"))
        })?;
        // A view of the column.
        self.array.bind(py).get_item((pyo3::types::PySlice::full(py), place))
    }

    fn __contains__(&self, name: &str) -> bool {
        self.names.iter().any(|known| known == name)
    }

    fn __iter__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyIterator>> {
        self.columns(py)?.try_iter()
    }

    fn __len__(&self, py: Python<'_>) -> PyResult<usize> {
        self.array.bind(py).len()
    }

    #[pyo3(signature = (dtype=None, copy=None))]
    fn __array__<'py>(
        &self,
        py: Python<'py>,
        dtype: Option<&Bound<'py, PyAny>>,
        copy: Option<bool>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let array = self.array.bind(py).as_any();
        match (dtype, copy) {
            (None, None | Some(false)) => Ok(array.clone()),
            (None, Some(true)) => array.call_method0("copy"),
            (Some(dtype), copy) => {
                let options = PyDict::new(py);
                options.set_item("copy", copy.unwrap_or(false))?;
                array.call_method("astype", (dtype,), Some(&options))
            }
        }
    }

    /// The same as a pandas `DataFrame`, which shares the numbers.
    fn frame<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let options = PyDict::new(py);
        options.set_item("columns", &self.names)?;
        options.set_item("copy", false)?;
        py.import("pandas")?.call_method("DataFrame", (self.array.bind(py),), Some(&options))
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        Ok(format!("<schuler.Table of {} rows: {}>", self.__len__(py)?, self.names.join(", ")))
    }

    fn _repr_html_(&self, py: Python<'_>) -> Answer<String> {
        let heads: Vec<_> = self.names.iter().map(String::as_str).collect();
        let array = self.array.bind(py).readonly();
        let array = array.as_array();
        let rows = array.nrows();
        let ends = |row: &usize| *row < SHOWN || row + SHOWN >= rows;
        let cells: Vec<Vec<_>> = (0..rows)
            .filter(ends)
            .map(|row| array.row(row).iter().map(|number| parameter(*number)).collect())
            .collect();
        let left = rows - cells.len();
        let note = if left > 0 { format!("<p>{rows} rows</p>") } else { String::new() };
        Ok(panel(&heads, &cells) + &note)
    }
}

/// Rows at each end that a notebook shows.
const SHOWN: usize = 5;
