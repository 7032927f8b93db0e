//! Means, standard deviations and χ² against sums written out and closed forms.

use super::erring;
use schuler_host::ensemble::statistics::{Comparison, RISK, Test, Verdict, compare};
use schuler_host::ensemble::table::table;
use schuler_simulator::ensemble::fleet::{self, Flown};
use schuler_simulator::ensemble::group::{Ground, Unit};
use schuler_simulator::flight::Nine;
use schuler_simulator::scene::Scene;
use schuler_simulator::source::Source;
use schuler_simulator::theory::Theory;
use schuler_simulator::units::ARCSECOND;

fn fly(scene: &Scene, runs: u64) -> Flown {
    let source = Source::new(scene, false).unwrap();
    fleet::fly(&Ground::new(scene, &source), runs, Unit::ALL[0], 2, 4, &|_| {}).unwrap()
}

/// P(χ² > x) with an even number of degrees of freedom: e^{−x/2} Σ (x/2)ⁱ/i!
fn above_even(freedom: u32, x: f64) -> f64 {
    let mut term = (-0.5 * x).exp();
    let mut sum = 0.0;
    for i in 1..=freedom / 2 {
        sum += term;
        term *= 0.5 * x / f64::from(i);
    }
    sum
}

/// P(|z| > a) of a normal deviate, by Simpson's rule.
fn beyond(a: f64) -> f64 {
    let (steps, width) = (2000, a / 2000.0);
    let weight = |i: usize| match i {
        0 => 1.0,
        i if i == steps => 1.0,
        i => [2.0, 4.0][i % 2],
    };
    let sum: f64 = (0..=steps).map(|i| weight(i) * (-0.5 * (i as f64 * width).powi(2)).exp()).sum();
    1.0 - 2.0 * sum * width / 3.0 / (2.0 * std::f64::consts::PI).sqrt()
}

fn close(a: f64, b: f64, what: &str) {
    assert!((a - b).abs() <= 1e-9 * b.abs() + 1e-12, "{what}: {a} is not {b}");
}

#[test]
fn a_small_ensemble_by_hand() {
    let scene = erring("paper", 120.0);
    let flown = fly(&scene, 9);
    let mut theory = Theory::new(&scene).unwrap();
    let comparisons = compare(&flown.readings, |n| n as f64 / 20.0, &mut theory);
    assert_eq!(comparisons.len(), 4 * 9);
    let mut by_hand = Theory::new(&scene).unwrap();
    for (comparison, (reading, i)) in
        comparisons.iter().zip(flown.readings.iter().flat_map(|r| (0..9).map(move |i| (r, i))))
    {
        let time_s = reading.samples as f64 / 20.0;
        let expected = by_hand.at(time_s);
        let number = |d: &schuler::drift::compare::Drift| match i {
            0 => d.position_ned.x,
            1 => d.position_ned.y,
            2 => d.position_ned.z,
            3 => d.velocity_ned.x,
            4 => d.velocity_ned.y,
            5 => d.velocity_ned.z,
            6 => d.attitude_ned.x / ARCSECOND,
            7 => d.attitude_ned.y / ARCSECOND,
            _ => d.attitude_ned.z / ARCSECOND,
        };
        let x: Vec<f64> = reading.drifts.iter().map(number).collect();
        let (mu, sigma) = (number(&expected.mean), number(&expected.sigma));
        let mean = x.iter().sum::<f64>() / 9.0;
        let squares: f64 = x.iter().map(|x| (x - mean).powi(2)).sum();
        let what = format!("{} at {time_s}", Nine::NAMES[i]);
        assert_eq!((comparison.component, comparison.time_s), (i, time_s));
        assert_eq!((comparison.mean_theory, comparison.sigma_theory), (mu, sigma), "{what}");
        close(comparison.mean, mean, &what);
        close(comparison.sigma, (squares / 8.0).sqrt(), &what);
        let [of_mean, of_sigma] = comparison.tests.expect(&what);
        let z = (mean - mu) / (sigma / 3.0);
        close(of_mean.chi_square, z * z, &what);
        close(of_mean.probability, beyond(z.abs()), &what);
        let chi_square = squares / (sigma * sigma);
        close(of_sigma.chi_square, chi_square, &what);
        let above = above_even(8, chi_square);
        close(of_sigma.probability, 2.0 * above.min(1.0 - above), &what);
    }
}

