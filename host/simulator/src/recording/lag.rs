//! The lag of a reference: how much later than what happened its stamps are.
//!
//! A wrong time shows as a position, a velocity and an attitude that are off by their rates times the lag. A
//! navigator's drift is slow: within a minute it is a parabola. What a parabola takes away of each component
//! in each minute is not the lag's; the lag is the one that leaves least of the rest. A motion that is as slow
//! as the drift tells none.

use super::reference::Reference;
use super::track::Track;
use schuler::drift::compare::{Drift, drift};
use schuler::solution::Solution;

/// A lag and how well it is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lag {
    /// s; positive where stamps are late.
    pub lag_s: f64,
    /// Standard deviation, s, by the scatter of what is left. Errors that come and go with the motion itself,
    /// as those of a bias in a body that turns, are not in it.
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
/// Within such a time a drift is a parabola, s.
const WINDOW_S: f64 = 60.0;
/// Rows of such a window, at least: it is longer where rows are rare.
const WINDOW_ROWS: f64 = 16.0;
/// Errors that are no further apart may be alike, s.
const ALIKE_S: f64 = 20.0;
/// Passes of the fit: each leaves the square of the error before.
const PASSES: usize = 3;
/// A lag that is less well known is none, s.
const WORST_S: f64 = 0.5;
/// How far the fit may lead from what the search has found, s.
const FARTHEST_S: f64 = 0.5;
/// Rates are taken over twice this time, s.
const HALF_S: f64 = 0.01;
/// Of a reference, whose rows may scatter, over twice this time or from row to row.
const OWN_S: f64 = 0.2;
/// What moves less is at rest: of position, m/s, of velocity, m/s², and of attitude, rad/s.
const LEAST_RATE: [f64; 3] = [1e-4, 1e-5, 1e-7];
/// Rates that are less alike than this, or than chance may make so many, are not those of the same motion.
const ALIKE: f64 = 0.1;
const CHANCE: f64 = 5.0;

type Row = [f64; 9];

