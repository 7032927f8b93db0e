//! The lag of a reference: how much later than what happened its stamps are.
//!
//! A wrong time shows as a position, a velocity and an attitude that are off by their rates times the lag. A
//! navigator's drift is slow: what a parabola over the whole comparison takes away of each component, or
//! what its differences from row to row leave, is not the lag's. The lag is the one that leaves least.

use super::reference::Reference;
use super::track::Track;
use schuler::drift::compare::{Drift, drift};
use schuler::solution::Solution;

/// A lag and how well it is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lag {
    /// s; positive where stamps are late.
    pub lag_s: f64,
    /// Standard deviation, s, by the scatter of what is left.
    pub sigma_s: f64,
}

/// Lags that are looked for, s.
const MOST_S: f64 = 30.0;
/// Step of the search, s.
const STEP_S: f64 = 0.05;
/// Rows that the search looks at, about; the lag itself is found from more.
const SEARCHED: usize = 400;
const FITTED: usize = 5_000;
/// Fewer rows tell no lag.
const FEWEST: usize = 12;
/// Passes of the fit: each leaves the square of the error before.
const PASSES: usize = 3;
/// A lag that is less well known is none, s.
const WORST_S: f64 = 1.0;

type Row = [f64; 9];

/// The lag of a reference against a track; none where the motion does not tell.
pub fn of(track: &Track, reference: &Reference) -> Option<Lag> {
    let [first_s, last_s] = track.span_s()?;
    let rows = &reference.rows;
    let inside = |margin_s: f64| -> Vec<(f64, Solution<f64>)> {
        let is_in = |time_s: f64| time_s > first_s + margin_s && time_s < last_s - margin_s;
        rows.iter().filter(|(time_s, _)| is_in(*time_s)).copied().collect()
    };
    let reach_s = MOST_S.min((last_s - first_s) / 4.0);
    let coarse = search(track, &inside(reach_s), reach_s)?;
    let rows = inside(coarse.abs() + STEP_S);
    [false, true]
        .into_iter()
        .filter_map(|by_differences| fit(track, &rows, coarse, by_differences))
        .filter(|lag| lag.sigma_s < WORST_S)
        .min_by(|a, b| a.sigma_s.total_cmp(&b.sigma_s))
}

/// Every so many rows.
fn thinned(
    rows: &[(f64, Solution<f64>)],
    most: usize,
) -> impl Iterator<Item = &(f64, Solution<f64>)> {
    rows.iter().step_by(rows.len().div_ceil(most).max(1))
}

/// The lag that leaves least, to the step of the search, s.
fn search(track: &Track, rows: &[(f64, Solution<f64>)], reach_s: f64) -> Option<f64> {
    let rows: Vec<_> = thinned(rows, SEARCHED).collect();
    if rows.len() < FEWEST {
        return None;
    }
    let steps = (reach_s / STEP_S) as i64;
    let cost = |lag_s: f64| {
        let off = rows.iter().map(|(time_s, truth)| {
            let (state, ahead_s) = track.near(time_s - lag_s)?;
            let mut off = numbers(&drift(state, truth));
            let speed = state.velocity_ned.map(|v| v.hi).into_array();
            off.iter_mut().zip(speed).for_each(|(off, speed)| *off += speed * ahead_s);
            Some((*time_s, off))
        });
        let off: Option<Vec<_>> = off.collect();
        off.map(|off| misfit(&off))
    };
    let costs = (-steps..=steps).filter_map(|k| Some((k, cost(k as f64 * STEP_S)?)));
    let best = costs.min_by(|a, b| a.1.total_cmp(&b.1))?;
    Some(best.0 as f64 * STEP_S)
}

/// How much is left in all components, each by its own measure: Σ log of the mean square.
fn misfit(off: &[(f64, Row)]) -> f64 {
    let rests = rests(off);
    let square =
        |c: usize| rests.iter().map(|row| row[c] * row[c]).sum::<f64>() / rests.len() as f64;
    let logs = (0..9).map(square).filter(|square| square.is_finite()).map(|s| s.max(1e-300).ln());
    logs.sum()
}

