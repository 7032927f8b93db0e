//! RTKLIB's `.pos`: a row for each epoch, with blanks, commas, semicolons or tabs between.
//!
//! Time is a date and a time of day, or a GPS week and its seconds; then latitude and longitude in degrees,
//! ellipsoidal height, quality, number of satellites, σ north, east, up and covariances, age, ratio and, where
//! the receiver gives them, velocity north, east, up with its σ. The line of comments that names the columns tells
//! the scale of time.

use super::{Fix, Track, place};
use crate::input::{Complaint, InputError};
use crate::recording::instant::{self, GPS_EPOCH_S, Scale};
use schuler::math::vector::Vector;

/// Columns that every row has, after the time.
const COLUMNS: [&str; 8] = ["latitude", "longitude", "height", "Q", "ns", "sdn", "sde", "sdu"];
/// Where the columns of velocity begin, after the time, and how many there are with their σ.
const VELOCITY: (usize, usize) = (13, 6);

/// Whether a text looks like one: its comments name the columns of a solution.
pub fn is_one(text: &str) -> bool {
    header(text).is_some()
}

/// The comment that names the columns.
fn header(text: &str) -> Option<&str> {
    let comments = text.lines().take_while(|line| line.starts_with('%') || line.trim().is_empty());
    comments
        .filter(|line| line.contains("GPST") || line.contains("UTC") || line.contains("JST"))
        .find(|line| {
            line.contains("latitude") || line.contains("x-ecef") || line.contains("e-baseline")
        })
}

/// All rows.
pub fn read(file: &str, text: &str) -> Result<Track, InputError> {
    let header = header(text).unwrap_or_default();
    let column = |line: &&str| line.starts_with('%') && *line == header;
    let line = 1 + text.lines().position(|line| column(&line)).unwrap_or(0) as u64;
    if !header.contains("latitude(deg)") || header.contains("JST") {
        let what = "has positions or times in another form";
        let accepted = "latitude and longitude in degrees, height in metres, GPST or UTC (RTKLIB's out-solformat llh, out-timesys gpst)";
        return Err(InputError::line(file, line, Complaint::new(what, accepted)));
    }
    let scale = if header.contains("GPST") { Scale::Gps } else { Scale::Utc };
    let mut fixes = Vec::new();
    for (line, text) in (1..).zip(text.lines()) {
        if !text.trim().is_empty() && !text.starts_with('%') {
            fixes.push(row(file, line, text, scale)?);
        }
    }
    let said = if header.contains("geodetic") {
        vec![format!("{file}: heights may be above the geoid, taken as above the ellipsoid")]
    } else {
        Vec::new()
    };
    Ok(Track { scale: Some(scale), fixes, said, ..Track::default() })
}

fn row(file: &str, line: u64, text: &str, scale: Scale) -> Result<Fix, InputError> {
    let separators = |c: char| c.is_whitespace() || c == ',' || c == ';';
    let fields: Vec<_> = text.split(separators).filter(|field| !field.is_empty()).collect();
    let [first, second, rest @ ..] = fields.as_slice() else {
        return Err(short(file, line, fields.len()));
    };
    if rest.len() < COLUMNS.len() {
        return Err(short(file, line, fields.len()));
    }
    let number = |key: &str, field: &str| -> Result<f64, InputError> {
        let parsed = field.parse().ok().filter(|value: &f64| value.is_finite());
        parsed.ok_or_else(|| {
            let what = format!("\"{field}\" is not a finite number");
            InputError::key(file, line, key, Complaint::new(what, "a finite number"))
        })
    };
    let time_s = if first.contains('/') {
        let date = instant::date(&format!("{first} {second}"));
        let date = date.map_err(|complaint| InputError::key(file, line, "time", complaint))?;
        if scale == Scale::Gps { date - GPS_EPOCH_S as f64 } else { date }
    } else {
        let gps_s = instant::week(number("week", first)?, number("seconds", second)?, 0);
        Scale::Gps.to(scale, gps_s)
    };
    let column = |i: usize| number(COLUMNS[i], rest[i]);
    let mut fix = Fix {
        time_s: Some(time_s),
        height: Some(column(2)?),
        position_sigma_ned: Some(Vector::new(column(5)?, column(6)?, column(7)?)),
        ..place(file, line, column(0)?, column(1)?)?
    };
    if let Some(velocity) = rest.get(VELOCITY.0..VELOCITY.0 + VELOCITY.1) {
        let names = ["vn", "ve", "vu", "sdvn", "sdve", "sdvu"];
        let mut values = [0.0; 6];
        for ((value, name), field) in values.iter_mut().zip(names).zip(velocity) {
            *value = number(name, field)?;
        }
        let [north, east, up, sn, se, su] = values;
        fix.north_east = Some([north, east]);
        fix.down = Some(-up);
        fix.velocity_sigma_ned = Some(Vector::new(sn, se, su));
    }
    Ok(fix)
}

fn short(file: &str, line: u64, count: usize) -> InputError {
    let accepted = format!("{} or more: date, time, {}", 2 + COLUMNS.len(), COLUMNS.join(", "));
    InputError::line(file, line, Complaint::new(format!("the row has {count} values"), accepted))
}
