//! Exceptions, with the texts of the program.

use pyo3::prelude::*;
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::navigator::Unavailable;
use schuler_simulator::simulate::FlightError;
use schuler_simulator::source::SourceError;

mod classes {
    pyo3::import_exception!(schuler.errors, InputError);
    pyo3::import_exception!(schuler.errors, FlightError);
}

/// Why a function fails.
pub enum Fault {
    /// What was given is not to be had.
    Input(InputError),
    /// A flight ends early.
    Flight(FlightError),
    /// Python's own.
    Python(PyErr),
}

/// A `Fault`, or what a function gives.
pub type Answer<T> = Result<T, Fault>;

impl Fault {
    /// About an option, by its name on the command line.
    pub fn option(option: &str, complaint: Complaint) -> Self {
        Self::Input(InputError::option(option, complaint))
    }

    /// About an argument of Python alone.
    pub fn argument(name: &str, what: impl Into<String>, accepted: impl Into<String>) -> Self {
        Self::option(name, Complaint::new(what, accepted))
    }

    /// As an exception, with what was flown until then.
    pub fn raised(self, flown: Option<Py<PyAny>>) -> PyErr {
        match self {
            Self::Input(error) | Self::Flight(FlightError::Input(error)) => input(error),
            Self::Flight(error) => classes::FlightError::new_err((error.to_string(), flown)),
            Self::Python(error) => error,
        }
    }
}

/// An error that names its place.
fn input(error: InputError) -> PyErr {
    let text = error.to_string();
    let InputError { file, line, key, complaint: Complaint { what, accepted } } = error;
    classes::InputError::new_err((text, file, line, key, what, accepted))
}

/// The navigator that refused a sample, or another step of it.
pub fn refused(text: String, flown: Option<Py<PyAny>>) -> PyErr {
    classes::FlightError::new_err((text, flown))
}

impl From<Fault> for PyErr {
    fn from(fault: Fault) -> Self {
        fault.raised(None)
    }
}

impl From<PyErr> for Fault {
    fn from(error: PyErr) -> Self {
        Self::Python(error)
    }
}

impl From<InputError> for Fault {
    fn from(error: InputError) -> Self {
        Self::Input(error)
    }
}

impl From<FlightError> for Fault {
    fn from(error: FlightError) -> Self {
        Self::Flight(error)
    }
}

impl From<SourceError> for Fault {
    fn from(error: SourceError) -> Self {
        Self::Flight(error.into())
    }
}

impl From<Unavailable> for Fault {
    fn from(error: Unavailable) -> Self {
        Self::Flight(error.into())
    }
}
