//! A recording's file, read from its start as often as needed, a row at a time.

use super::navigation::NavigationRow;
use super::{Kind, Row, csv, psins};
use crate::input::{Complaint, InputError};
use crate::rest::units::Units;
use std::fs::File;
use std::io::{self, BufRead, BufReader, Read, Seek, Write};
use std::path::Path;

/// Bytes of a line, at most: a file without lines is no recording.
const LONGEST: u64 = 1 << 16;

/// A file of samples, not yet read beyond what stands before them.
#[derive(Debug)]
pub struct Recording {
    /// Its name, for errors about its samples.
    pub name: String,
    /// What its rows hold, or are said to hold.
    pub kind: Kind,
    /// The sample interval that the file itself states, s.
    pub interval_s: Option<f64>,
    /// The state that the file itself says it starts from.
    pub initial: Option<NavigationRow>,
    file: File,
    layout: Layout,
    units: Units,
    /// Where the rows begin, and on which line.
    begins: (u64, u64),
}

/// How rows are written.
#[derive(Clone, Copy, Debug)]
pub(super) enum Layout {
    Csv(&'static [&'static str; 7]),
    Psins(psins::Settings),
}

impl Recording {
    /// From a file: a PSINS `.imu` (by its ending or its `%`), else a CSV of increments or rates. What can
    /// be read only once, a pipe, is kept in a temporary file that nobody else sees.
    pub fn open(name: &str) -> Result<Self, InputError> {
        let open = || -> io::Result<File> {
            let mut file = File::open(name)?;
            if file.metadata()?.is_file() {
                return Ok(file);
            }
            let mut spooled = tempfile::tempfile()?;
            io::copy(&mut file, &mut spooled)?;
            Ok(spooled)
        };
        Self::new(name, open().map_err(|error| unreadable(name, &error))?)
    }

    /// The same, its numbers in units of their own.
    pub fn open_in(name: &str, units: Units) -> Result<Self, InputError> {
        let recording = Self::open(name)?;
        let kind = units.kind.unwrap_or(recording.kind);
        if matches!(recording.layout, Layout::Psins(_)) && kind == Kind::Rates {
            let what = "a PSINS .imu holds increments";
            let complaint = Complaint::new(what, "units without rates");
            return Err(InputError::option("--units", complaint));
        }
        Ok(Self { kind, units, ..recording })
    }

    /// From a text; `name` stands for it in errors.
    pub fn of_text(name: &str, text: &str) -> Result<Self, InputError> {
        let spool = || -> io::Result<File> {
            let mut file = tempfile::tempfile()?;
            file.write_all(text.as_bytes())?;
            Ok(file)
        };
        Self::new(name, spool().map_err(|error| unreadable(name, &error))?)
    }

    fn new(name: &str, file: File) -> Result<Self, InputError> {
        let mut lines = Lines::new(name, &file, (0, 0))?;
        let first = lines.next_filled()?;
        let is_psins = Path::new(name).extension().is_some_and(|e| e.eq_ignore_ascii_case("imu"))
            || (first && lines.text().starts_with(b"%"));
        if is_psins {
            let (settings, initial) = psins::settings(name, &mut lines, first)?;
            return Ok(Self {
                name: name.to_owned(),
                kind: Kind::Increments,
                interval_s: Some(settings.interval_s),
                initial: Some(initial),
                file,
                layout: Layout::Psins(settings),
                units: Units::default(),
                begins: lines.place(),
            });
        }
        if !first {
            return Err(InputError::file(name, Complaint::new("is empty", csv::accepted())));
        }
        let columns = csv::columns(name, lines.number, lines.text())?;
        let kind = if *columns == csv::RATES { Kind::Rates } else { Kind::Increments };
        Ok(Self {
            name: name.to_owned(),
            kind,
            interval_s: None,
            initial: None,
            file,
            layout: Layout::Csv(columns),
            units: Units::default(),
            begins: lines.place(),
        })
    }

