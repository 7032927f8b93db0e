//! A log in arrays: `trajectory.log` with columns in place of a file.

use crate::error::{Answer, Fault};
use pyo3::prelude::*;
use pyo3::types::PyMapping;
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::output::NumberTable;
use schuler_simulator::scene::Scene;
use schuler_simulator::scene::route::Origin;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use tempfile::TempDir;

/// The columns of a log; the last three may be absent.
const COLUMNS: [&str; 7] =
    ["time_s", "latitude_deg", "longitude_deg", "altitude_m", "roll_deg", "pitch_deg", "yaw_deg"];
/// What stands for the arrays where a file would be named.
const NAME: &str = "trajectory.log";

/// Where arrays lie while a scene is read.
#[derive(Default)]
pub struct Logs {
    folder: Option<TempDir>,
    file: PathBuf,
}

impl Logs {
    /// Whether a key names a column.
    pub fn is_column(key: &str) -> bool {
        COLUMNS.contains(&key)
    }

    /// The file of a log's arrays; none where it has no arrays.
    pub fn write(&mut self, log: &Bound<'_, PyMapping>) -> Answer<Option<String>> {
        let mut names = Vec::new();
        let mut columns: Vec<Vec<f64>> = Vec::new();
        for name in COLUMNS {
            if !log.contains(name)? {
                continue;
            }
            let key = format!("{NAME}.{name}");
            let values: Vec<f64> = log.get_item(name)?.extract().map_err(|_| {
                Fault::argument(&key, "is no list of numbers", "an array of one dimension")
            })?;
            if let Some(first) = columns.first()
                && first.len() != values.len()
            {
                let what = format!("has {} values", values.len());
                return Err(Fault::argument(&key, what, format!("{} of them", first.len())));
            }
            names.push(name);
            columns.push(values);
        }
        if columns.is_empty() {
            return Ok(None);
        }
        let folder = tempfile::tempdir().map_err(|error| {
            InputError::option(NAME, Complaint::new(format!("cannot be kept: {error}"), ""))
        })?;
        self.file = folder.path().join("log.csv");
        let mut table = NumberTable::create(&self.file, &names)?;
        let rows = columns.first().map_or(0, Vec::len);
        for row in 0..rows {
            let numbers: Vec<f64> =
                columns.iter().filter_map(|column| column.get(row).copied()).collect();
            table.row(&numbers)?;
        }
        table.finish()?;
        self.folder = Some(folder);
        Ok(Some(self.file.to_string_lossy().into_owned()))
    }

    /// An error about the file, as one about the arrays.
    pub fn told(&self, mut error: InputError) -> InputError {
        let is_own = |file: &String| self.folder.is_some() && self.file == *Path::new(file);
        if error.file.take_if(|file| is_own(file)).is_some() {
            let row = error.line.take().filter(|line| *line > 1);
            let row = row.map_or(String::new(), |line| format!("[{}]", line - 2));
            let key = error.key.take().map_or(String::new(), |key| format!(".{key}"));
            error.key = Some(format!("{NAME}{key}{row}"));
        }
        error
    }

    /// Names the arrays where a scene names the file.
    pub fn rename(&self, scene: &mut Scene) {
        if self.folder.is_some()
            && let Some(route) = scene.trajectory.route.as_mut().and_then(Arc::get_mut)
            && let Origin::Log { file, .. } = &mut route.from
        {
            *file = "arrays".to_owned();
        }
    }
}
