//! A reference to compare a replay with: a `truth.csv`, a `nav.csv`, or positions alone.

use super::instant::Scale;
use super::navigation::{COLUMNS, NavigationRow, RANGES};
use super::table::{self, Column};
use crate::input::{Complaint, InputError, read_text};
use crate::reference::{Fix, Track};
use schuler::earth::Geodetic;
use schuler::math::compensated::Pair;
use schuler::math::quaternion::Quaternion;
use schuler::math::vector::Vector;
use schuler::solution::Solution;

/// Where a vehicle was at times of their own; what a reference does not have is not a number.
#[derive(Clone, Debug, Default)]
pub struct Reference {
    /// Its name, for people.
    pub name: String,
    /// Times in s, increasing, and the state at each.
    pub rows: Vec<(f64, Solution<f64>)>,
    /// Standard deviations of the positions, north, east, down, m, where all of them are told.
    pub sigma_ned_m: Option<Vec<Vector<f64>>>,
    /// Whether it has velocities.
    pub has_velocity: bool,
    /// Whether it has attitudes.
    pub has_attitude: bool,
    /// Names of columns that are not compared.
    pub others: Vec<String>,
}

impl Reference {
    /// From a CSV file, or from positions that others measured, whose times are told on the scale of a recording,
    /// or where that is not known in seconds since 1970, UTC.
    pub fn open(file: &str, scale: Option<Scale>) -> Result<Self, InputError> {
        let text = read_text(file)?;
        if !Track::is_one(&text) {
            return Self::read(file);
        }
        let track = Track::parse(file, &text)?.on(scale.unwrap_or(Scale::Utc));
        let whole = |fix: &Fix| fix.north_east.is_some() && fix.down.is_some();
        let has_velocity = track.fixes.iter().all(whole);
        let mut rows: Vec<(f64, Solution<f64>)> = Vec::new();
        for fix in &track.fixes {
            let (Some(time_s), Some(altitude)) = (fix.time_s, fix.height) else {
                let complaint = Complaint::new("has no time or no height", "both in every place");
                return Err(InputError::line(file, fix.line, complaint));
            };
            if rows.last().is_some_and(|(before_s, _)| *before_s >= time_s) {
                let complaint =
                    Complaint::new("is not after the place before", "times that increase");
                return Err(InputError::line(file, fix.line, complaint));
            }
            let position = Geodetic { latitude: fix.latitude, longitude: fix.longitude, altitude };
            let [north, east] = fix.north_east.unwrap_or_default();
            let velocity_ned = Vector::new(north, east, fix.down.unwrap_or_default());
            let row = NavigationRow { time_s, position, velocity_ned, ..NavigationRow::default() };
            let mut state = row.solution();
            if !has_velocity {
                state.velocity_ned = Vector { x: NOTHING, y: NOTHING, z: NOTHING };
            }
            state.attitude = UNKNOWN;
            rows.push((time_s, state));
        }
        if rows.len() < 2 {
            let complaint = Complaint::new(format!("has {} places", rows.len()), "two or more");
            return Err(InputError::file(file, complaint));
        }
        let sigma_ned_m = track.fixes.iter().map(|fix| fix.position_sigma_ned).collect();
        let (name, others) = (file.to_owned(), Vec::new());
        Ok(Self { name, rows, sigma_ned_m, has_velocity, has_attitude: false, others })
    }

    /// From a CSV file with columns named as those of `nav.csv`, in any order: a time and a position,
    /// and velocity and attitude if they are there.
    pub fn read(file: &str) -> Result<Self, InputError> {
        let columns: [Column; COLUMNS.len()] =
            std::array::from_fn(|i| Column { name: COLUMNS[i], range: RANGES[i] });
        let table = table::read(file, &columns)?;
        let is_there = |from: usize, to: usize| {
            let missing = (from..to).filter(|&i| !table.is_there[i]);
            missing.map(|i| COLUMNS[i]).collect::<Vec<_>>()
        };
        let needed = is_there(0, 4);
        let (velocity, attitude) = (is_there(4, 7), is_there(7, 10));
        for (missing, what) in [
            (&needed, "time and position"),
            (&velocity, "all of a velocity or none"),
            (&attitude, "all of an attitude or none"),
        ] {
            let is_wrong =
                (1..3).contains(&missing.len()) || (missing.len() > 2 && what.starts_with("time"));
            if is_wrong {
                let complaint = Complaint::new(
                    format!("the header lacks {}", missing.join(", ")),
                    format!("{what}, of {}", COLUMNS.join(",")),
                );
                return Err(InputError::line(file, 1, complaint));
            }
        }
        if table.rows.len() < 2 {
            let what = format!("has {} rows", table.rows.len());
            return Err(InputError::file(file, Complaint::new(what, "two rows or more")));
        }
        let (has_velocity, has_attitude) = (velocity.is_empty(), attitude.is_empty());
        let rows = table.rows.iter().map(|row| {
            let numbers = std::array::from_fn(|i| row.get(i).copied().unwrap_or_default());
            let row = NavigationRow::of_columns(&numbers);
            let mut state = row.solution();
            if !has_velocity {
                state.velocity_ned = Vector { x: NOTHING, y: NOTHING, z: NOTHING };
            }
            if !has_attitude {
                state.attitude = UNKNOWN;
            }
            (row.time_s, state)
        });
        Ok(Self {
            name: file.to_owned(),
            rows: rows.collect(),
            sigma_ned_m: None,
            has_velocity,
            has_attitude,
            others: table.others,
        })
    }
}

/// No number.
const NOTHING: Pair<f64> = Pair { hi: f64::NAN, lo: 0.0 };
/// No attitude.
const UNKNOWN: Quaternion<Pair<f64>> =
    Quaternion { w: NOTHING, v: Vector { x: NOTHING, y: NOTHING, z: NOTHING } };
