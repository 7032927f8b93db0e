//! A recorded stream: a file of the user, or an array in a file of ours, because a recording is gone through twice.

use crate::error::{Answer, Fault};
use crate::table::Table;
use numpy::{AllowTypeChange, PyArrayLike2};
use pyo3::prelude::*;
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::output::NumberTable;
use schuler_simulator::recording::csv::{INCREMENTS, RATES};
use schuler_simulator::recording::foreign::Given;
use schuler_simulator::recording::rows::Recording;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// Where samples come from.
pub enum Source {
    /// The user's file or folder.
    File(PathBuf),
    /// An array, in a file of ours.
    Array(PathBuf),
}

impl Source {
    /// The file or folder.
    pub fn path(&self) -> &Path {
        match self {
            Self::File(path) | Self::Array(path) => path,
        }
    }

    /// A path, a table or an array, which is put into a folder.
    pub fn new(imu: &Bound<'_, PyAny>, folder: &TempDir) -> Answer<Self> {
        let table = imu.cast::<Table>();
        if table.is_err()
            && let Ok(path) = imu.extract::<PathBuf>()
        {
            return Ok(Self::File(path));
        }
        let accepted =
            "a path, the imu of an Emulation, or an array of seven columns: time_s and increments";
        let refuse = |what: String| Fault::argument("imu", what, accepted);
        let mut names = &INCREMENTS;
        let array: PyArrayLike2<'_, f64, AllowTypeChange> = match table {
            Ok(table) => {
                let table = table.get();
                let known = [&INCREMENTS, &RATES]
                    .into_iter()
                    .find_map(|names| table.with_columns(names).map(|array| (names, array)));
                let (found, array) =
                    known.ok_or_else(|| refuse("is a table of something else".to_owned()))?;
                names = found;
                array.bind(imu.py()).extract()?
            }
            Err(_) => imu.extract().map_err(|_| refuse("is neither".to_owned()))?,
        };
        let array = array.as_array();
        if array.ncols() != names.len() {
            return Err(refuse(format!("has {} columns", array.ncols())));
        }
        let path = folder.path().join("imu.csv");
        let mut file = NumberTable::create(&path, names)?;
        let mut numbers = Vec::with_capacity(names.len());
        for row in array.rows() {
            numbers.clear();
            numbers.extend(row.iter());
            file.row(&numbers)?;
        }
        file.finish()?;
        Ok(Self::Array(path))
    }

    /// The recording, with all that is said of it.
    pub fn open(&self, given: &Given) -> Result<Recording, InputError> {
        let mut recording = Recording::open_as(&self.path().display().to_string(), given)?;
        if matches!(self, Self::Array(_)) {
            recording.name = "imu".to_owned();
        }
        Ok(recording)
    }
}

/// There is no room for a file of ours.
pub fn kept(error: &std::io::Error) -> InputError {
    InputError::option("imu", Complaint::new(format!("cannot be kept: {error}"), ""))
}
