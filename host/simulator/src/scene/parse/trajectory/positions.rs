//! Files of positions as paths: RTKLIB `.pos`, NMEA, GPX and KML.

use crate::input::{Complaint, InputError};
use crate::recording::table::Table;
use crate::reference::{Fix, Track};
use crate::units::DEGREE;

/// The rows of a log: time, latitude, longitude and height of each, and nothing in the other columns.
pub fn table(track: &Track, columns: usize) -> Result<Table, InputError> {
    let mut rows: Vec<Vec<f64>> = Vec::new();
    for fix in &track.fixes {
        let time_s = time_s(track, fix, rows.last().and_then(|row| row.first()).copied())?;
        let mut row = vec![0.0; columns];
        let numbers =
            [time_s, fix.latitude / DEGREE, fix.longitude / DEGREE, height(track, fix, None)?];
        for (to, number) in row.iter_mut().zip(numbers) {
            *to = number;
        }
        rows.push(row);
    }
    Ok(Table {
        is_there: (0..columns).map(|column| column < 4).collect(),
        others: Vec::new(),
        rows,
        lines: track.fixes.iter().map(|fix| fix.line).collect(),
    })
}

/// The time of a position, which is later than the one before.
pub fn time_s(track: &Track, fix: &Fix, before_s: Option<f64>) -> Result<f64, InputError> {
    let accepted = "a time at every position, later than that of the one before";
    let wrong = |what| Err(InputError::line(&track.name, fix.line, Complaint::new(what, accepted)));
    match (fix.time_s, before_s) {
        (None, _) => wrong("has no time"),
        (Some(now), Some(before)) if now <= before => wrong("is not later than the one before"),
        (Some(now), _) => Ok(now),
    }
}

/// The height of a position, or what stands for one that it does not have.
pub fn height(track: &Track, fix: &Fix, other: Option<f64>) -> Result<f64, InputError> {
    fix.height.or(other).ok_or_else(|| {
        let complaint = Complaint::new("has no height", "a height at every position");
        InputError::line(&track.name, fix.line, complaint)
    })
}
