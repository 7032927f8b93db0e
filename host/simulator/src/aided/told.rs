//! Measurements as a file tells them: our own CSV, with the columns of [`columns`](super::columns) in any order.

use super::columns::{
    COLUMNS, KINDS, MEASURES, POSITION, POSITION_SIGMAS, RANGES, VELOCITY, VELOCITY_SIGMAS,
};
use super::measurements::Arriving;
use crate::input::{Complaint, InputError};
use crate::recording::table;
use crate::units::DEGREE;
use schuler::aiding::aided::instant::Instant;
use schuler::aiding::aided::measured::{Kind, Measured};
use schuler::earth::Geodetic;
use schuler::math::compensated::Pair;
use schuler::math::vector::Vector;
use std::ops::Range;

/// Standard deviations where a file tells none: positions level and down, m, velocities, m/s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Assumed {
    /// Positions north and east, m.
    pub level_m: f64,
    /// Positions down, m.
    pub down_m: f64,
    /// Velocities, m/s.
    pub velocity_m_s: f64,
}

/// A measurement of a file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Told {
    /// Its line.
    pub line: u64,
    /// When it was true, s.
    pub time_s: f64,
    /// When it arrives, s.
    pub arrives_s: f64,
    /// What it is, at no time yet.
    pub measured: Measured<f64>,
    /// A velocity that is too little to be a measurement, north and east, m/s.
    pub course: Option<[f64; 2]>,
}

impl Told {
    /// Of a position alone or with a velocity.
    pub fn has_position(&self) -> bool {
        matches!(self.measured.kind, Kind::Position | Kind::PositionVelocity)
    }

    /// Velocity north and east, m/s.
    pub fn north_east(&self) -> Option<[f64; 2]> {
        let [north, east, _] = self.measured.velocity.into_array();
        match self.measured.kind {
            Kind::Velocity | Kind::PositionVelocity => Some([north, east]),
            _ => self.course,
        }
    }

    /// As it arrives in a flight that begins at a time, s; `None` if it is of a time before.
    pub fn arriving(&self, origin_s: f64, rate_hz: f64) -> Option<Arriving> {
        let at = Instant::from_seconds(self.time_s - origin_s, rate_hz)?;
        Some((self.arrives_s - origin_s, Measured { at, ..self.measured }))
    }
}

/// Whether a text is one of ours: its header has a time, and something that is measured.
pub fn is_one(text: &str) -> bool {
    let header = text.trim_start_matches('\u{feff}').lines().next().unwrap_or_default();
    let has = |name: &str| header.split(',').any(|column| column.trim() == name);
    has(COLUMNS[0]) && [3, 6, 9, 5, MEASURES].into_iter().any(|i| has(COLUMNS[i]))
}

/// Every row, in the order of the file, and a line on standard deviations that are assumed: those of positions or of
/// velocities of which it has no column.
pub fn read(
    file: &str,
    text: &str,
    assumed: &Assumed,
) -> Result<(Vec<Told>, Vec<String>), InputError> {
    let (mut reader, header) = table::open(file, text)?;
    let mut places = [None; COLUMNS.len()];
    for (i, name) in header.iter().enumerate() {
        let Some(known) = COLUMNS.iter().position(|column| *column == name) else {
            let complaint = Complaint::new("is no column of measurements", COLUMNS.join(", "));
            return Err(InputError::key(file, 1, name, complaint));
        };
        if places[known].replace(i).is_some() {
            let complaint = Complaint::new("is there twice", "every column once");
            return Err(InputError::key(file, 1, name, complaint));
        }
    }
    let lacks = |sigmas: Range<usize>, of: Range<usize>| {
        sigmas.clone().all(|i| places[i].is_none()) && of.clone().any(|i| places[i].is_some())
    };
    let Assumed { level_m, down_m, velocity_m_s } = *assumed;
    let mut absent = [None; COLUMNS.len()];
    let mut said = Vec::new();
    if lacks(POSITION_SIGMAS, POSITION) {
        absent[POSITION_SIGMAS].copy_from_slice(&[level_m, level_m, down_m].map(Some));
        said.push(format!("positions to {level_m} m level and {down_m} m in height"));
    }
    if lacks(VELOCITY_SIGMAS, VELOCITY) {
        absent[VELOCITY_SIGMAS].fill(Some(velocity_m_s));
        said.push(format!("velocities to {velocity_m_s} m/s"));
    }
    if !said.is_empty() {
        let what = said.join(", ");
        said = vec![format!(
            "{file}: no standard deviations: taken as good are {what} (--gnss-sigma)"
        )];
    }
    let mut rows = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|error| table::broken(file, &error))?;
        let line = record.position().map_or(0, csv::Position::line);
        if record.len() != header.len() {
            let what = format!("the row has {} values", record.len());
            let accepted = format!("{}, as the header has", header.len());
            return Err(InputError::line(file, line, Complaint::new(what, accepted)));
        }
        let cell = |i: usize| {
            let place = places.get(i).copied().flatten();
            place.and_then(|place| record.get(place)).filter(|cell| !cell.is_empty())
        };
        rows.push(row(file, line, &cell, &absent)?);
    }
    Ok((rows, said))
}

