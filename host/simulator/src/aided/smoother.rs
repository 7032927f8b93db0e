//! A smoother: what all measurements, also those that came later, say of the errors at the end of each of a filter's
//! steps (Rauch, Tung, Striebel 1965), in the coordinates of a filter that feeds its errors back.
//!
//! ```text
//! A = P⁺Φᵀ(P₁⁻)⁻¹,  s = A(c₁ + s₁),  P = P⁺ + A(P₁ − P₁⁻)Aᵀ
//! ```
//!
//! P⁺ is the covariance at a step's beginning, P₁⁻ that at its end, c₁ the corrections made there, s₁ and P₁ what is smoothed
//! there. The steps are kept in memory, about [`STEP_BYTES`] each.

use super::report::Compared;
use crate::input::Complaint;
use crate::quadratic::quadratic;
use schuler::aiding::aided::verdict::Step;
use schuler::drift::compare::{Drift, drift};
use schuler::math::real::Scalar;
use schuler::math::vector::Vector;
use schuler::solution::Solution;

/// What a step takes at most, bytes: two covariances of 21 states, a transition, the state.
pub const STEP_BYTES: u64 = 8 * (2 * 231 + 9 * 21 + 21 + 21 + 81 + 40);
/// What all of them may take, bytes.
pub const MOST_BYTES: u64 = 4 << 30;
/// The usual step, s.
pub const STEP_S: f64 = 0.1;
/// States of the motion.
const MOTION: usize = 9;

/// Refuses a flight whose steps would take too much memory.
pub fn check(duration_s: f64, step_s: f64, measurements: usize) -> Result<(), Complaint> {
    // A measurement may end a step.
    let steps = duration_s / step_s + measurements as f64;
    let bytes = steps * STEP_BYTES as f64;
    if bytes <= MOST_BYTES as f64 {
        return Ok(());
    }
    let gigabytes = |bytes: f64| bytes / f64::from(1 << 30);
    let what = format!("takes {:.1} GiB of memory for {steps:.0} steps", gigabytes(bytes));
    let accepted = format!("a flight that takes {} GiB at most", gigabytes(MOST_BYTES as f64));
    Err(Complaint::new(what, accepted))
}

/// A step with the corrections at its end.
#[derive(Clone, Debug)]
struct Past {
    samples: u64,
    /// Φ by rows.
    transition: Vec<f64>,
    /// P⁺ at its beginning and P⁻ at its end, their lower triangles by rows.
    before: Vec<f64>,
    after: Vec<f64>,
    corrections: Vec<f64>,
    state: Option<State>,
}

/// The state after a step, and the rows that make its drift from its errors.
#[derive(Clone, Debug)]
struct State {
    solution: Solution<f64>,
    rows: [[f64; MOTION]; MOTION],
}

/// A smoothed state.
#[derive(Clone, Debug)]
pub struct Smoothed {
    /// Samples until it.
    pub samples: u64,
    /// What was filtered.
    pub filtered: Solution<f64>,
    /// What is smoothed.
    pub solution: Solution<f64>,
    /// The covariance of its drift: position, velocity, attitude, each north, east, down; m, m/s, rad.
    pub covariance: [[f64; MOTION]; MOTION],
}