#[test]
fn an_ensemble_agrees_with_its_own_theory_and_with_no_other() {
    let scene = erring("paper", 300.0);
    let flown = fly(&scene, 100);
    let compared = |scene: &Scene| {
        compare(&flown.readings, |n| n as f64 / 20.0, &mut Theory::new(scene).unwrap())
    };
    let own = compared(&scene);
    let verdict = Verdict::new(&own);
    assert_eq!((verdict.tests, verdict.failed), (4 * 9 * 2, 0), "{verdict:?}");
    let text = table(&own, 100);
    assert!(text.contains("\nThe ensemble agrees with theory at 99.9 %: 72 tests"), "{text}");

    let mut biased = scene.clone();
    biased.gyro.constant = Some([1.0 * std::f64::consts::PI / 180.0 / 3600.0; 3]);
    let verdict = Verdict::new(&compared(&biased));
    let worst = verdict.worst.unwrap();
    assert!(verdict.failed > 0 && worst.1 == 0, "the mean: {verdict:?}");

    let mut noisier = scene.clone();
    noisier.gyro.white = scene.gyro.white.map(|white| white.map(|n| 4.0 * n));
    let mut compared = compared(&noisier);
    let verdict = Verdict::new(&compared);
    let worst = verdict.worst.unwrap();
    assert!(verdict.failed > 0 && worst.1 == 1, "the spread: {verdict:?}");
    let text = table(&compared, 100);
    let words = format!("does not agree with theory at 99.9 %: {} of 72 tests", verdict.failed);
    assert!(text.contains(&words), "{text}");

    // A number that is none agrees with nothing.
    compared.truncate(1);
    let none = Test { chi_square: f64::NAN, probability: f64::NAN };
    compared[0].tests = Some([none; 2]);
    assert_eq!(Verdict::new(&compared).failed, 2);
}

#[test]
fn the_level_of_all_tests_together_is_the_risk() {
    let test = |probability| Test { chi_square: 1.0, probability };
    let comparison = |probability| Comparison {
        time_s: 1.0,
        component: 0,
        mean: 0.0,
        mean_theory: 0.0,
        sigma: 1.0,
        sigma_theory: 1.0,
        tests: Some([test(probability), test(1.0)]),
    };
    let mut all = vec![comparison(1.0); 50];
    all[17] = comparison(RISK / 100.0 * 1.01);
    assert_eq!(Verdict::new(&all).failed, 0);
    all[17] = comparison(RISK / 100.0 * 0.99);
    let verdict = Verdict::new(&all);
    assert_eq!((verdict.failed, verdict.worst.unwrap().0), (1, 17));
    let untested = Comparison { tests: None, ..all[0] };
    assert_eq!(Verdict::new(&[untested]).worst, None);
    assert!(table(&[untested], 10).contains("nothing to compare"));
}

#[test]
fn what_does_not_scatter_is_not_tested() {
    // Level and at rest: a gyro about down alone moves nothing vertical.
    let mut scene = erring("stationary", 60.0);
    scene.accelerometer = Default::default();
    scene.gyro = Default::default();
    scene.gyro.turn_on = Some([0.0, 0.0, 1e-15]);
    let flown = fly(&scene, 4);
    let compared = compare(&flown.readings, |n| n as f64 / 20.0, &mut Theory::new(&scene).unwrap());
    assert!(compared.iter().all(|c| c.tests.is_none() && c.sigma_theory < 1e-5));
}