fn row<'a>(
    file: &str,
    line: u64,
    cell: &dyn Fn(usize) -> Option<&'a str>,
    absent: &[Option<f64>; COLUMNS.len()],
) -> Result<Told, InputError> {
    let wrong = |i: usize, complaint| InputError::key(file, line, COLUMNS[i], complaint);
    let number = |i: usize| -> Result<f64, InputError> {
        let accepted = RANGES[i].accepted;
        let text = cell(i).ok_or_else(|| wrong(i, Complaint::new("is missing", accepted)))?;
        let value = text.parse().map_err(|_| {
            wrong(i, Complaint::new(format!("\"{text}\" is not a number"), accepted))
        })?;
        RANGES[i].check(value).map_err(|complaint| wrong(i, complaint))
    };
    let time_s = number(0)?;
    let arrives_s = if cell(1).is_some() { number(1)? } else { time_s };
    if arrives_s < time_s {
        let what = format!("{arrives_s} is before its time_s");
        return Err(wrong(1, Complaint::new(what, "time_s or later")));
    }
    let found = match cell(MEASURES) {
        Some(word) => KINDS.iter().find(|(name, ..)| *name == word),
        // The cells that are filled tell it.
        None => match (cell(3), cell(6), cell(5), cell(9)) {
            (Some(_), Some(_), ..) => KINDS.get(2),
            (Some(_), ..) => KINDS.first(),
            (_, Some(_), ..) => KINDS.get(1),
            (_, _, Some(_), _) => KINDS.get(3),
            (.., Some(_)) => KINDS.get(4),
            _ => None,
        },
    };
    let Some((_, kind, has)) = found else {
        let what = cell(MEASURES).map_or_else(
            || "the row measures nothing".to_owned(),
            |word| format!("\"{word}\" is nothing that is measured"),
        );
        let words: Vec<_> = KINDS.iter().map(|(word, ..)| *word).collect();
        return Err(wrong(MEASURES, Complaint::new(what, words.join(", "))));
    };
    let other = (3..COLUMNS.len()).find(|i| cell(*i).is_some() && !has.contains(i));
    if let Some(i) = other {
        let what = "is not part of what the row measures";
        return Err(wrong(i, Complaint::new(what, "an empty cell")));
    }
    let mut numbers = [0.0; COLUMNS.len()];
    for i in has.iter().copied() {
        numbers[i] = absent[i].map_or_else(|| number(i), Ok)?;
    }
    let three = |i: usize| Vector::new(numbers[i], numbers[i + 1], numbers[i + 2]);
    let at = Instant::of_sample(0);
    let place = Geodetic {
        latitude: numbers[3] * DEGREE,
        longitude: numbers[4] * DEGREE,
        altitude: numbers[5],
    }
    .map(Pair::new);
    let sigma = numbers[16];
    let measured = match kind {
        Kind::Position => Measured::position(at, place, three(10)),
        Kind::Velocity => Measured::velocity(at, three(6), three(13)),
        Kind::PositionVelocity => {
            Measured::position_velocity(at, place, three(10), three(6), three(13))
        }
        Kind::Height => Measured::height(at, place.altitude, numbers[12]),
        Kind::Speed => Measured::speed(at, numbers[9], sigma),
        Kind::ZeroVelocity => Measured::zero_velocity(at, sigma),
        Kind::NonHolonomic => Measured::non_holonomic(at, sigma),
    };
    Ok(Told { line, time_s, arrives_s, measured, course: None })
}
