//! Flights with sensor errors, many times: does the drift scatter as theory says?

use schuler_simulator::flight::Instant;
use schuler_simulator::scene::{GaussMarkov, builtin};
use schuler_simulator::simulate;
use schuler_simulator::theory::Theory;
use schuler_simulator::units::ARCSECOND;
use schuler_tests::at_rest;

const SEEDS: u64 = 64;
const TIMES_S: [f64; 3] = [300.0, 900.0, 1800.0];

/// Quantiles of χ² with 64 · 9 degrees of freedom: 0.05 % below, 0.05 % above (Wilson-Hilferty).
fn bounds(freedom: f64) -> (f64, f64) {
    let z = 3.290_526_731_491_926;
    let quantile = |z: f64| {
        let k = 2.0 / (9.0 * freedom);
        freedom * (1.0 - k + z * k.sqrt()).powi(3)
    };
    (quantile(-z), quantile(z))
}

/// The nine numbers of a drift less their mean, in m, m/s, rad.
fn deviation(instant: &Instant) -> [f64; 9] {
    let (x, mean) = (&instant.drift, &instant.mean);
    std::array::from_fn(|i| match i {
        0..3 => x.position_m[i] - mean.position_m[i],
        3..6 => x.velocity_m_s[i - 3] - mean.velocity_m_s[i - 3],
        _ => (x.attitude_arcsec[i - 6] - mean.attitude_arcsec[i - 6]) * ARCSECOND,
    })
}

/// xᵀ P⁻¹ x by Cholesky's factor of P scaled to unit variances.
fn mahalanobis(x: &[f64; 9], covariance: &[[f64; 9]; 9]) -> f64 {
    let scale: [f64; 9] = std::array::from_fn(|i| covariance[i][i].sqrt());
    let mut lower = [[0.0; 9]; 9];
    let mut solved = [0.0; 9];
    for i in 0..9 {
        for j in 0..=i {
            let dot: f64 = (0..j).map(|k| lower[i][k] * lower[j][k]).sum();
            let entry = covariance[i][j] / (scale[i] * scale[j]) - dot;
            lower[i][j] = if i == j { entry.sqrt() } else { entry / lower[j][j] };
        }
        let dot: f64 = (0..i).map(|k| lower[i][k] * solved[k]).sum();
        solved[i] = (x[i] / scale[i] - dot) / lower[i][i];
    }
    solved.iter().map(|y| y * y).sum()
}

#[test]
fn the_papers_drift_scatters_about_theorys_mean_as_theory_says() {
    let mut scene = builtin::scene("paper").unwrap();
    let mut theory = Theory::new(&scene).unwrap();
    let covariances = TIMES_S.map(|time_s| theory.covariance(time_s));
    let mut joint = [0.0; 3];
    let mut single = [[0.0; 9]; 3];
    for seed in 1..=SEEDS {
        scene.seed = seed;
        let mut observe = |instant: &Instant| {
            if let Some(t) = TIMES_S.iter().position(|&time_s| time_s == instant.time_s) {
                let x = deviation(instant);
                joint[t] += mahalanobis(&x, &covariances[t]);
                for (sum, (i, x)) in single[t].iter_mut().zip(x.iter().enumerate()) {
                    *sum += x * x / covariances[t][i][i];
                }
            }
            Ok(())
        };
        simulate::fly(&scene, false, &mut observe, &|_| {}).unwrap();
    }
    let (low, high) = bounds(9.0 * SEEDS as f64);
    for (t, sum) in joint.iter().enumerate() {
        println!("{} s: χ² = {sum:.1} of {low:.1} … {high:.1}; each {:.1?}", TIMES_S[t], single[t]);
        assert!((low..high).contains(sum), "at {} s χ² = {sum}", TIMES_S[t]);
    }
    let (low, high) = bounds(SEEDS as f64);
    for (t, sums) in single.iter().enumerate() {
        for (i, sum) in sums.iter().enumerate() {
            assert!((low..high).contains(sum), "component {i} at {} s: χ² = {sum}", TIMES_S[t]);
        }
    }
}

/// Noise behind slow sensors, at times from less than their lag to many times it.
#[test]
fn noise_behind_a_bandwidth_scatters_as_theory_says() {
    const RUNS: u64 = 250;
    const TIMES_S: [f64; 4] = [2.0, 5.0, 12.0, 40.0];
    let mut scene = at_rest(40.0);
    for (errors, size, frequency_hz) in [
        (&mut scene.gyro, 1e-6, [0.1, 0.3, 1.0]),
        (&mut scene.accelerometer, 1e-4, [0.05, 0.1, 2.0]),
    ] {
        errors.white = Some([2.0 * size; 3]);
        errors.gauss_markov =
            Some(GaussMarkov { rms: [3.0 * size; 3], correlation_s: [0.4, 3.0, 20.0] });
        errors.bias_instability = Some([size; 3]);
        errors.random_walk = Some([0.3 * size; 3]);
        errors.turn_on = Some([0.5 * size; 3]);
        errors.bandwidth = Some(frequency_hz);
    }
    // The same runs refute a theory that knows no bandwidth.
    let mut quick = scene.clone();
    (quick.gyro.bandwidth, quick.accelerometer.bandwidth) = (None, None);
    let covariances = [&scene, &quick].map(|scene| {
        let mut theory = Theory::new(scene).unwrap();
        TIMES_S.map(|time_s| theory.covariance(time_s))
    });
    let mut joint = [[0.0; TIMES_S.len()]; 2];
    for seed in 1..=RUNS {
        scene.seed = seed;
        let mut observe = |instant: &Instant| {
            let place = TIMES_S.iter().position(|&t| (t - instant.time_s).abs() < 1e-9);
            if let Some(t) = place {
                for (sum, covariances) in joint.iter_mut().zip(&covariances) {
                    sum[t] += mahalanobis(&deviation(instant), &covariances[t]);
                }
            }
            Ok(())
        };
        simulate::fly(&scene, false, &mut observe, &|_| {}).unwrap();
    }
    let (low, high) = bounds(9.0 * RUNS as f64);
    let [with, without] = joint;
    println!("χ² = {with:.0?} of {low:.0} … {high:.0}; without bandwidth {without:.0?}");
    assert!(with.iter().all(|sum| (low..high).contains(sum)), "{with:?} of {low} … {high}");
    assert!(without.iter().all(|sum| !(low..high).contains(sum)), "{without:?}");
}
