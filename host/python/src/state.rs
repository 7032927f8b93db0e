//! A state of navigation in the units of `nav.csv`.

use crate::error::{Answer, Fault};
use pyo3::prelude::*;
use pyo3::types::PyMapping;
use schuler::solution::Solution;
use schuler_simulator::recording::navigation::{COLUMNS, NavigationRow, RANGES};
use std::path::PathBuf;

/// A time, a position, a velocity and an attitude.
#[pyclass(frozen, eq, module = "schuler")]
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    numbers: [f64; COLUMNS.len()],
    /// To all its digits.
    pub solution: Solution<f64>,
}

impl State {
    /// A solution at a time, s.
    pub fn new(time_s: f64, solution: &Solution<f64>) -> Self {
        let numbers = NavigationRow::new(time_s, solution).columns();
        Self { numbers, solution: *solution }
    }

    /// The same of a start, whose angles have all their digits.
    pub fn start(time_s: f64, solution: &Solution<f64>) -> Self {
        let numbers = NavigationRow::start(time_s, solution).columns();
        Self { numbers, solution: *solution }
    }

    /// Of a row.
    pub fn of_row(row: &NavigationRow) -> Self {
        Self { numbers: row.columns(), solution: row.solution() }
    }

    /// As a row of `nav.csv`.
    pub fn row(&self) -> NavigationRow {
        NavigationRow::of_columns(&self.numbers)
    }

    /// The time, s.
    pub fn time_s(&self) -> f64 {
        let [time_s, ..] = self.numbers;
        time_s
    }

    /// From a state, a dict, or the path of an `initial.toml`.
    pub fn of(source: &Bound<'_, PyAny>) -> Answer<Self> {
        if let Ok(state) = source.cast::<Self>() {
            return Ok(state.get().clone());
        }
        if let Ok(table) = source.cast::<PyMapping>() {
            let options = pyo3::types::PyDict::new(source.py());
            options.update(table)?;
            let state = source.py().get_type::<Self>().call((), Some(&options))?;
            return Ok(state.cast::<Self>().map_err(PyErr::from)?.get().clone());
        }
        let path: PathBuf = source.extract()?;
        Self::read(path)
    }
}

#[pymethods]
impl State {
    #[new]
    #[pyo3(signature = (*, latitude_deg, longitude_deg, altitude_m=0.0, north_m_s=0.0, east_m_s=0.0, down_m_s=0.0,
        roll_deg=0.0, pitch_deg=0.0, yaw_deg=0.0, time_s=0.0))]
    #[expect(clippy::too_many_arguments, reason = "the keys of initial.toml")]
    fn build(
        latitude_deg: f64,
        longitude_deg: f64,
        altitude_m: f64,
        north_m_s: f64,
        east_m_s: f64,
        down_m_s: f64,
        roll_deg: f64,
        pitch_deg: f64,
        yaw_deg: f64,
        time_s: f64,
    ) -> Answer<Self> {
        let numbers = [
            time_s,
            latitude_deg,
            longitude_deg,
            altitude_m,
            north_m_s,
            east_m_s,
            down_m_s,
            roll_deg,
            pitch_deg,
            yaw_deg,
        ];
        for ((name, range), number) in COLUMNS.iter().zip(&RANGES).zip(numbers) {
            range.check(number).map_err(|complaint| Fault::option(name, complaint))?;
        }
        let solution = NavigationRow::of_columns(&numbers).solution();
        Ok(Self { numbers, solution })
    }

    /// From an `initial.toml`.
    #[staticmethod]
    fn read(path: PathBuf) -> Answer<Self> {
        Ok(Self::of_row(&NavigationRow::read(&path.to_string_lossy())?))
    }

    /// The text of an `initial.toml`.
    pub fn toml(&self) -> String {
        let numbers = COLUMNS.iter().zip(self.numbers);
        numbers.map(|(name, number)| format!("{name} = {number:?}\n")).collect()
    }

    /// The numbers by their names.
    fn as_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, pyo3::types::PyDict>> {
        let table = pyo3::types::PyDict::new(py);
        for (name, number) in COLUMNS.iter().zip(self.numbers) {
            table.set_item(name, number)?;
        }
        Ok(table)
    }

    #[getter]
    fn get_time_s(&self) -> f64 {
        self.numbers[0]
    }

    #[getter]
    fn latitude_deg(&self) -> f64 {
        self.numbers[1]
    }

    #[getter]
    fn longitude_deg(&self) -> f64 {
        self.numbers[2]
    }

    #[getter]
    fn altitude_m(&self) -> f64 {
        self.numbers[3]
    }

    #[getter]
    fn north_m_s(&self) -> f64 {
        self.numbers[4]
    }

    #[getter]
    fn east_m_s(&self) -> f64 {
        self.numbers[5]
    }

    #[getter]
    fn down_m_s(&self) -> f64 {
        self.numbers[6]
    }

    #[getter]
    fn roll_deg(&self) -> f64 {
        self.numbers[7]
    }

    #[getter]
    fn pitch_deg(&self) -> f64 {
        self.numbers[8]
    }

    #[getter]
    fn yaw_deg(&self) -> f64 {
        self.numbers[9]
    }

    fn __repr__(&self) -> String {
        let numbers = COLUMNS.iter().zip(self.numbers);
        let numbers: Vec<_> = numbers.map(|(name, x)| format!("{name}={x:?}")).collect();
        format!("schuler.State({})", numbers.join(", "))
    }
}