/// Compares smoothed states with the truth, which is a function of samples; `None` without any.
pub fn compared(
    smoothed: &[Smoothed],
    rate_hz: f64,
    truth: impl Fn(u64) -> Solution<f64>,
) -> Option<Compared> {
    let (first, last) = (smoothed.first()?, smoothed.last()?);
    let mut sum = Compared::default();
    for Smoothed { samples, filtered, solution, covariance } in smoothed {
        let truth = truth(*samples);
        let (off, before) = (drift(solution, &truth), drift(filtered, &truth));
        let square = |v: Vector<f64>| v.dot(v);
        sum.position_m[0] += square(off.position_ned);
        sum.position_m[1] += square(before.position_ned);
        sum.velocity_m_s += square(off.velocity_ned);
        sum.attitude_rad += square(off.attitude_ned);
        let variance: f64 = (0..3).map(|i| covariance[i][i]).sum();
        sum.sigma_m[0] += variance;
        sum.sigma_m[1] = sum.sigma_m[1].max(variance.sqrt());
        let position = [0, 1, 2].map(|i| [0, 1, 2].map(|j| covariance[i][j]));
        sum.nees += quadratic(&position, &off.position_ned.into_array()) / 3.0;
    }
    let states = smoothed.len();
    let mean = |sum: f64| sum / states as f64;
    Some(Compared {
        span_s: [first.samples, last.samples].map(|samples| samples as f64 / rate_hz),
        states,
        position_m: sum.position_m.map(|sum| mean(sum).sqrt()),
        sigma_m: [mean(sum.sigma_m[0]).sqrt(), sum.sigma_m[1]],
        velocity_m_s: mean(sum.velocity_m_s).sqrt(),
        attitude_rad: mean(sum.attitude_rad).sqrt(),
        nees: mean(sum.nees),
    })
}

/// The steps of a filter since it last started.
#[derive(Clone, Debug, Default)]
pub struct Steps {
    states: usize,
    past: Vec<Past>,
}

impl Steps {
    /// A step.
    pub fn add<R: Scalar, const N: usize, const P: usize, const E: usize>(
        &mut self,
        step: &Step<'_, R, N, P, E>,
    ) {
        self.states = N;
        let triangle = |ud: &schuler::aiding::covariance::ud::Ud<R, N, P>| {
            let cells = (0..N).flat_map(|i| (0..=i).map(move |j| (i, j)));
            cells.map(|(i, j)| ud.covariance(i, j).widen()).collect()
        };
        self.past.push(Past {
            samples: step.samples,
            transition: step.matrix().as_flattened().iter().map(|x| x.widen()).collect(),
            before: triangle(step.before),
            after: triangle(step.after),
            corrections: vec![0.0; N],
            state: None,
        });
    }

    /// Errors that were taken off after the last step.
    pub fn correct<R: Scalar>(&mut self, errors: &[R]) {
        if let Some(last) = self.past.last_mut() {
            last.corrections.iter_mut().zip(errors).for_each(|(sum, x)| *sum += x.widen());
        }
    }

    /// The filter starts again: what it knew before is not linear in what it knows after.
    pub fn restart(&mut self) {
        self.past.clear();
    }

    /// The state after so many samples, if a step ends there.
    pub fn reach(
        &mut self,
        samples: u64,
        state: impl FnOnce() -> (Solution<f64>, [[f64; MOTION]; MOTION]),
    ) {
        if let Some(last) = self.past.last_mut().filter(|last| last.samples == samples) {
            let (solution, rows) = state();
            last.state = Some(State { solution, rows });
        }
    }

    /// Smooths them, in order of time; `end` is the covariance at the end.
    pub fn smoothed(&self, end: &[f64]) -> Vec<Smoothed> {
        let n = self.states;
        let (mut s, mut p) = (vec![0.0; n], end.to_vec());
        let mut all = Vec::new();
        let mut later: Option<&Past> = None;
        for step in self.past.iter().rev() {
            if let Some(later) = later {
                (s, p) = back(later, &s, &p, n);
            }
            // A doubt after a lockout is a step of no time: the state is that after it.
            if let Some(state) = &step.state
                && later.is_none_or(|later| later.samples > step.samples)
            {
                all.push(state.smoothed(step.samples, &s, &p));
            }
            later = Some(step);
        }
        all.reverse();
        all
    }
}

impl State {
    fn smoothed(&self, samples: u64, s: &[f64], p: &[f64]) -> Smoothed {
        let Self { solution, rows } = self;
        let drift = rows.map(|row| -row.iter().zip(s).map(|(a, x)| a * x).sum::<f64>());
        let three = |i: usize| Vector::new(drift[i], drift[i + 1], drift[i + 2]);
        let drift =
            Drift { position_ned: three(0), velocity_ned: three(3), attitude_ned: three(6) };
        let covariance = rows.map(|a| {
            rows.map(|b| {
                let along = |i: usize| (0..MOTION).map(|j| at(p, i, j) * b[j]).sum::<f64>();
                (0..MOTION).map(|i| a[i] * along(i)).sum()
            })
        });
        Smoothed { samples, filtered: *solution, solution: drift.added_to(solution), covariance }
    }
}