    /// Its rows from the first one.
    pub fn rows(&self) -> Result<Rows, InputError> {
        Ok(Rows {
            lines: Lines::new(&self.name, &self.file, self.begins)?,
            layout: self.layout,
            units: self.units,
            before: Vec::new(),
            read: 0,
        })
    }

    /// An error about one of its lines.
    pub fn error(&self, line: u64, complaint: Complaint) -> InputError {
        InputError::line(&self.name, line, complaint)
    }
}

/// The rows of a recording, in the order of its lines.
#[derive(Debug)]
pub struct Rows {
    lines: Lines,
    layout: Layout,
    units: Units,
    before: Vec<u8>,
    read: u64,
}

/// A line that is not a row.
#[derive(Clone, Debug, PartialEq)]
pub struct Unread {
    /// Its time stamp, where that can be read.
    pub stamp: Option<f64>,
    /// What is wrong.
    pub error: Box<InputError>,
}

impl Rows {
    /// The next row, whole or its stamp alone; a line that is none; or the end. An error is one of the file.
    pub fn next(&mut self, whole: bool) -> Result<Option<Result<Row, Unread>>, InputError> {
        loop {
            if !self.lines.next_filled()? {
                return Ok(None);
            }
            let comment = matches!(self.layout, Layout::Psins(_)) && self.lines.text()[0] == b'%';
            if !comment {
                break;
            }
        }
        self.read += 1;
        let Lines { name, number, .. } = &self.lines;
        let text = self.lines.text();
        let parsed = match self.layout {
            Layout::Csv(columns) => csv::row(name, *number, columns, text, whole),
            Layout::Psins(settings) => settings.row(name, *number, self.read, text, whole),
        };
        let repeated = self.before == text;
        if !repeated {
            self.before.clear();
            self.before.extend_from_slice(text);
        }
        let (line, units) = (*number, self.units);
        Ok(Some(parsed.map(|(stamp, values)| {
            let values = units.apply(&values);
            Row { stamp, line, values, repeated }
        })))
    }
}

/// Lines of a file with their numbers, blank ones passed over.
#[derive(Debug)]
pub(super) struct Lines {
    name: String,
    reader: BufReader<File>,
    line: Vec<u8>,
    offset: u64,
    /// Of the line at hand, from 1.
    pub(super) number: u64,
}

impl Lines {
    fn new(name: &str, file: &File, (offset, number): (u64, u64)) -> Result<Self, InputError> {
        let again = || -> io::Result<File> {
            let mut file = file.try_clone()?;
            file.seek(io::SeekFrom::Start(offset))?;
            Ok(file)
        };
        let file = again().map_err(|error| unreadable(name, &error))?;
        let reader = BufReader::with_capacity(1 << 18, file);
        Ok(Self { name: name.to_owned(), reader, line: Vec::new(), offset, number })
    }

    /// Goes on to the next line that is not blank; false at the end.
    pub(super) fn next_filled(&mut self) -> Result<bool, InputError> {
        loop {
            self.line.clear();
            let read = self.reader.by_ref().take(LONGEST).read_until(b'\n', &mut self.line);
            let read = read.map_err(|error| unreadable(&self.name, &error))?;
            if read == 0 {
                return Ok(false);
            }
            self.offset += read as u64;
            self.number += 1;
            if read as u64 == LONGEST {
                let what = format!("the line is longer than {LONGEST} bytes");
                return Err(InputError::line(&self.name, self.number, Complaint::new(what, "")));
            }
            if self.number == 1 && self.line.starts_with(b"\xEF\xBB\xBF") {
                self.line.drain(..3);
            }
            if !self.text().is_empty() {
                return Ok(true);
            }
        }
    }

    /// The line at hand, without white space around it.
    pub(super) fn text(&self) -> &[u8] {
        self.line.trim_ascii()
    }

    fn place(&self) -> (u64, u64) {
        (self.offset, self.number)
    }
}

fn unreadable(name: &str, error: &io::Error) -> InputError {
    InputError::file(name, Complaint::new(format!("cannot be read: {error}"), ""))
}
