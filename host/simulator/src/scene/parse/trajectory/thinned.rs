//! Logs denser than their motion: a path through some rows that meets all of them to their rounding.
//!
//! Rows a hundredth of a second apart hold the motion and the rounding of their numbers. A path through every
//! one would follow the rounding, with a vibration at half the rows' rate that no sampling resolves.

use super::through::pieces;
use schuler::earth::SEMI_MAJOR_AXIS;
use schuler::trajectory::log::{Log, Noise};
use schuler::trajectory::piecewise::piece::Piece;

/// Every so many rows, the fewest first.
const STRIDES: [usize; 4] = [16, 8, 4, 2];
/// Rows that a path is made of at least.
const FEWEST: usize = 16;
/// A row is met within some roundings of its coordinates, m, and within 4e-7″ of its attitude, as a unit quaternion.
const MET_M: f64 = 8e-9;
const MET_TURN: f64 = 1e-12;

/// The pieces of a path through the fewest rows, evenly chosen, that meets all; `None` where it takes every row, where
/// there is noise, and where rows are further apart than they may be.
pub fn pieces_of(rows: &Log<'_>) -> Option<Vec<Piece<8>>> {
    let is_whole = rows.times_s.windows(2).all(|two| two[1] - two[0] <= rows.max_gap_s);
    if rows.noise != Noise::NONE || !is_whole {
        return None;
    }
    STRIDES.into_iter().find_map(|stride| every(rows, stride))
}

/// The path through every so many rows, if it meets the others.
fn every(rows: &Log<'_>, stride: usize) -> Option<Vec<Piece<8>>> {
    let count = rows.times_s.len();
    if count / stride < FEWEST {
        return None;
    }
    let last = count - 1;
    let chosen = || (0..last).step_by(stride).chain([last]);
    let times_s: Vec<_> = chosen().map(|n| rows.times_s[n]).collect();
    let positions: Vec<_> = chosen().map(|n| rows.positions[n]).collect();
    let attitudes: Option<Vec<_>> = rows.attitudes.map(|all| chosen().map(|n| all[n]).collect());
    let fewer = Log {
        times_s: &times_s,
        positions: &positions,
        attitudes: attitudes.as_deref(),
        max_gap_s: f64::MAX,
        ..*rows
    };
    let (pieces, _) = pieces(&fewer).ok()?;
    let mut at = 0;
    let is_met = (0..count).all(|n| {
        let time_s = rows.times_s[n];
        while at + 1 < pieces.len() && pieces[at].end_s < time_s {
            at += 1;
        }
        let is_near = |first: usize, row: &[f64; 4], bounds: [f64; 4]| {
            (0..4).all(|i| (pieces[at].channel(first + i, time_s) - row[i]).abs() <= bounds[i])
        };
        let level = MET_M / SEMI_MAJOR_AXIS;
        is_near(0, &rows.positions[n], [level, level, level, MET_M])
            && rows.attitudes.is_none_or(|all| is_near(4, &all[n], [MET_TURN; 4]))
    });
    is_met.then_some(pieces)
}