/// The lag of a reference against a track; none where the motion does not tell.
pub fn of(track: &Track, reference: &Reference) -> Option<Lag> {
    let [first_s, last_s] = track.span_s()?;
    let rows = &reference.rows;
    let inside = |margin_s: f64| -> Vec<(f64, Solution<f64>)> {
        let is_in = |time_s: f64| time_s > first_s + margin_s && time_s < last_s - margin_s;
        rows.iter().filter(|(time_s, _)| is_in(*time_s)).copied().collect()
    };
    let reach_s = MOST_S.min(0.4 * (last_s - first_s));
    let coarse = search(track, &inside(reach_s), reach_s)?;
    let rows = inside(coarse.abs() + STEP_S);
    let lag = fit(track, &rows, coarse)?;
    (lag.sigma_s < WORST_S).then_some(lag)
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
fn fit(track: &Track, rows: &[(f64, Solution<f64>)], guess_s: f64) -> Option<Lag> {
    let [(first_s, _), .., (last_s, _)] = rows else { return None };
    // Each with others on both sides, from which the reference's own rates are.
    let mean_s = (last_s - first_s) / (rows.len() - 1) as f64;
    let side = (OWN_S / mean_s).ceil() as usize;
    let thinning = rows.len().div_ceil(FITTED);
    let rows: Vec<_> = rows.windows(2 * side + 1).step_by(thinning).collect();
    let mut lag = Lag { lag_s: guess_s, sigma_s: f64::INFINITY };
    for _ in 0..PASSES {
        let mut all = [Vec::new(), Vec::new(), Vec::new()];
        for row in &rows {
            let [(before_s, behind), .., (after_s, ahead)] = row else { continue };
            let Some((time_s, truth)) = row.get(side) else { continue };
            let at = time_s - lag.lag_s;
            let (Some(here), Some(before), Some(after)) =
                (track.at(at), track.at(at - HALF_S), track.at(at + HALF_S))
            else {
                continue;
            };
            let rate =
                |after, before, step_s: f64| numbers(&drift(after, before)).map(|x| x / step_s);
            let own = rate(ahead, behind, after_s - before_s);
            let computed = rate(&after, &before, 2.0 * HALF_S);
            for (all, row) in all.iter_mut().zip([numbers(&drift(&here, truth)), computed, own]) {
                all.push((*time_s, row));
            }
        }
        let count = all[0].len();
        if count < FEWEST {
            return None;
        }
        let alike = (ALIKE_S / mean_s / thinning as f64).ceil() as usize;
        let step = step(&all.map(|rows| rests(&rows)), alike.min(count / 4))?;
        lag = Lag { lag_s: lag.lag_s + step.lag_s, sigma_s: step.sigma_s };
    }
    // A fit that leaves what the search has found is none.
    ((lag.lag_s - guess_s).abs() < FARTHEST_S).then_some(lag)
}

/// What is left to add to the lag. The computed state at t − lag moves by −rate for every second of it:
/// off = rate·δ + noise. Whatever is in the computed rate is in what is off, too, so the reference's
/// own rate r, whose noise is another, weighs them: δ = Σ off·r/Σ rate·r, each component with its own variance.
fn step([off, rates, own]: &[Vec<Row>; 3], alike: usize) -> Option<Lag> {
    let count = off.len() as f64;
    let least = ALIKE.max(CHANCE / count.sqrt());
    // Over all components, each by its weight: what they say, and what scatters in it.
    let (mut weights, mut sum, mut scatter) = (0.0, 0.0, vec![0.0; off.len()]);
    for c in 0..9 {
        let dot = |a: &[Row], b: &[Row]| a.iter().zip(b).map(|(a, b)| a[c] * b[c]).sum::<f64>();
        let (computed, reference, both) = (dot(rates, rates), dot(own, own), dot(rates, own));
        let is_motion = reference > count * LEAST_RATE[c / 3].powi(2);
        // Not a number where the reference has nothing.
        if !is_motion || !both.is_finite() || both < least * (computed * reference).sqrt() {
            continue;
        }
        let delta = dot(off, own) / both;
        let parts = off.iter().zip(rates).zip(own);
        let parts: Vec<f64> = parts.map(|((o, r), own)| (o[c] - delta * r[c]) * own[c]).collect();
        // By its own variance, spread/both².
        let weight = both / spread(&parts, alike).max(f64::MIN_POSITIVE);
        weights += weight * both;
        sum += weight * both * delta;
        scatter.iter_mut().zip(&parts).for_each(|(scatter, part)| *scatter += weight * part);
    }
    // What is off in one component is off in others, too: the variance is that of all together.
    let sigma_s = spread(&scatter, alike).max(0.0).sqrt() / weights;
    (weights > 0.0).then(|| Lag { lag_s: sum / weights, sigma_s })
}

/// The variance of a sum whose parts may be like their neighbours, as far as so many away: Σ_j w_j Σ_k s_k s_(k+j)
/// with w_j falling to zero along a straight line (Newey and West 1987), which is never negative.
fn spread(parts: &[f64], alike: usize) -> f64 {
    let with = |j: usize| parts.iter().zip(parts.iter().skip(j)).map(|(a, b)| a * b).sum::<f64>();
    let weight = |j: usize| 2.0 * (1.0 - j as f64 / (alike + 1) as f64);
    with(0) + (1..=alike).map(|j| weight(j) * with(j)).sum::<f64>()
}

/// What a parabola over time leaves of each component, window by window; nothing of windows with few rows.
fn rests(rows: &[(f64, Row)]) -> Vec<Row> {
    let [(first_s, _), .., (last_s, _)] = rows else { return vec![[0.0; 9]; rows.len()] };
    let mean_s = (last_s - first_s) / (rows.len() - 1) as f64;
    let window_s = WINDOW_S.max(WINDOW_ROWS * mean_s);
    let window = |time_s: f64| ((time_s - first_s) / window_s) as u64;
    rows.chunk_by(|a, b| window(a.0) == window(b.0)).flat_map(rest_of_parabola).collect()
}

/// The same of one window.
fn rest_of_parabola(rows: &[(f64, Row)]) -> Vec<Row> {
    let (first_s, last_s) = match rows {
        [(first_s, _), .., (last_s, _)] if 2 * rows.len() > WINDOW_ROWS as usize => {
            (*first_s, *last_s)
        }
        _ => return vec![[0.0; 9]; rows.len()],
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
        for c in 0..9 {
            let share = rests.iter().zip(&next).map(|(row, n)| row[c] * n).sum::<f64>() / norm;
            rests.iter_mut().zip(&next).for_each(|(row, n)| row[c] -= share * n);
        }
        basis.push(next);
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
