//! `imu.csv`: increments or instantaneous rates, a row per sample, its time the interval's end.

use super::{Recording, Sample, quadrature};
use crate::input::{Complaint, InputError};
use crate::output::NumberTable;
use csv::{ByteRecord, ReaderBuilder};
use schuler::alignment::units::Kind;
use schuler::math::vector::Vector;
use schuler::sample::{Increment, Rates};
use std::path::Path;

/// Columns of a file of increments.
pub const INCREMENTS: [&str; 7] = [
    "time_s",
    "dtheta_x_rad",
    "dtheta_y_rad",
    "dtheta_z_rad",
    "dvel_x_m_s",
    "dvel_y_m_s",
    "dvel_z_m_s",
];
/// Columns of a file of instantaneous rates.
pub const RATES: [&str; 7] = [
    "time_s",
    "gyro_x_rad_s",
    "gyro_y_rad_s",
    "gyro_z_rad_s",
    "accel_x_m_s2",
    "accel_y_m_s2",
    "accel_z_m_s2",
];

/// A recording from a file's text; `file` names it in errors.
///
/// Rates become increments by the rule of [`quadrature`].
pub fn parse(file: &str, text: &str) -> Result<Recording, InputError> {
    parse_as(file, text, None)
}

/// The same for samples of a kind, whatever the header says.
pub fn parse_as(file: &str, text: &str, kind: Option<Kind>) -> Result<Recording, InputError> {
    let mut reader =
        ReaderBuilder::new().has_headers(false).flexible(true).from_reader(text.as_bytes());
    let mut record = ByteRecord::new();
    let mut next = |record: &mut ByteRecord| {
        let read = reader.read_byte_record(record);
        read.map_err(|e| InputError::file(file, Complaint::new(format!("is not CSV: {e}"), "")))
    };
    let accepted = || format!("{} or {}", INCREMENTS.join(","), RATES.join(","));
    if !next(&mut record)? {
        return Err(InputError::file(file, Complaint::new("is empty", accepted())));
    }
    let is = |columns: &[&str]| {
        record.iter().map(<[u8]>::trim_ascii).eq(columns.iter().map(|c| c.as_bytes()))
    };
    let columns = if is(&INCREMENTS) {
        &INCREMENTS
    } else if is(&RATES) {
        &RATES
    } else {
        let complaint = Complaint::new("the header is not one of an imu.csv", accepted());
        return Err(InputError::line(file, 1, complaint));
    };

    let mut lines = Lines { text, offset: 0, line: 1 };
    let mut samples = Vec::new();
    let mut last_time = f64::NEG_INFINITY;
    while next(&mut record)? {
        let line = lines.of(&record);
        let [time_s, x, y, z, u, v, w] = numbers(file, line, columns, &record)?;
        if time_s <= last_time {
            let what = format!("{time_s} is not after {last_time}, the row before");
            let complaint = Complaint::new(what, "times that increase");
            return Err(InputError::key(file, line, columns[0], complaint));
        }
        last_time = time_s;
        let increment =
            Increment { angle_b: Vector::new(x, y, z), velocity_b: Vector::new(u, v, w) };
        samples.push(Sample { time_s, line, increment });
    }
    let mut recording = Recording::new(file, samples, None, None)?;
    let by_header = if columns == &RATES { Kind::Rates } else { Kind::Increments };
    recording.kind = kind.unwrap_or(by_header);
    if recording.kind == Kind::Rates {
        quadrature::integrate(&mut recording.samples, recording.interval_s);
    }
    Ok(recording)
}

/// Counts lines as records go by, blank ones too.
struct Lines<'a> {
    text: &'a str,
    offset: usize,
    line: u64,
}

impl Lines<'_> {
    /// The line where a record stands, none of those before it being asked for again.
    fn of(&mut self, record: &ByteRecord) -> u64 {
        // The position is where the last record ended: blank lines may follow.
        let from = record.position().map_or(0, |p| p.byte() as usize);
        let bytes = self.text.as_bytes();
        let blank = |&&b: &&u8| b == b'\n' || b == b'\r';
        let to = from + bytes.iter().skip(from).take_while(blank).count();
        let passed = bytes.get(self.offset..to).unwrap_or_default();
        self.line += passed.iter().filter(|&&b| b == b'\n').count() as u64;
        self.offset = to;
        self.line
    }
}

fn numbers(
    file: &str,
    line: u64,
    columns: &[&str; 7],
    record: &ByteRecord,
) -> Result<[f64; 7], InputError> {
    if record.len() != columns.len() {
        let what = format!("the row has {} values", record.len());
        let complaint = Complaint::new(what, format!("{}: {}", columns.len(), columns.join(",")));
        return Err(InputError::line(file, line, complaint));
    }
    let mut values = [0.0; 7];
    for ((value, field), column) in values.iter_mut().zip(record).zip(columns) {
        let number = std::str::from_utf8(field).ok().and_then(|s| s.trim().parse::<f64>().ok());
        match number {
            Some(number) if number.is_finite() => *value = number,
            _ => {
                let what = format!("\"{}\" is not a finite number", String::from_utf8_lossy(field));
                let complaint = Complaint::new(what, "a finite number");
                return Err(InputError::key(file, line, column, complaint));
            }
        }
    }
    Ok(values)
}

/// Writes an `imu.csv`.
#[derive(Debug)]
pub struct ImuWriter {
    table: NumberTable,
}

impl ImuWriter {
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
}
