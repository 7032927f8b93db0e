//! The files of a recording: all in one, side by side row by row, or with clocks of their own.

use super::super::Unread;
use super::super::lines;
use super::head::Head;
use super::map::{Column, Map, Time};
use super::merge::{Merged, Merging};
use super::table::{Reader, Table, Taken};
use crate::input::name::path_of;
use crate::input::{Complaint, InputError};
use schuler::alignment::units::Kind;
use std::fs::File;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Where the numbers of a recording come from.
#[derive(Clone, Debug)]
pub enum Parts {
    /// One file.
    One(Arc<Table>),
    /// Files of which the n-th rows belong together.
    Beside(Vec<Arc<Table>>),
    /// Two sensors, each with times of its own.
    Merged(Merged),
}

/// The recording as it was named, and its file where that is open.
#[derive(Debug)]
pub struct Source<'a> {
    /// A file or a folder.
    pub name: &'a str,
    /// Absent for a folder.
    pub file: Option<&'a File>,
}

impl Source<'_> {
    /// A file beside it, or it itself where no name is given; the first of several that is there.
    fn open(&self, names: &[&str]) -> Result<(String, File), InputError> {
        if names.is_empty() {
            let file = self.file.map(File::try_clone).transpose();
            let file = file.map_err(|error| lines::unreadable(self.name, &error))?;
            let file = file.map_or_else(|| lines::open(self.name), Ok)?;
            return Ok((self.name.to_owned(), file));
        }
        let folder = self.folder();
        let paths = || names.iter().map(|name| folder.join(name).display().to_string());
        match paths().find(|path| path_of(path).exists()) {
            Some(path) => lines::open(&path).map(|file| (path, file)),
            None => {
                let missing: Vec<_> = paths().collect();
                let complaint =
                    Complaint::new("is not there", format!("a file {}", names.join(" or ")));
                Err(InputError::file(missing.first().map_or("", String::as_str), complaint))
            }
        }
    }

    /// Where files beside it are.
    pub fn folder(&self) -> PathBuf {
        let path = Path::new(self.name);
        if path_of(self.name).is_dir() {
            path.to_owned()
        } else {
            path.parent().unwrap_or(path).to_owned()
        }
    }
}

impl Parts {
    /// No file at all.
    pub fn none() -> Self {
        Self::Beside(Vec::new())
    }

    /// As a map has it.
    pub fn open(source: &Source, map: &Map) -> Result<Self, InputError> {
        let Map { text, time, gyro, accelerometer, units, .. } = map;
        time.check(units.time).map_err(|complaint| {
            let error = InputError::file(&map.name, complaint);
            InputError { key: Some("time.columns".to_owned()), ..error }
        })?;
        let table =
            |files: &[String], tag: Option<&str>, time: Option<&Time>, values: &[&Column]| {
                let names: Vec<_> = files.iter().map(String::as_str).collect();
                let (name, file) = source.open(&names)?;
                let head = Head::of(&name, &file, text, tag)?;
                Table::new(&head, file, text, tag, (time, units.time), values).map(Arc::new)
            };
        let [mine, theirs] =
            [gyro, accelerometer].map(|triad| triad.columns.iter().collect::<Vec<_>>());
        let together = gyro.files == accelerometer.files && gyro.rows == accelerometer.rows;
        let all = [&mine[..], &theirs[..]].concat();
        let of = |triad: &super::map::Triad, time: Option<&Time>, values: &[&Column]| {
            table(&triad.files, triad.rows.as_deref(), time, values)
        };
        if let Some(file) = &time.file {
            let mut beside = vec![table(std::slice::from_ref(file), None, Some(time), &[])?];
            if together {
                beside.push(of(gyro, None, &all)?);
            } else {
                beside.push(of(gyro, None, &mine)?);
                beside.push(of(accelerometer, None, &theirs)?);
            }
            return Ok(Self::Beside(beside));
        }
        if together {
            return Ok(Self::One(of(gyro, Some(time), &all)?));
        }
        let tables = [of(gyro, Some(time), &mine)?, of(accelerometer, Some(time), &theirs)?];
        if time.columns.is_empty() {
            return Ok(Self::Beside(tables.into()));
        }
        if units.kind == Some(Kind::Increments) {
            let what = "increments of two clocks cannot be brought to one";
            let accepted = "rates, or rows that belong together with one time";
            return Err(InputError::file(source.name, Complaint::new(what, accepted)));
        }
        let [gyro, accelerometer] = tables;
        Ok(Self::Merged(Merged::new(gyro, accelerometer)?))
    }

    /// The name of the file whose lines are counted.
    pub fn name(&self) -> &str {
        match self {
            Self::One(table) => &table.name,
            Self::Beside(tables) => tables.last().map_or("", |table| &table.name),
            Self::Merged(merged) => &merged.kept.name,
        }
    }

    /// Its rows from the first one.
    pub fn reader(&self) -> Result<PartsReader, InputError> {
        Ok(match self {
            Self::One(table) => PartsReader::One(Box::new(table.reader()?)),
            Self::Beside(tables) => {
                let readers = tables.iter().map(|table| Ok((table.width(), table.reader()?)));
                PartsReader::Beside(readers.collect::<Result<_, InputError>>()?)
            }
            Self::Merged(merged) => PartsReader::Merged(Box::new(merged.reader()?)),
        })
    }
}

/// Goes along the rows of all files at once.
#[derive(Debug)]
pub enum PartsReader {
    /// Of one.
    One(Box<Reader>),
    /// Row by row, with how many numbers each has.
    Beside(Vec<(usize, Reader)>),
    /// By time.
    Merged(Box<Merging>),
}

impl PartsReader {
    /// The next row, whole or its stamp alone; a line that is none; or the end.
    pub fn next(&mut self, whole: bool) -> Result<Option<Result<Taken, Unread>>, InputError> {
        let readers = match self {
            Self::One(reader) => return reader.next(whole),
            Self::Merged(merging) => return merging.next(whole),
            Self::Beside(readers) => readers,
        };
        let (mut sum, mut at, mut ended) = (None::<Result<Taken, Unread>>, 0, None);
        for (width, reader) in readers.iter_mut() {
            match reader.next(whole)? {
                None => ended = Some((reader.name().to_owned(), reader.read())),
                Some(row) => {
                    sum = Some(match (sum, row) {
                        (Some(Err(unread)), _) | (Some(Ok(_)) | None, Err(unread)) => Err(unread),
                        (None, Ok(row)) => {
                            at = *width;
                            Ok(row)
                        }
                        (Some(Ok(mut sum)), Ok(row)) => {
                            sum.values[at..at + *width].copy_from_slice(&row.values[..*width]);
                            at += *width;
                            Ok(Taken {
                                line: row.line,
                                repeated: sum.repeated && row.repeated,
                                ..sum
                            })
                        }
                    });
                }
            }
        }
        match (sum, ended) {
            (Some(_), Some((name, rows))) => {
                let what = format!("ends after {rows} rows, and the files beside it go on");
                let complaint = Complaint::new(what, "as many rows in each");
                Err(InputError::file(&name, complaint))
            }
            (sum, _) => Ok(sum),
        }
    }
}