/// The fit about a first guess.
fn fit(
    track: &Track,
    rows: &[(f64, Solution<f64>)],
    guess_s: f64,
    by_differences: bool,
) -> Option<Lag> {
    let rows: Vec<_> = thinned(rows, FITTED).collect();
    let mut lag = Lag { lag_s: guess_s, sigma_s: f64::INFINITY };
    for _ in 0..PASSES {
        let mut off = Vec::with_capacity(rows.len());
        let mut rates = Vec::with_capacity(rows.len());
        for (time_s, truth) in &rows {
            let at = time_s - lag.lag_s;
            let half_s = 1e-3;
            let (Some(here), Some(before), Some(after)) =
                (track.at(at), track.at(at - half_s), track.at(at + half_s))
            else {
                continue;
            };
            off.push((*time_s, numbers(&drift(&here, truth))));
            let step = numbers(&drift(&after, &before));
            rates.push((*time_s, step.map(|step| step / (2.0 * half_s))));
        }
        if by_differences {
            (off, rates) = (differences(&off), differences(&rates));
        }
        if off.len() < FEWEST {
            return None;
        }
        let step = step(&rests(&off), &rests(&rates))?;
        lag = Lag { lag_s: lag.lag_s + step.lag_s, sigma_s: step.sigma_s };
    }
    lag.lag_s.is_finite().then_some(lag)
}

/// What is left to add to the lag: the computed state at t − lag moves by −rate for every second of it, so
/// that off = rate·δ + noise, each component with its own.
fn step(off: &[Row], rates: &[Row]) -> Option<Lag> {
    let count = off.len() as f64;
    let (mut normal, mut right, mut variance) = (0.0, 0.0, 0.0);
    for c in 0..9 {
        let sum = |f: &dyn Fn(&Row, &Row) -> f64| {
            off.iter().zip(rates).map(|(o, r)| f(o, r)).sum::<f64>()
        };
        let (square, cross) = (sum(&|_, r| r[c] * r[c]), sum(&|o, r| o[c] * r[c]));
        if !square.is_finite() || !cross.is_finite() || square <= 0.0 {
            continue;
        }
        let own = cross / square;
        let rest = |o: &Row, r: &Row| o[c] - own * r[c];
        let noise = sum(&|o, r| rest(o, r).powi(2)) / count;
        // Neighbours that are alike tell less than their number says.
        let pairs = off.windows(2).zip(rates.windows(2));
        let alike: f64 = pairs.map(|(o, r)| rest(&o[0], &r[0]) * rest(&o[1], &r[1])).sum();
        let alike = (alike / count / noise).clamp(0.0, 0.999_999);
        let noise = noise.max(1e-300);
        normal += square / noise;
        right += cross / noise;
        variance += square / noise * (1.0 + alike) / (1.0 - alike);
    }
    (normal > 0.0).then(|| Lag { lag_s: right / normal, sigma_s: variance.sqrt() / normal })
}

/// From row to row.
fn differences(rows: &[(f64, Row)]) -> Vec<(f64, Row)> {
    let step = |pair: &[(f64, Row)]| match pair {
        [(_, a), (t, b)] => (*t, std::array::from_fn(|c| b[c] - a[c])),
        _ => (0.0, [0.0; 9]),
    };
    rows.windows(2).map(step).collect()
}

/// What a parabola over time leaves of each component.
fn rests(rows: &[(f64, Row)]) -> Vec<Row> {
    let (first_s, last_s) = match rows {
        [(first, _), .., (last, _)] => (*first, *last),
        _ => return rows.iter().map(|(_, row)| *row).collect(),
    };
    let x = |t: f64| (2.0 * t - first_s - last_s) / (last_s - first_s);
    let mut rests: Vec<Row> = rows.iter().map(|(_, row)| *row).collect();
    // Orthogonal polynomials over the rows themselves, one after another.
    let mut basis: Vec<Vec<f64>> = Vec::new();
    for power in 0..3 {
        let mut next: Vec<f64> = rows.iter().map(|(t, _)| x(*t).powi(power)).collect();
        for earlier in &basis {
            let share = dot(&next, earlier) / dot(earlier, earlier);
            next.iter_mut().zip(earlier).for_each(|(n, e)| *n -= share * e);
        }
        let norm = dot(&next, &next);
        if norm > 1e-12 {
            for c in 0..9 {
                let share = rests.iter().zip(&next).map(|(row, n)| row[c] * n).sum::<f64>() / norm;
                rests.iter_mut().zip(&next).for_each(|(row, n)| row[c] -= share * n);
            }
            basis.push(next);
        }
    }
    rests
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn numbers(drift: &Drift) -> Row {
    let parts =
        [drift.position_ned, drift.velocity_ned, drift.attitude_ned].map(|v| v.into_array());
    std::array::from_fn(|i| parts[i / 3][i % 3])
}
