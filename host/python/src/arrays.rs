//! Samples in numpy arrays, which are read where they lie.

use crate::error::{Answer, Fault};
use crate::table::Table;
use numpy::ndarray::{ArrayView1, ArrayView2, s};
use numpy::{AllowTypeChange, PyArrayLike1, PyArrayLike2, PyArrayMethods as _, PyReadonlyArray2};
use pyo3::prelude::*;
use schuler::math::vector::Vector;
use schuler::sample::Increment;
use schuler_simulator::recording::csv::{INCREMENTS, RATES};

/// Six numbers per sample: Δθ and Δv of the axes forward, right, down.
pub enum Samples<'py> {
    /// An array with these columns alone.
    Six(PyArrayLike2<'py, f64, AllowTypeChange>),
    /// A table with the time before them.
    Table(PyReadonlyArray2<'py, f64>),
}

impl<'py> Samples<'py> {
    /// From a table of `emulate`, or an array of six columns.
    pub fn new(given: &Bound<'py, PyAny>) -> Answer<Self> {
        let accepted = "increments: an array of six columns (dtheta_x_rad, dtheta_y_rad, dtheta_z_rad, dvel_x_m_s, \
            dvel_y_m_s, dvel_z_m_s), or the imu of an Emulation";
        let refuse = |what: &str| Fault::argument("increments", what, accepted);
        if let Ok(table) = given.cast::<Table>() {
            return match table.get().with_columns(&INCREMENTS) {
                Some(array) => Ok(Self::Table(array.bind(given.py()).readonly())),
                None if table.get().with_columns(&RATES).is_some() => {
                    Err(refuse("are rates; emulate(…, rates=False) has increments"))
                }
                None => Err(refuse("is a table of something else")),
            };
        }
        let array: PyArrayLike2<'py, f64, AllowTypeChange> =
            given.extract().map_err(|_| refuse("is no array of numbers in rows"))?;
        match array.as_array().ncols() {
            6 => Ok(Self::Six(array)),
            columns => Err(refuse(&format!("has {columns} columns"))),
        }
    }

    /// The numbers where they lie, six in a row.
    pub fn view(&self) -> ArrayView2<'_, f64> {
        match self {
            Self::Six(array) => array.as_array(),
            Self::Table(array) => array.as_array().slice_move(s![.., 1..]),
        }
    }
}

/// The increment of a row of six.
pub fn increment(six: ArrayView1<'_, f64>) -> Increment<f64> {
    let at = |column: usize| six.get(column).copied().unwrap_or_default();
    Increment {
        angle_b: Vector::new(at(0), at(1), at(2)),
        velocity_b: Vector::new(at(3), at(4), at(5)),
    }
}

/// Numbers in a row.
pub fn numbers<'py>(
    name: &str,
    given: &Bound<'py, PyAny>,
) -> Answer<PyArrayLike1<'py, f64, AllowTypeChange>> {
    let array = given.extract();
    array.map_err(|_| Fault::argument(name, "is no list of numbers", "an array of one dimension"))
}
