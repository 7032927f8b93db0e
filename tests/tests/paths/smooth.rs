//! Smoothing: against a dense solution, and what becomes of noise.

use super::left_of_noise;
use schuler::trajectory::spline::basis::Knots;
use schuler::trajectory::spline::local::coefficients;
use schuler::trajectory::spline::smooth::{Fit, Smoothing, Workspace, smooth};
use schuler::trajectory::spline::{BAND, EXTRA, SplineError};
use schuler_tests::Numbers;

/// Smooths one channel.
fn solve(
    sites: &[f64],
    times: &[f64],
    values: &[[f64; 1]],
    noise: f64,
) -> Result<(Smoothing, Vec<[f64; 1]>), SplineError> {
    let room = sites.len() + EXTRA;
    let (mut gram, mut factors) = (vec![[0.0; BAND]; room], vec![[0.0; BAND]; room]);
    let (mut right, mut control) = (vec![[0.0]; room], vec![[0.0]; room]);
    let workspace = Workspace { gram: &mut gram, factors: &mut factors, right: &mut right };
    let fit = Fit { sites, times_s: times, values, channels: 0..1 };
    smooth(&fit, noise, workspace, &mut control).map(|smoothing| (smoothing, control))
}

/// A function of the basis, by the definition.
fn basis(knots: &dyn Fn(usize) -> f64, j: usize, degree: usize, t: f64) -> f64 {
    if degree == 0 {
        return if knots(j) <= t && t < knots(j + 1) { 1.0 } else { 0.0 };
    }
    let (low, high) = (knots(j + degree) - knots(j), knots(j + degree + 1) - knots(j + 1));
    (t - knots(j)) / low * basis(knots, j, degree - 1, t)
        + (knots(j + degree + 1) - t) / high * basis(knots, j + 1, degree - 1, t)
}

/// Gaussian elimination with exchange of rows.
#[expect(clippy::needless_range_loop, reason = "rows and columns of one matrix")]
fn gauss(mut a: Vec<Vec<f64>>, mut b: Vec<f64>) -> Vec<f64> {
    let n = b.len();
    for k in 0..n {
        let best = (k..n).max_by(|&i, &j| a[i][k].abs().total_cmp(&a[j][k].abs())).unwrap();
        a.swap(k, best);
        b.swap(k, best);
        for i in k + 1..n {
            let factor = a[i][k] / a[k][k];
            for j in k..n {
                a[i][j] -= factor * a[k][j];
            }
            b[i] -= factor * b[k];
        }
    }
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n).map(|j| a[k][j] * b[j]).sum();
        b[k] = (b[k] - known) / a[k][k];
    }
    b
}

fn noisy(times: &[f64], noise: f64, seed: u64) -> Vec<[f64; 1]> {
    let mut numbers = Numbers(seed);
    let mut gauss = || (0..12).map(|_| numbers.within(0.5)).sum::<f64>();
    times.iter().map(|t| [5.0 + (0.7 * t).sin() + 0.3 * t + noise * gauss()]).collect()
}

#[test]
fn smoothing_is_the_dense_solution() {
    const STEP: f64 = 0.25;
    let sites: Vec<f64> = (0..25).map(|k| STEP * f64::from(k)).collect();
    // Two samples a span, none of them at a joint, and one missing stretch.
    let times: Vec<f64> =
        (0..48).filter(|k| !(20..23).contains(k)).map(|k| 0.06 + 0.124 * f64::from(k)).collect();
    let values = noisy(&times, 0.1, 4);
    let (smoothing, control) = solve(&sites, &times, &values, 0.1).unwrap();
    assert!(!smoothing.at_limit);
    let expected = left_of_noise(0.1, &times, smoothing.time_constant_s);
    assert!((smoothing.residual - expected).abs() < 1e-8, "{smoothing:?} {expected}");

    let n = sites.len() + EXTRA;
    let knots = |j: usize| STEP * (j as f64 - 7.0);
    let (mut a, mut b) = (vec![vec![0.0; n]; n], vec![0.0; n]);
    for (t, [z]) in times.iter().zip(&values) {
        let row: Vec<f64> = (0..n).map(|j| basis(&knots, j, 7, *t)).collect();
        for i in 0..n {
            b[i] += row[i] * z;
            for j in 0..n {
                a[i][j] += row[i] * row[j];
            }
        }
    }
    let between = (times[times.len() - 1] - times[0]) / (times.len() - 1) as f64;
    let lambda = smoothing.time_constant_s.powi(6) / between;
    let third = [-1.0, 3.0, -3.0, 1.0].map(|w| w / STEP.powi(3));
    for j in 0..n - 3 {
        for (k, p) in third.iter().enumerate() {
            for (l, q) in third.iter().enumerate() {
                a[j + k][j + l] += lambda * STEP * p * q;
            }
        }
    }
    let dense = gauss(a, b);
    for (j, ([c], expected)) in control.iter().zip(&dense).enumerate() {
        assert!((c - expected).abs() < 1e-9, "{j}: {c} {expected}");
    }
}

