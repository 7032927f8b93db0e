//! The rows of `nav.csv` on their way to the file.

use crate::report::every::{Every, Sieve};
use schuler::solution::Solution;
use schuler_simulator::formats::mcap::{McapWriter, Motion};
use schuler_simulator::high::Highest;
use schuler_simulator::input::InputError;
use schuler_simulator::output::{NumberRows, OutputFile};
use schuler_simulator::recording::navigation::{COLUMNS, NavigationRow, NavigationWriter};
use schuler_simulator::recording::track::Track;
use std::collections::VecDeque;
use std::path::Path;

/// A row's time is its sample's own; the last row is always kept.
pub struct Rows {
    writer: NavigationWriter,
    messages: Option<McapWriter>,
    sieve: Sieve,
    /// Of the rows that are still to come: their stamps and their ends by the recording's clock, s.
    times_s: VecDeque<[f64; 2]>,
    /// Every row, where it is to be compared.
    track: Option<Track>,
    /// The last row there was.
    pub last: (f64, Solution<f64>),
    last_is_written: bool,
    /// The rows that are written, where they are wanted.
    kept: Option<NumberRows>,
    /// The place farthest from the ellipsoid.
    pub highest: Highest,
    written: Result<(), InputError>,
}

/// What is left of the rows at the end.
pub struct Finished {
    /// Not in their places yet.
    pub files: Vec<OutputFile>,
    /// Every row, where they are to be compared.
    pub track: Option<Track>,
    /// The rows that are written, where they are wanted.
    pub kept: NumberRows,
}

impl Rows {
    /// Of a flight that starts at a time and in a state.
    pub fn new(
        out: &Path,
        mcap: Option<&Path>,
        every: Option<Every>,
        start: (f64, Solution<f64>),
        is_compared: bool,
        is_kept: bool,
    ) -> Result<Self, InputError> {
        let mut track = is_compared.then(Track::default);
        if let Some(track) = &mut track {
            track.push(start.0, &start.1);
        }
        Ok(Self {
            writer: NavigationWriter::create(out)?,
            messages: mcap.map(McapWriter::create).transpose()?,
            sieve: Sieve::new(every, start.0),
            times_s: VecDeque::new(),
            track,
            last: start,
            last_is_written: true,
            kept: is_kept.then(|| NumberRows::new(&COLUMNS)),
            highest: Highest::default(),
            written: Ok(()),
        })
    }

    /// A sample is about to be flown: the stamp of its row, and its end by the recording's clock, s.
    pub fn expect(&mut self, time_s: f64, end_s: f64) {
        self.times_s.push_back([time_s, end_s]);
    }

    /// The next row.
    pub fn add(&mut self, row: &Solution<f64>) {
        let [time_s, end_s] = self.times_s.pop_front().unwrap_or([self.last.0; 2]);
        self.last = (time_s, *row);
        if let Some(track) = &mut self.track {
            track.push(end_s, row);
        }
        self.highest.reach(row.position.latitude.hi, row.position.altitude.hi);
        self.last_is_written = self.sieve.keeps(self.last.0);
        if self.last_is_written {
            self.write();
        }
    }

    fn write(&mut self) {
        if self.written.is_ok() {
            let (time_s, row) = &self.last;
            let numbers = NavigationRow::new(*time_s, row);
            if let Some(kept) = &mut self.kept {
                kept.add(&numbers.columns());
            }
            self.written = self.writer.row(&numbers).and_then(|()| {
                let messages = self.messages.as_mut();
                messages.map_or(Ok(()), |file| file.state(Motion::Computed, *time_s, row))
            });
        }
    }

    /// What went wrong with the file so far.
    pub fn check(&mut self) -> Result<(), InputError> {
        std::mem::replace(&mut self.written, Ok(()))
    }

    /// The files, whole, but not in their places yet; every row that is to be compared; those that are wanted.
    pub fn finish(mut self) -> Result<Finished, InputError> {
        if !self.last_is_written {
            self.write();
        }
        self.written?;
        let mut files = vec![self.writer.into_file()];
        files.extend(self.messages.map(McapWriter::into_file).transpose()?);
        Ok(Finished { files, track: self.track, kept: self.kept.unwrap_or_default() })
    }
}
