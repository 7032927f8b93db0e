//! The rows of an aided `nav.csv`: one at each end of a block, with the filter's standard deviations.

use crate::replay::rows::Finished;
use crate::report::every::{Every, Sieve};
use schuler::solution::Solution;
use schuler_simulator::aided::smoother::Smoothed;
use schuler_simulator::flight::Nine;
use schuler_simulator::formats::mcap::{McapWriter, Motion};
use schuler_simulator::high::Highest;
use schuler_simulator::input::InputError;
use schuler_simulator::output::{NumberTable, OutputFile};
use schuler_simulator::recording::navigation::{COLUMNS, NavigationRow};
use schuler_simulator::recording::track::Track;
use schuler_simulator::units::ARCSECOND;
use std::path::Path;

/// Columns of a row.
pub const WIDTH: usize = COLUMNS.len() + Nine::SIGMAS.len();

/// Rows on their way to the file.
pub struct AidedRows {
    table: NumberTable,
    messages: Option<McapWriter>,
    sieve: Sieve,
    track: Option<Track>,
    /// The last row there was.
    pub last: (f64, Solution<f64>),
    /// The last row as numbers: it may still be corrected.
    waits: Option<[f64; WIDTH]>,
    is_kept: bool,
    /// The rows that are written, where they are wanted.
    kept: Option<Vec<NavigationRow>>,
    /// The place farthest from the ellipsoid.
    pub highest: Highest,
}

impl AidedRows {
    /// Of a flight that starts at a time and in a state.
    pub fn new(
        (out, keep): (&Path, bool),
        mcap: Option<&Path>,
        every: Option<Every>,
        start: (f64, Solution<f64>),
        is_compared: bool,
    ) -> Result<Self, InputError> {
        let columns: Vec<_> = COLUMNS.into_iter().chain(Nine::SIGMAS).collect();
        Ok(Self {
            table: NumberTable::create(out, &columns)?,
            messages: mcap.map(McapWriter::create).transpose()?,
            sieve: Sieve::new(every, start.0),
            track: is_compared.then(Track::default),
            last: start,
            waits: None,
            kept: keep.then(Vec::new),
            is_kept: false,
            highest: Highest::default(),
        })
    }

    /// The state at the end of a block: the stamp of its last sample, that sample's end by the recording's clock, s.
    pub fn add(
        &mut self,
        [time_s, end_s]: [f64; 2],
        state: &Solution<f64>,
        covariance: &[[f64; 9]; 9],
    ) -> Result<(), InputError> {
        if self.is_kept {
            self.write()?;
        }
        self.is_kept = self.sieve.keeps(time_s);
        self.highest.reach(state.position.latitude.hi, state.position.altitude.hi);
        self.last = (time_s, *state);
        if let Some(track) = &mut self.track {
            track.push(end_s, state);
        }
        self.correct(state, covariance);
        Ok(())
    }

    /// The last row once more, corrected.
    pub fn correct(&mut self, state: &Solution<f64>, covariance: &[[f64; 9]; 9]) {
        self.last.1 = *state;
        self.waits = Some(numbers(self.last.0, state, covariance));
    }

    fn write(&mut self) -> Result<(), InputError> {
        let Some(row) = self.waits.take() else { return Ok(()) };
        self.table.row(&row)?;
        let (time_s, state) = &self.last;
        if let Some(kept) = &mut self.kept {
            kept.push(NavigationRow::new(*time_s, state));
        }
        let messages = self.messages.as_mut();
        messages.map_or(Ok(()), |file| file.state(Motion::Computed, *time_s, state))
    }

    /// The files, whole, but not in their places yet; every row that is to be compared; those that are wanted.
    pub fn finish(mut self) -> Result<Finished, InputError> {
        self.write()?;
        let mut files = vec![self.table.into_file()];
        files.extend(self.messages.map(McapWriter::into_file).transpose()?);
        Ok(Finished { files, track: self.track, kept: self.kept.unwrap_or_default() })
    }
}

/// Writes smoothed states, each at a time that is a function of its samples.
pub fn write(
    out: &Path,
    smoothed: &[Smoothed],
    time_s: impl Fn(u64) -> f64,
) -> Result<OutputFile, InputError> {
    let columns: Vec<_> = COLUMNS.into_iter().chain(Nine::SIGMAS).collect();
    let mut table = NumberTable::create(out, &columns)?;
    for Smoothed { samples, solution, covariance, .. } in smoothed {
        table.row(&numbers(time_s(*samples), solution, covariance))?;
    }
    Ok(table.into_file())
}

/// A row: the state, and standard deviations, those of attitude in seconds of arc.
fn numbers(time_s: f64, state: &Solution<f64>, covariance: &[[f64; 9]; 9]) -> [f64; WIDTH] {
    let columns = NavigationRow::new(time_s, state).columns();
    let unit = |i: usize| if i < 6 { 1.0 } else { ARCSECOND };
    let mut row = [0.0; WIDTH];
    let sigmas = (0..9).map(|i| covariance[i][i].max(0.0).sqrt() / unit(i));
    for (cell, number) in row.iter_mut().zip(columns.into_iter().chain(sigmas)) {
        *cell = number;
    }
    row
}