/// P_ij of a lower triangle by rows.
fn at(triangle: &[f64], i: usize, j: usize) -> f64 {
    let (i, j) = if i < j { (j, i) } else { (i, j) };
    triangle[i * (i + 1) / 2 + j]
}

/// From the end of a step to its beginning.
fn back(step: &Past, s: &[f64], p: &[f64], n: usize) -> (Vec<f64>, Vec<f64>) {
    let Past { transition, before, after, corrections, .. } = step;
    let lower = factor(after, n);
    // A by rows: P₁⁻·a = Φ·p, p a row of P⁺
    let gain: Vec<Vec<f64>> = (0..n)
        .map(|i| {
            let across = (0..n)
                .map(|j| (0..n).map(|k| transition[j * n + k] * at(before, i, k)).sum::<f64>());
            solve(&lower, across.collect(), n)
        })
        .collect();
    let whole: Vec<f64> = s.iter().zip(corrections).map(|(s, c)| s + c).collect();
    let s = gain.iter().map(|row| row.iter().zip(&whole).map(|(a, x)| a * x).sum());
    let change: Vec<f64> = p.iter().zip(after).map(|(p, after)| p - after).collect();
    let halves: Vec<Vec<f64>> = gain
        .iter()
        .map(|row| (0..n).map(|j| (0..n).map(|k| row[k] * at(&change, k, j)).sum()).collect())
        .collect();
    let mut p = before.clone();
    for i in 0..n {
        for j in 0..=i {
            let mapped: f64 = halves[i].iter().zip(&gain[j]).map(|(a, b)| a * b).sum();
            p[i * (i + 1) / 2 + j] += mapped;
        }
    }
    (s.collect(), p)
}

/// The covariance's Cholesky factor with the standard deviations before it: P = S·L·Lᵀ·S. A state that is known has a row of
/// zeros.
struct Factor {
    scale: Vec<f64>,
    lower: Vec<f64>,
}

fn factor(p: &[f64], n: usize) -> Factor {
    let scale: Vec<f64> = (0..n).map(|i| at(p, i, i).max(0.0).sqrt()).collect();
    let mut lower = vec![0.0; n * (n + 1) / 2];
    for i in 0..n {
        for j in 0..=i {
            if scale[i] == 0.0 || scale[j] == 0.0 {
                continue;
            }
            let rest = at(p, i, j) / (scale[i] * scale[j])
                - (0..j).map(|k| at(&lower, i, k) * at(&lower, j, k)).sum::<f64>();
            let pivot = at(&lower, j, j);
            lower[i * (i + 1) / 2 + j] = match (i == j, pivot > 0.0) {
                (true, _) => rest.max(0.0).sqrt(),
                (false, true) => rest / pivot,
                (false, false) => 0.0,
            };
        }
    }
    Factor { scale, lower }
}

/// Solves P·x = b. What is known does not change.
fn solve(Factor { scale, lower }: &Factor, b: Vec<f64>, n: usize) -> Vec<f64> {
    let over = |rest: f64, i: usize| {
        let pivot = at(lower, i, i);
        if pivot > 0.0 { rest / pivot } else { 0.0 }
    };
    let mut x = b;
    for i in 0..n {
        let known: f64 = (0..i).map(|k| at(lower, i, k) * x[k]).sum();
        x[i] = if scale[i] > 0.0 { over(x[i] / scale[i] - known, i) } else { 0.0 };
    }
    for i in (0..n).rev() {
        let known: f64 = (i + 1..n).map(|k| at(lower, k, i) * x[k]).sum();
        x[i] = over(x[i] - known, i);
    }
    x.iter_mut().zip(scale).for_each(|(x, scale)| *x = if *scale > 0.0 { *x / scale } else { 0.0 });
    x
}
