//! Writing an `imu.csv`.

use super::csv::{INCREMENTS, RATES};
use crate::input::InputError;
use crate::output::{NumberTable, OutputFile};
use schuler::math::vector::Vector;
use schuler::sample::{Increment, Rates};
use std::path::Path;

/// Writes an `imu.csv`.
#[derive(Debug)]
pub struct ImuWriter {
    table: NumberTable,
}

impl ImuWriter {
    /// Numbers in a row.
    pub const COLUMNS: usize = INCREMENTS.len();

    /// A file of increments.
    pub fn increments(path: impl AsRef<Path>) -> Result<Self, InputError> {
        Ok(Self { table: NumberTable::create(path, &INCREMENTS)? })
    }

    /// A file of rates.
    pub fn rates(path: impl AsRef<Path>) -> Result<Self, InputError> {
        Ok(Self { table: NumberTable::create(path, &RATES)? })
    }

    /// A row of a file of increments: the end of the interval, and what it holds.
    pub fn increment(&mut self, time_s: f64, increment: &Increment<f64>) -> Result<(), InputError> {
        self.row(time_s, increment.angle_b, increment.velocity_b)
    }

    /// A row of a file of rates: an instant, and its rates.
    pub fn rate(&mut self, time_s: f64, rates: &Rates<f64>) -> Result<(), InputError> {
        self.row(time_s, rates.rate_ib_b, rates.specific_force_b)
    }

    fn row(&mut self, time_s: f64, a: Vector<f64>, v: Vector<f64>) -> Result<(), InputError> {
        self.table.row(&[time_s, a.x, a.y, a.z, v.x, v.y, v.z])
    }

    /// Puts the file in its place.
    pub fn finish(self) -> Result<(), InputError> {
        self.table.finish()
    }

    /// The file, whole, but not in its place yet.
    pub fn into_file(self) -> OutputFile {
        self.table.into_file()
    }
}
