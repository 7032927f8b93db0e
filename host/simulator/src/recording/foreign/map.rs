//! A map: which columns of whose files hold what, in which units and axes.

use super::super::instant::Scale;
use super::super::mounting::Mounting;
use super::super::reduction::Known;
use super::dialect::Text;
use crate::input::Complaint;
use crate::rest::units::{TimeUnit, Units};

/// A column, by its name in the header or its number from 1.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Column {
    /// As the header has it, up to case and white space around it.
    Name(String),
    /// The first is 1.
    Number(usize),
}

/// Where the time of a row is.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Time {
    /// Its column, or two: week and seconds, date and time of day, seconds and nanoseconds. None where rows are
    /// counted.
    pub columns: Vec<Column>,
    /// Samples per second where rows are counted.
    pub rate_hz: Option<f64>,
    /// What whole times are counted from.
    pub scale: Option<Scale>,
    /// How often a ten-bit week came round.
    pub rollovers: u64,
    /// The file that holds it, row by row, where it has one of its own.
    pub file: Option<String>,
}

/// Where three axes of a sensor are.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Triad {
    /// x, y, z; empty where nothing is said.
    pub columns: Vec<Column>,
    /// Files that may hold it, beside the recording; the first that is there does. Empty where the recording does.
    pub files: Vec<String>,
    /// The first field of the rows that belong to it, where rows of several kinds stand in one file.
    pub rows: Option<String>,
}

/// How a recording is written.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Map {
    /// The file or the built-in name that it comes from; empty for the options of the command line.
    pub name: String,
    /// What it is, for people.
    pub title: String,
    /// How lines are written.
    pub text: Text,
    /// Fields of a row, at least, where there is no header to know it by.
    pub fields: Option<usize>,
    /// Columns beside those that are read by which a header is known.
    pub header: Vec<Column>,
    /// The time.
    pub time: Time,
    /// The gyros.
    pub gyro: Triad,
    /// The accelerometers.
    pub accelerometer: Triad,
    /// Units and the kind of samples, as far as they are said.
    pub units: Units,
    /// Axes, where they are said.
    pub mounting: Option<Mounting>,
    /// Whether accelerometers read gravity itself, down at rest.
    pub reversed: bool,
    /// Known errors of gyros and accelerometers.
    pub known: Option<[Known; 2]>,
}

/// What the command line says of a recording.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Given {
    /// A map file, or a built-in map's name.
    pub map: Option<String>,
    /// Columns of time, gyros x, y, z and accelerometers x, y, z.
    pub columns: Option<Columns>,
    /// Units, kind of samples, unit of time.
    pub units: Units,
    /// Axes.
    pub axes: Option<Mounting>,
    /// Samples per second, for rows without a time.
    pub rate_hz: Option<f64>,
}

/// The value of `--columns`.
#[derive(Clone, Debug, PartialEq)]
pub struct Columns(pub [Column; 7]);

impl Given {
    /// Puts what was given in place of what a map says.
    pub(super) fn apply(&self, map: &mut Map) {
        if let Some(Columns([time, gyro @ .., u, v, w])) = &self.columns {
            map.time.columns = vec![time.clone()];
            map.time.file = None;
            map.gyro = Triad { columns: gyro.to_vec(), ..Triad::default() };
            let columns = [u, v, w].map(Clone::clone).to_vec();
            map.accelerometer = Triad { columns, ..Triad::default() };
        }
        map.units = self.units.or(map.units);
        map.mounting = self.axes.or(map.mounting);
        if map.time.columns.is_empty() {
            map.time.rate_hz = map.time.rate_hz.or(self.rate_hz);
        }
    }
}

impl Map {
    /// What it says, and where that is nothing, what another one says.
    pub(super) fn or(self, other: Self) -> Self {
        let text = if self.text == Text::default() { other.text } else { self.text };
        let own = |columns: &[Column]| !columns.is_empty();
        Self {
            name: self.name,
            title: other.title,
            text,
            fields: other.fields,
            header: other.header,
            time: if own(&self.time.columns) { self.time } else { other.time },
            gyro: if own(&self.gyro.columns) { self.gyro } else { other.gyro },
            accelerometer: if own(&self.accelerometer.columns) {
                self.accelerometer
            } else {
                other.accelerometer
            },
            units: self.units.or(other.units),
            mounting: self.mounting.or(other.mounting),
            reversed: self.reversed || other.reversed,
            known: self.known.or(other.known),
        }
    }
}

impl Time {
    /// What its columns and their unit do not agree in.
    pub(super) fn check(&self, unit: Option<TimeUnit>) -> Result<(), Complaint> {
        use TimeUnit::{GpsWeek, Microseconds, Milliseconds, Nanoseconds};
        match (self.columns.len(), unit) {
            (1, Some(GpsWeek)) => {
                Err(Complaint::new("has no column of seconds", "week and seconds"))
            }
            (2, Some(Milliseconds | Microseconds | Nanoseconds)) => {
                let accepted = "one column, or two of s and ns (unit \"s\"), of a date and a time, of week and seconds";
                Err(Complaint::new("has two columns of one unit", accepted))
            }
            _ => Ok(()),
        }
    }

    /// What the numbers of its columns are, by their unit and number.
    pub(super) fn form(&self, unit: Option<TimeUnit>) -> Form {
        match (self.columns.len(), unit) {
            (0, _) => Form::Counted,
            (_, Some(TimeUnit::GpsWeek)) => Form::Week,
            (_, Some(TimeUnit::Iso8601)) => Form::Date,
            (1, _) => Form::Number,
            _ => Form::Nanoseconds,
        }
    }
}

/// What the columns of time hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    /// Nothing: rows are counted.
    Counted,
    /// A number.
    Number,
    /// Seconds, and nanoseconds to be added.
    Nanoseconds,
    /// A GPS week, and seconds.
    Week,
    /// A date and a time of day, in one column or two.
    Date,
}
