//! The rows of an aided `nav.csv`: one at each end of a block, with the filter's standard deviations.

use crate::replay::rows::Finished;
use crate::report::every::{Every, Sieve};
use schuler::solution::Solution;
use schuler_simulator::aided::navigator::Aids;
use schuler_simulator::aided::rows::{WIDTH, columns, numbers};
use schuler_simulator::flight::Nine;
use schuler_simulator::formats::mcap::{McapWriter, Motion};
use schuler_simulator::high::Highest;
use schuler_simulator::input::InputError;
use schuler_simulator::output::{NumberRows, NumberTable, OutputFile};
use schuler_simulator::recording::track::Track;
use std::path::Path;

/// Rows in memory.
struct Kept {
    nav: NumberRows,
    estimates: NumberRows,
    /// Those of the last row.
    waits: Vec<f64>,
}

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
    kept: Option<Kept>,
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
        navigator: &dyn Aids,
    ) -> Result<Self, InputError> {
        let kept = || {
            let names: Vec<_> =
                ["time_s".to_owned()].into_iter().chain(navigator.estimated()).collect();
            let (nav, estimates) = (NumberRows::new(&columns()), NumberRows::new(&names));
            Kept { nav, estimates, waits: Vec::new() }
        };
        Ok(Self {
            table: NumberTable::create(out, &columns())?,
            messages: mcap.map(McapWriter::create).transpose()?,
            sieve: Sieve::new(every, start.0),
            track: is_compared.then(Track::default),
            last: start,
            waits: None,
            kept: keep.then(kept),
            is_kept: false,
            highest: Highest::default(),
        })
    }

    /// The state at the end of a block: the stamp of its last sample, that sample's end by the recording's clock, s.
    pub fn add(
        &mut self,
        [time_s, end_s]: [f64; 2],
        state: &Solution<f64>,
        navigator: &dyn Aids,
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
        self.correct(state, navigator);
        Ok(())
    }

    /// The last row once more, corrected.
    pub fn correct(&mut self, state: &Solution<f64>, navigator: &dyn Aids) {
        self.last.1 = *state;
        if let Some(track) = &mut self.track {
            track.claim(state, Nine::of_covariance(&navigator.covariance()));
        }
        self.waits = Some(numbers(self.last.0, state, &navigator.covariance()));
        if let Some(kept) = &mut self.kept {
            navigator.estimates(&mut kept.waits);
        }
    }

    fn write(&mut self) -> Result<(), InputError> {
        let Some(row) = self.waits.take() else { return Ok(()) };
        self.table.row(&row)?;
        let (time_s, state) = &self.last;
        if let Some(kept) = &mut self.kept {
            kept.nav.add(&row);
            kept.estimates.add(&[*time_s]);
            kept.estimates.add(&kept.waits);
        }
        let messages = self.messages.as_mut();
        messages.map_or(Ok(()), |file| file.state(Motion::Computed, *time_s, state))
    }

    /// The files, whole, but not in their places yet; every row that is to be compared; those that are wanted.
    pub fn finish(mut self) -> Result<(Finished, NumberRows), InputError> {
        self.write()?;
        let mut files = vec![self.table.into_file()];
        files.extend(self.messages.map(McapWriter::into_file).transpose()?);
        let (kept, estimates) =
            self.kept.map(|Kept { nav, estimates, .. }| (nav, estimates)).unwrap_or_default();
        Ok((Finished { files, track: self.track, kept }, estimates))
    }
}

/// Writes rows to a file.
pub fn write(out: &Path, rows: &NumberRows) -> Result<OutputFile, InputError> {
    let names: Vec<_> = rows.names.iter().map(String::as_str).collect();
    let mut table = NumberTable::create(out, &names)?;
    rows.iter().try_for_each(|row| table.row(row))?;
    Ok(table.into_file())
}
