//! What is known of a vehicle's height, for a vertical channel that is held to it.

use super::navigation::RANGES;
use super::table::{self, Column};
use crate::input::{Complaint, InputError};

/// Altitude over time, along straight lines between rows.
#[derive(Clone, Debug)]
pub struct Heights {
    /// Times in s, increasing, and altitudes in m.
    rows: Vec<[f64; 2]>,
}

impl Heights {
    /// The same at all times, m.
    pub fn constant(altitude_m: f64) -> Self {
        Self { rows: vec![[0.0, altitude_m]] }
    }

    /// From a CSV file with the columns `time_s` and `altitude_m`, and others that are not looked at.
    pub fn read(file: &str) -> Result<Self, InputError> {
        let columns =
            [("time_s", 0), ("altitude_m", 3)].map(|(name, i)| Column { name, range: RANGES[i] });
        let table = table::read(file, &columns)?;
        let missing = columns.iter().zip(&table.is_there).filter(|(_, is_there)| !**is_there);
        let missing: Vec<_> = missing.map(|(column, _)| column.name).collect();
        if !missing.is_empty() {
            let what = format!("the header lacks {}", missing.join(", "));
            return Err(InputError::line(file, 1, Complaint::new(what, "time_s,altitude_m")));
        }
        let rows: Vec<_> = table.rows.iter().filter_map(|row| row.first_chunk().copied()).collect();
        if rows.len() < 2 {
            let what = format!("has {} rows", rows.len());
            return Err(InputError::file(file, Complaint::new(what, "two rows or more")));
        }
        Ok(Self { rows })
    }

    /// First and last time, s, where it changes with time.
    pub fn span_s(&self) -> Option<[f64; 2]> {
        match &self.rows[..] {
            [[first_s, _], .., [last_s, _]] => Some([*first_s, *last_s]),
            _ => None,
        }
    }

    /// Altitude in m and velocity down in m/s at a time; beyond the ends as at them.
    pub fn at(&self, time_s: f64) -> [f64; 2] {
        let after = self.rows.partition_point(|[t, _]| *t < time_s).max(1);
        match (self.rows.get(after - 1), self.rows.get(after)) {
            (Some([a_s, a_m]), Some([b_s, b_m])) => {
                let slope = (b_m - a_m) / (b_s - a_s);
                if time_s < *a_s { [*a_m, 0.0] } else { [a_m + slope * (time_s - a_s), -slope] }
            }
            (Some([_, altitude_m]), None) => [*altitude_m, 0.0],
            _ => [0.0, 0.0],
        }
    }
}
