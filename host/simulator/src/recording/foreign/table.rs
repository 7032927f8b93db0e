//! The rows of one text file: a time and the numbers of some columns.

use super::super::Unread;
use super::super::instant;
use super::super::lines::Lines;
use super::dialect::Text;
use super::dialect::{Delimiter, Splitter, comment, number};
use super::head::{Head, Place};
use super::map::{Column, Form, Time};
use crate::input::{Complaint, InputError};
use crate::rest::units::TimeUnit;
use std::fs::File;
use std::sync::Arc;

/// Numbers of a row, at most.
const MOST: usize = 6;

/// A file of rows, and where in them things stand.
#[derive(Debug)]
pub struct Table {
    /// Its name, for errors.
    pub name: String,
    file: File,
    begins: (u64, u64),
    delimiter: Delimiter,
    text: Text,
    tag: Option<String>,
    form: Form,
    interval_s: f64,
    rollovers: u64,
    times: Vec<Place>,
    values: Vec<Place>,
}

/// A row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Taken {
    /// Its time, in the unit of its column.
    pub stamp: f64,
    /// The numbers of the columns.
    pub values: [f64; MOST],
    /// Its line.
    pub line: u64,
    /// Whether its text is that of the row before.
    pub repeated: bool,
}

impl Table {
    /// Opens what was looked at. `time` is absent where another file holds it.
    pub fn new(
        head: &Head,
        file: File,
        text: &Text,
        tag: Option<&str>,
        (time, unit): (Option<&Time>, Option<TimeUnit>),
        values: &[&Column],
    ) -> Result<Self, InputError> {
        let counted = Time::default();
        let time = time.unwrap_or(&counted);
        let times: Vec<_> = time.columns.iter().collect();
        let mut places = head.places(&[&times[..], values].concat())?;
        let values = places.split_off(times.len());
        Ok(Self {
            name: head.name.clone(),
            file,
            begins: head.begins,
            delimiter: head.delimiter,
            text: text.clone(),
            tag: tag.map(str::to_owned),
            form: time.form(unit),
            interval_s: time.rate_hz.map_or(0.0, |rate_hz| 1.0 / rate_hz),
            rollovers: time.rollovers,
            times: places,
            values,
        })
    }

    /// How many numbers a row has.
    pub fn width(&self) -> usize {
        self.values.len()
    }

    /// Its rows from the first one.
    pub fn reader(self: &Arc<Self>) -> Result<Reader, InputError> {
        Ok(Reader {
            lines: Lines::new(&self.name, &self.file, self.begins)?,
            splitter: Splitter::new(self.delimiter),
            before: Vec::new(),
            read: 0,
            week: 0.0,
            rounds: self.rollovers,
            table: Arc::clone(self),
        })
    }

    /// The names of what a row must have, for people.
    fn wanted(&self) -> String {
        let names: Vec<_> =
            self.times.iter().chain(&self.values).map(|p| p.name.as_str()).collect();
        names.join(", ")
    }
}

/// Goes along the rows of a table.
#[derive(Debug)]
pub struct Reader {
    lines: Lines,
    splitter: Splitter,
    before: Vec<u8>,
    read: u64,
    /// The last week, and how often weeks of ten bits came round.
    week: f64,
    rounds: u64,
    table: Arc<Table>,
}

impl Reader {
    /// The next row, whole or its stamp alone; a line that is none; or the end.
    pub fn next(&mut self, whole: bool) -> Result<Option<Result<Taken, Unread>>, InputError> {
        loop {
            if !self.lines.next_filled()? {
                return Ok(None);
            }
            let line = self.lines.text();
            if comment(&self.table.text, line).is_some() {
                continue;
            }
            self.splitter.split(line);
            let first = self.splitter.field(0);
            let tag = self.table.tag.as_ref();
            if tag.is_none_or(|tag| first.is_some_and(|first| first == tag.as_bytes())) {
                break;
            }
        }
        self.read += 1;
        let repeated = self.before == self.lines.text();
        if !repeated {
            self.before.clear();
            self.before.extend_from_slice(self.lines.text());
        }
        let line = self.lines.number;
        let taken = self.stamp().map_err(|error| Unread { stamp: None, error: Box::new(error) });
        let taken = taken.and_then(|stamp| {
            let mut values = [0.0; MOST];
            let places = self.table.values.iter().take(if whole { MOST } else { 0 });
            for (value, place) in values.iter_mut().zip(places) {
                *value = self
                    .number(place)
                    .map_err(|error| Unread { stamp: Some(stamp), error: Box::new(error) })?;
            }
            Ok(Taken { stamp, values, line, repeated })
        });
        Ok(Some(taken))
    }

    /// The name of its file.
    pub fn name(&self) -> &str {
        &self.table.name
    }

    /// Rows read so far.
    pub fn read(&self) -> u64 {
        self.read
    }

    fn stamp(&mut self) -> Result<f64, InputError> {
        let times = &self.table.times;
        let number = |i: usize| times.get(i).map_or(Ok(0.0), |place| self.number(place));
        match self.table.form {
            Form::Counted => Ok(self.read as f64 * self.table.interval_s),
            Form::Number => number(0),
            Form::Nanoseconds => Ok(number(0)? + number(1)? * 1e-9),
            Form::Week => {
                let (week, seconds) = (number(0)?, number(1)?);
                let round = self.week - week > 0.5 * instant::WEEKS as f64;
                (self.week, self.rounds) = (week, self.rounds + u64::from(round));
                Ok(instant::week(week, seconds, self.rounds))
            }
            Form::Date => {
                let fields = times.iter().map(|place| self.text(place));
                let fields = fields.collect::<Result<Vec<_>, _>>()?;
                let key = times.first().map_or("time", |place| place.name.as_str());
                instant::date(&fields.join(" ")).map_err(|complaint| self.error(key, complaint))
            }
        }
    }

    fn number(&self, place: &Place) -> Result<f64, InputError> {
        let field = self.splitter.field(place.at).ok_or_else(|| self.short())?;
        number(field).filter(|number| number.is_finite()).ok_or_else(|| {
            let what = format!("\"{}\" is not a finite number", String::from_utf8_lossy(field));
            self.error(&place.name, Complaint::new(what, "a finite number"))
        })
    }

    fn text(&self, place: &Place) -> Result<String, InputError> {
        let field = self.splitter.field(place.at).ok_or_else(|| self.short())?;
        Ok(String::from_utf8_lossy(field).into_owned())
    }

    fn error(&self, key: &str, complaint: Complaint) -> InputError {
        InputError::key(&self.table.name, self.lines.number, key, complaint)
    }

    /// The row has too few fields.
    fn short(&self) -> InputError {
        let places = self.table.times.iter().chain(&self.table.values);
        let least = places.map(|place| place.at + 1).max().unwrap_or(1);
        let what = format!("the row has {} values", self.splitter.count());
        let accepted = format!("{least} or more, for {}", self.table.wanted());
        InputError::line(&self.table.name, self.lines.number, Complaint::new(what, accepted))
    }
}
