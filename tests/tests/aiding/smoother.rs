//! What a witness is shown is what a smoother needs: by Rauch, Tung and Striebel's formulas, as full matrices, the drive
//! is as good as theory says of all its measurements.

use super::dense::{self, Matrix, N};
use super::drive::{OUTAGE, RATE_HZ, heard, receiver, run, settings, truth};
use super::figures::quadratic;
use schuler::aiding::aided::navigator::Aided15;
use schuler::aiding::aided::verdict::{Step, Witness};
use schuler::aiding::covariance::ud::Ud;
use schuler::drift::compare::drift;
use schuler::prelude::*;
use schuler::units::DEGREE;

/// A step with the corrections at its end.
struct Past {
    samples: u64,
    transition: Matrix,
    before: Matrix,
    after: Matrix,
    corrections: [f64; N],
}

struct Recorder(Vec<Past>);

fn full(ud: &Ud<f64, N, 120>) -> Matrix {
    (0..N).map(|i| core::array::from_fn(|j| ud.covariance(i, j))).collect()
}

impl Witness<f64, N, 120, 0> for Recorder {
    fn stepped(&mut self, step: &Step<'_, f64, N, 120, 0>) {
        self.0.push(Past {
            samples: step.samples,
            transition: step.matrix().to_vec(),
            before: full(step.before),
            after: full(step.after),
            corrections: [0.0; N],
        });
    }
    fn corrected(&mut self, samples: u64, errors: &[f64; N], _: &Ud<f64, N, 120>) {
        let last = self.0.last_mut().unwrap();
        assert_eq!(last.samples, samples);
        for (sum, x) in last.corrections.iter_mut().zip(errors) {
            *sum += x;
        }
    }
}

/// Solves P·x = b for each row b, by Cholesky's factors.
fn solve(p: &Matrix, rows: &Matrix) -> Matrix {
    let mut l = dense::zero();
    for i in 0..N {
        for j in 0..=i {
            let rest = p[i][j] - (0..j).map(|k| l[i][k] * l[j][k]).sum::<f64>();
            l[i][j] = if i == j { rest.sqrt() } else { rest / l[j][j] };
        }
    }
    let one = |b: &[f64; N]| {
        let mut x = *b;
        for i in 0..N {
            x[i] = (x[i] - (0..i).map(|k| l[i][k] * x[k]).sum::<f64>()) / l[i][i];
        }
        for i in (0..N).rev() {
            x[i] = (x[i] - (i + 1..N).map(|k| l[k][i] * x[k]).sum::<f64>()) / l[i][i];
        }
        x
    };
    rows.iter().map(one).collect()
}

/// Smoothed errors and their covariance after each step but the last, latest first.
fn smoothed(steps: &[Past], last: &Matrix) -> Vec<(u64, [f64; N], Matrix)> {
    let (mut s, mut p) = ([0.0; N], last.clone());
    let mut all = Vec::new();
    for pair in steps.windows(2).rev() {
        let [earlier, step] = pair else { unreachable!() };
        // A = P⁺Φᵀ(P⁻)⁻¹,  s = A(c + s₁),  P = P⁺ + A(P₁ − P⁻)Aᵀ
        let row = |plus: &[f64; N]| {
            core::array::from_fn(|j| plus.iter().zip(step.transition[j]).map(|(p, f)| p * f).sum())
        };
        let across: Matrix = step.before.iter().map(row).collect();
        let gain = solve(&step.after, &across);
        let whole: [f64; N] = core::array::from_fn(|n| step.corrections[n] + s[n]);
        s = core::array::from_fn(|i| gain[i].iter().zip(whole).map(|(a, x)| a * x).sum());
        let mut change = p;
        for (row, minus) in change.iter_mut().zip(&step.after) {
            for (x, y) in row.iter_mut().zip(minus) {
                *x -= y;
            }
        }
        let mapped = dense::mapped(&gain, &change);
        p = step.before.clone();
        for (row, plus) in p.iter_mut().zip(&mapped) {
            for (x, y) in row.iter_mut().zip(plus) {
                *x += y;
            }
        }
        all.push((earlier.samples, s, p.clone()));
    }
    all
}

#[test]
fn a_smoother_knows_what_all_measurements_say() {
    let truth = truth(600.0);
    let heading = 2.0 * DEGREE;
    let (mut claimed, mut errors, mut worst, mut nees, mut count) = (0.0, 0.0, 0.0_f64, 0.0, 0.0);
    for number in 0..3 {
        let run = run(&truth, number, heading);
        let navigator = Navigator4::<f64>::from_rate_hz(RATE_HZ).unwrap();
        let aided = Aided15::new(navigator, Pair::of(0.01), settings(heading)).unwrap();
        let mut state = aided.start(&run.start).unwrap();
        let mut recorder = Recorder(Vec::new());
        let heard = heard::<f64>(&receiver(), &run, &truth);
        let mut fixes = heard.iter().peekable();
        let mut drifts = std::collections::BTreeMap::new();
        for (k, sample) in (1_u64..).zip(&run.samples) {
            while let Some((_, fix)) = fixes.next_if(|(_, fix)| fix.at.samples == k) {
                aided.measure(&mut state, fix).unwrap();
            }
            aided.push_seen(&mut state, *sample, &mut recorder).unwrap();
            if state.integrated() == k {
                drifts.insert(k, drift(&aided.solution(&state), &truth.solutions[k as usize]));
            }
        }
        let last = full(state.filter().covariance());
        for (samples, s, p) in smoothed(&recorder.0, &last) {
            let second = samples as f64 / RATE_HZ;
            let variance: f64 = (0..3).map(|n| p[n][n]).sum();
            if second > OUTAGE[0] && second <= OUTAGE[1] {
                worst = worst.max(variance.sqrt());
            }
            if !(120.0..=400.0).contains(&second) || samples % 100 != 0 {
                continue;
            }
            // Errors are in body axes, computed less true.
            let matrix = truth.solutions[samples as usize].attitude.map(|c| c.hi).matrix(1.0);
            let drift = matrix.transpose() * drifts[&samples].position_ned;
            let rest = drift - Vector::new(s[0], s[1], s[2]);
            claimed += variance;
            errors += rest.dot(rest);
            count += 1.0;
            if samples % 2000 == 0 {
                let part = [0, 1, 2].map(|i| [0, 1, 2].map(|j| p[i][j]));
                nees += quadratic(part, rest.into_array());
            }
        }
    }
    let [claimed, errors] = [claimed, errors].map(|sum: f64| (sum / count).sqrt());
    assert!((claimed / 0.213 - 1.0).abs() < 0.05, "{claimed} m");
    assert!((worst / 0.42 - 1.0).abs() < 0.1, "{worst} m");
    assert!((errors / claimed - 1.0).abs() < 0.15, "{errors} m for {claimed} m");
    // 45 instants of three degrees: 0.7 and 1.36 at 99.5 %.
    let mean = nees / 135.0;
    assert!((0.7..1.36).contains(&mean), "{mean}");
}
