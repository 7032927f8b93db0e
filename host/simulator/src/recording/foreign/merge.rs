//! Gyros and accelerometers of separate clocks, brought to one: the slower sensor is interpolated to the times
//! of the faster one, by the cubic through the two readings before and the two after.

use super::super::Unread;
use super::table::{Reader, Table, Taken};
use crate::input::{Complaint, InputError};
use std::collections::VecDeque;
use std::sync::Arc;

/// A reading is missing where its neighbours are further apart than this many usual steps.
const GAP: f64 = 5.0;
/// Rows that the usual step is taken from.
const LOOK: usize = 1024;

/// Two tables of three numbers, the first of them the one whose times stay.
#[derive(Clone, Debug)]
pub struct Merged {
    /// The faster one.
    pub kept: Arc<Table>,
    /// The other one.
    pub interpolated: Arc<Table>,
    /// Whether the gyros are the faster.
    pub gyro_kept: bool,
    /// The usual steps of both, in the unit of their times.
    pub steps: [f64; 2],
}

impl Merged {
    /// Of gyros and accelerometers.
    pub fn new(gyro: Arc<Table>, accelerometer: Arc<Table>) -> Result<Self, InputError> {
        let [mine, theirs] = [step(&gyro)?, step(&accelerometer)?];
        // Clocks of one rate differ by their jitter.
        let gyro_kept = mine <= 1.01 * theirs;
        Ok(if gyro_kept {
            Self { kept: gyro, interpolated: accelerometer, gyro_kept, steps: [mine, theirs] }
        } else {
            Self { kept: accelerometer, interpolated: gyro, gyro_kept, steps: [theirs, mine] }
        })
    }

    /// Its rows from the first one.
    pub fn reader(&self) -> Result<Merging, InputError> {
        Ok(Merging {
            kept: self.kept.reader()?,
            other: self.interpolated.reader()?,
            other_name: self.interpolated.name.clone(),
            gyro_kept: self.gyro_kept,
            longest: GAP * self.steps[1],
            near: VecDeque::new(),
            ended: false,
            held: None,
        })
    }
}

/// The usual step of a table, in the unit of its times.
fn step(table: &Arc<Table>) -> Result<f64, InputError> {
    let mut reader = table.reader()?;
    let (mut steps, mut before) = (Vec::new(), None);
    while let Some(row) = reader.next(false)?.filter(|_| steps.len() < LOOK) {
        let Ok(row) = row else { continue };
        if let Some(before) = before.replace(row.stamp) {
            steps.push(row.stamp - before);
        }
    }
    steps.retain(|&step| step > 0.0);
    steps.sort_unstable_by(f64::total_cmp);
    steps.get(steps.len() / 2).copied().ok_or_else(|| {
        let complaint = Complaint::new("has no two readings in the order of time", "two or more");
        InputError::file(&table.name, complaint)
    })
}

/// Goes along two tables.
#[derive(Debug)]
pub struct Merging {
    kept: Reader,
    other: Reader,
    other_name: String,
    gyro_kept: bool,
    longest: f64,
    /// Readings of the other sensor about the row at hand: times and values.
    near: VecDeque<(f64, [f64; 3])>,
    ended: bool,
    held: Option<Taken>,
}

impl Merging {
    /// The next row for which there is a reading of both. Rows before the first and after the last reading of
    /// the other sensor are left out.
    pub fn next(&mut self, whole: bool) -> Result<Option<Result<Taken, Unread>>, InputError> {
        loop {
            let row = match self.held.take() {
                Some(row) => row,
                None => match self.kept.next(whole)? {
                    None => return Ok(None),
                    Some(Err(unread)) => return Ok(Some(Err(unread))),
                    Some(Ok(row)) => row,
                },
            };
            if let Some(unread) = self.approach(row.stamp)? {
                self.held = Some(row);
                return Ok(Some(Err(unread)));
            }
            let passed = self.near.iter().take_while(|(at, _)| *at <= row.stamp).count();
            let exact = passed > 0 && self.near[passed - 1].0 == row.stamp;
            if passed == 0 {
                continue;
            }
            if passed == self.near.len() && !exact {
                // The other sensor has ended.
                return Ok(None);
            }
            if !exact && self.near[passed].0 - self.near[passed - 1].0 > self.longest {
                let what = format!("{} has no reading about this time", self.other_name);
                let accepted = "readings of both sensors, without gaps";
                let error =
                    InputError::line(self.kept.name(), row.line, Complaint::new(what, accepted));
                let stamp = Some(row.stamp);
                return Ok(Some(Err(Unread { stamp, error: Box::new(error) })));
            }
            let nodes = passed.saturating_sub(2)..(passed + 2).min(self.near.len());
            let between = interpolated(self.near.range(nodes), row.stamp);
            let [a, b, c, ..] = row.values;
            let [u, v, w] = between;
            let values = if self.gyro_kept { [a, b, c, u, v, w] } else { [u, v, w, a, b, c] };
            return Ok(Some(Ok(Taken { values, ..row })));
        }
    }

    /// Reads the other sensor up to two readings after a time, and forgets all but two before it.
    fn approach(&mut self, stamp: f64) -> Result<Option<Unread>, InputError> {
        loop {
            while self.near.get(2).is_some_and(|(at, _)| *at <= stamp) {
                self.near.pop_front();
            }
            let after = self.near.iter().rev().take_while(|(at, _)| *at > stamp).count();
            if self.ended || after >= 2 {
                return Ok(None);
            }
            match self.other.next(true)? {
                None => self.ended = true,
                Some(Err(unread)) => return Ok(Some(Unread { stamp: Some(stamp), ..unread })),
                Some(Ok(row)) => {
                    let [x, y, z, ..] = row.values;
                    // What does not come later than the one before is no reading of its own.
                    if self.near.back().is_none_or(|(at, _)| *at < row.stamp) {
                        self.near.push_back((row.stamp, [x, y, z]));
                    }
                }
            }
        }
    }
}

/// Lagrange's polynomial through some readings, at a time.
fn interpolated<'a>(
    nodes: impl Iterator<Item = &'a (f64, [f64; 3])> + Clone,
    stamp: f64,
) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for (j, (at, values)) in nodes.clone().enumerate() {
        // ℓⱼ(t) = Π (t − tₖ)/(tⱼ − tₖ)
        let others = nodes.clone().enumerate().filter(|(k, _)| *k != j);
        let basis: f64 = others.map(|(_, (other, _))| (stamp - other) / (at - other)).product();
        sum.iter_mut().zip(values).for_each(|(sum, value)| *sum += basis * value);
    }
    sum
}
