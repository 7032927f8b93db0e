//! The rows of `nav.csv` on their way to the file.

use crate::cli::{Every, Sieve};
use schuler::solution::Solution;
use schuler_simulator::high::Highest;
use schuler_simulator::input::InputError;
use schuler_simulator::recording::navigation::{NavigationRow, NavigationWriter};
use std::collections::VecDeque;
use std::path::Path;

/// A row's time is its sample's own; the last row is always kept.
pub struct Rows {
    writer: NavigationWriter,
    sieve: Sieve,
    /// Times of the rows that are still to come, s.
    times_s: VecDeque<f64>,
    /// The last row there was.
    pub last: (f64, Solution<f64>),
    last_is_written: bool,
    /// The place farthest from the ellipsoid.
    pub highest: Highest,
    written: Result<(), InputError>,
}

impl Rows {
    /// Of a flight that starts at a time and in a state.
    pub fn new(
        out: &Path,
        every: Option<Every>,
        start: (f64, Solution<f64>),
    ) -> Result<Self, InputError> {
        Ok(Self {
            writer: NavigationWriter::create(out)?,
            sieve: Sieve::new(every, start.0),
            times_s: VecDeque::new(),
            last: start,
            last_is_written: true,
            highest: Highest::default(),
            written: Ok(()),
        })
    }

    /// A sample is about to be flown: the time of its row, s.
    pub fn expect(&mut self, time_s: f64) {
        self.times_s.push_back(time_s);
    }

    /// The next row.
    pub fn add(&mut self, row: &Solution<f64>) {
        self.last = (self.times_s.pop_front().unwrap_or(self.last.0), *row);
        self.highest.reach(row.position.latitude.hi, row.position.altitude.hi);
        self.last_is_written = self.sieve.keeps(self.last.0);
        if self.last_is_written {
            self.write();
        }
    }

    fn write(&mut self) {
        if self.written.is_ok() {
            let (time_s, row) = &self.last;
            self.written = self.writer.row(&NavigationRow::new(*time_s, row));
        }
    }

    /// What went wrong with the file so far.
    pub fn check(&mut self) -> Result<(), InputError> {
        std::mem::replace(&mut self.written, Ok(()))
    }

    /// Puts the file in its place; returns the last row.
    pub fn finish(mut self) -> Result<(f64, Solution<f64>), InputError> {
        if !self.last_is_written {
            self.write();
        }
        self.written?;
        self.writer.finish()?;
        Ok(self.last)
    }
}
