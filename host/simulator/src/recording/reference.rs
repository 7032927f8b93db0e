//! A reference to compare a replay with: a `truth.csv`, a `nav.csv`, or positions alone.

use super::navigation::{COLUMNS, NavigationRow, RANGES};
use super::table::{self, Column};
use crate::input::{Complaint, InputError};
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
    /// Whether it has velocities.
    pub has_velocity: bool,
    /// Whether it has attitudes.
    pub has_attitude: bool,
    /// Names of columns that are not compared.
    pub others: Vec<String>,
}

impl Reference {
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