/// The path's second derivative against the truth's, over the inner part.
fn acceleration_error(sites: &[f64], control: &[[f64; 1]]) -> f64 {
    let spans = 20..sites.len() - 21;
    let count = spans.len() as f64;
    let square: f64 = spans
        .map(|span| {
            let middle = 0.5 * (sites[span] + sites[span + 1]);
            let knots = Knots::continued(sites);
            let polynomial = coefficients(knots, span, middle, control).unwrap();
            let truth = -0.49 * (0.7 * middle).sin();
            (2.0 * polynomial[2][0].hi - truth).powi(2)
        })
        .sum();
    (square / count).sqrt()
}

/// White noise of rms σ at a spacing Δ, through 1/(1 + τ⁶ω⁶), leaves σ√(Δ/18)τ^(−5/2) in the second derivative:
/// 1/2π ∫ω⁴/(1 + ω⁶)²dω = 1/18. What the path itself loses there is 0.49/√2 τ⁶ω⁶/(1 + τ⁶ω⁶), ω = 0.7 rad/s.
#[test]
fn noise_is_filtered_as_its_spectrum_says() {
    let times: Vec<f64> = (0..3000).map(|k| 0.1 * f64::from(k)).collect();
    let values = noisy(&times, 0.02, 5);
    let (smoothing, control) = solve(&times, &times, &values, 0.02).unwrap();
    let error = acceleration_error(&times, &control);
    let tau = smoothing.time_constant_s;
    let white = 0.02 * (0.1 / 18.0_f64).sqrt() * tau.powf(-2.5);
    let gain = (0.7 * tau).powi(6);
    let lost = 0.49 / 2_f64.sqrt() * gain / (1.0 + gain);
    let expected = white.hypot(lost);
    assert!((error / expected - 1.0).abs() < 0.15, "{smoothing:?}: {error} {expected}");
}

/// A parabola has no third derivative: the smoothest path keeps it whatever the noise says.
#[test]
fn parabolas_are_kept() {
    let mut numbers = Numbers(6);
    let mut t = 0.0;
    let times: Vec<f64> = (0..200)
        .map(|_| {
            t += 1.0 + numbers.within(0.4);
            t
        })
        .collect();
    let values: Vec<[f64; 1]> = times.iter().map(|t| [3.0 - 2.0 * t + 0.5 * t * t]).collect();
    let (smoothing, control) = solve(&times, &times, &values, 1.0).unwrap();
    // Rounding, to 1e-9 of the path's extent.
    let bound = 1e-9 * values[199][0];
    assert!(smoothing.at_limit && smoothing.residual < bound, "{smoothing:?}");
    for span in [0, 1, 100, 197, 198] {
        let knots = Knots::continued(&times);
        let polynomial = coefficients(knots, span, times[span], &control).unwrap();
        let expected = [values[span][0], times[span] - 2.0, 0.5];
        for (c, expected) in polynomial.iter().zip(expected) {
            assert!((c[0].hi - expected).abs() < bound, "{span}: {} {expected}", c[0].hi);
        }
    }
}

#[test]
fn what_cannot_be_smoothed_is_refused() {
    let times = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0];
    let values = [[0.0], [5.0], [-5.0], [5.0], [-5.0], [0.0]];
    assert!(solve(&times, &times, &values, 1.0).is_ok());
    // Two spans do not follow six samples.
    let sites = [0.0, 5.0];
    assert_eq!(
        solve(
            &sites,
            &[0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 4.5, 5.0],
            &[1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0].map(|x| [x]),
            1e-3
        )
        .unwrap_err(),
        SplineError::TooStiff
    );
    assert_eq!(
        solve(&times[1..], &times, &values, 1.0).unwrap_err(),
        SplineError::Outside { index: 0 }
    );
    assert_eq!(
        solve(&times, &times, &values[1..], 1.0).unwrap_err(),
        SplineError::Count { needed: 6 }
    );
    assert_eq!(
        solve(&times, &times[..2], &values[..2], 1e-9).unwrap_err(),
        SplineError::Undetermined
    );
}
