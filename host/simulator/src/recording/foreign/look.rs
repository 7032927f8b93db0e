//! A look at the first rows of a recording: means of pieces of about a second.

use super::super::Kind;
use super::parts::Parts;
use crate::input::InputError;
use schuler::alignment::units::{ForceUnit, RateUnit};
use schuler::math::vector::Vector;

/// Rows that are looked at.
const ROWS: usize = 8192;
/// Fewest pieces that they are cut into.
const PIECES: usize = 4;
/// The usual size of gravity, m/s², and how far from it a mean may be: places on the Earth differ by 0.5 %.
const GRAVITY: f64 = 9.80;
const FIT: f64 = 0.03;
/// A direction stays within acos of this, 3°.
const STAYS: f64 = 0.9986;

/// What the first rows show, in the units of the file.
#[derive(Clone, Debug, PartialEq)]
pub struct Look {
    /// The usual step of time, in the unit of the stamps.
    pub step: f64,
    /// Means of gyros and accelerometers over pieces of about a second.
    pub pieces: Vec<[Vector<f64>; 2]>,
    /// The greatest reading of a gyro.
    pub peak: f64,
    /// How much readings of gyros scatter from one to the next, rms of their size.
    pub scatter: f64,
}

/// A unit and a kind that make gravity of accelerometers.
pub type ForceGuess = (ForceUnit, Kind);

impl Look {
    /// At the rows of files; none where there are not enough to tell anything.
    pub fn at(parts: &Parts) -> Result<Option<Self>, InputError> {
        let mut reader = parts.reader()?;
        let (mut rows, mut unread) = (Vec::new(), None);
        while let Some(row) = reader.next(true)?.filter(|_| rows.len() < ROWS) {
            match row {
                Ok(row) => rows.push((row.stamp, row.values)),
                Err(row) => unread = unread.or(Some(*row.error)),
            }
        }
        match unread.filter(|_| rows.is_empty()) {
            Some(error) => Err(error),
            None => Ok(Self::of(&rows)),
        }
    }

    /// Of times and numbers.
    pub fn of(rows: &[(f64, [f64; 6])]) -> Option<Self> {
        let mut steps: Vec<_> = rows.windows(2).map(|pair| pair[1].0 - pair[0].0).collect();
        steps.retain(|&step| step > 0.0);
        steps.sort_unstable_by(f64::total_cmp);
        let step = steps.get(steps.len() / 2).copied()?;
        let length = ((1.0 / (step * likely_unit(step))).round() as usize).max(1);
        let length = length.min(rows.len() / PIECES).max(1);
        let mean = |piece: &[(f64, [f64; 6])]| {
            let mut sums = [Vector::ZERO; 2];
            for (_, [a, b, c, u, v, w]) in piece {
                sums[0] = sums[0] + Vector::new(*a, *b, *c);
                sums[1] = sums[1] + Vector::new(*u, *v, *w);
            }
            sums.map(|sum| sum * (1.0 / piece.len() as f64))
        };
        let pieces: Vec<_> = rows.chunks_exact(length).map(mean).collect();
        let readings = rows.iter().flat_map(|(_, values)| &values[..3]);
        let peak = readings.fold(0.0, |peak: f64, value| peak.max(value.abs()));
        let scatter = scatter(rows);
        (!pieces.is_empty()).then_some(Self { step, pieces, peak, scatter })
    }

    /// The usual size of accelerometers' means, in their unit.
    pub fn force(&self) -> f64 {
        middle(self.pieces.iter().map(|[_, force]| force.norm()).collect())
    }

    /// The direction of accelerometers' mean.
    pub fn direction(&self) -> Vector<f64> {
        let sum = self.pieces.iter().fold(Vector::ZERO, |sum, [_, force]| sum + *force);
        sum * (1.0 / sum.norm())
    }

    /// The mean of gyros across the direction of accelerometers, in their unit, if that direction stays: what turned
    /// them like this would turn it.
    pub fn across(&self) -> Option<f64> {
        let up = self.direction();
        let stays = |[_, force]: &[Vector<f64>; 2]| force.dot(up) > STAYS * force.norm();
        let sum = self.pieces.iter().fold(Vector::ZERO, |sum, [rate, _]| sum + *rate);
        let mean = sum * (1.0 / self.pieces.len() as f64);
        self.pieces.iter().all(stays).then(|| (mean - up * mean.dot(up)).norm())
    }

    /// The usual size of gyros' means, in their unit.
    pub fn rate(&self) -> f64 {
        middle(self.pieces.iter().map(|[rate, _]| rate.norm()).collect())
    }

    /// Of units of accelerometers and kinds of samples, those that make gravity of the readings. Steps are `h` long, s.
    pub fn gravity(&self, h: f64, guesses: &[ForceGuess]) -> Vec<ForceGuess> {
        let fits = |(unit, kind): &ForceGuess| {
            let per_second = if *kind == Kind::Increments { h } else { 1.0 };
            let off = self.force() * unit.si() / per_second / GRAVITY - 1.0;
            off.abs() < FIT
        };
        guesses.iter().filter(|guess| fits(guess)).copied().collect()
    }

    /// Whether gyros read one rate all along, up to a part of it.
    pub fn steady(&self, part: f64) -> bool {
        let sum = self.pieces.iter().fold(Vector::ZERO, |sum, [rate, _]| sum + *rate);
        let mean = sum * (1.0 / self.pieces.len() as f64);
        self.pieces.iter().all(|[rate, _]| (*rate - mean).norm() < part * mean.norm())
    }

    /// The size of a rate in a unit, rad/s.
    pub fn rate_in(&self, rate: f64, unit: RateUnit, kind: Kind, h: f64) -> f64 {
        rate * unit.si() / if kind == Kind::Increments { h } else { 1.0 }
    }
}

/// Seconds in the unit that a usual step looks to have: seconds where samples are then no longer than one.
pub fn likely_unit(step: f64) -> f64 {
    [1.0, 1e-3, 1e-6, 1e-9].into_iter().find(|unit_s| step * unit_s <= 1.0).unwrap_or(1e-9)
}

/// Second differences of noise have √6 times its size.
fn scatter(rows: &[(f64, [f64; 6])]) -> f64 {
    let second = |window: &[(f64, [f64; 6])]| -> f64 {
        let [(_, a), (_, b), (_, c)] = window else { return 0.0 };
        (0..3).map(|i| (a[i] - 2.0 * b[i] + c[i]).powi(2)).sum()
    };
    let sum: f64 = rows.windows(3).map(second).sum();
    (sum / 6.0 / rows.len().max(1) as f64).sqrt()
}

fn middle(mut values: Vec<f64>) -> f64 {
    values.sort_unstable_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}
