//! The error terms: theory's variances add up to the whole, and switching a term off shows the same share.

use super::erring;
use schuler_simulator::ensemble::batches::Means;
use schuler_simulator::ensemble::budget::{by_switching_off, by_theory, terms};
use schuler_simulator::ensemble::fleet;
use schuler_simulator::ensemble::group::{Ground, Unit};
use schuler_simulator::ensemble::kept::Kept;
use schuler_simulator::scene::Scene;
use schuler_simulator::simulate::{FlightError, nine};
use schuler_simulator::source::Source;
use schuler_simulator::theory::Theory;
use schuler_simulator::units::ARCSECOND;

/// The paper's errors, a drawn start and a scale factor.
fn scene() -> Scene {
    let mut scene = erring("paper", 300.0);
    scene.initial_error.attitude_sigma_rad = [10.0 * ARCSECOND; 3];
    scene.initial_error.position_m = [5.0, 0.0, 0.0];
    scene.accelerometer.scale_factor = Some([20e-6, 0.0, -30e-6]);
    scene
}

#[test]
fn every_term_of_a_scene_is_there_once() {
    let names: Vec<String> = terms(&scene()).into_iter().map(|term| term.name).collect();
    let expected = [
        "gyro constant bias",
        "gyro angle random walk",
        "gyro Gauss-Markov bias",
        "accelerometer scale factor",
        "accelerometer Gauss-Markov bias",
        "start position",
        "start attitude",
    ];
    assert_eq!(names, expected);
    for term in terms(&scene()) {
        assert_eq!(terms(&term.alone).len(), 1, "{}", term.name);
        assert_eq!(terms(&term.without).len(), expected.len() - 1, "{}", term.name);
    }
}

#[test]
fn the_terms_of_theory_add_up() {
    let scene = scene();
    let times = [20.0, 150.0, 300.0];
    let all: Vec<_> = terms(&scene).iter().map(|term| by_theory(term, &times).unwrap()).collect();
    let mut theory = Theory::new(&scene).unwrap();
    for (place, &time_s) in times.iter().enumerate() {
        let expected = theory.at(time_s);
        let [mean, sigma] = [&expected.mean, &expected.sigma].map(|drift| nine(drift).numbers());
        for i in 0..9 {
            let of_means: f64 = all.iter().map(|term| term[place].mean[i]).sum();
            let size: f64 = all.iter().map(|term| term[place].mean[i].abs()).sum();
            assert!((of_means - mean[i]).abs() <= 1e-6 * size, "mean {i} at {time_s}");
            let squares: f64 = all.iter().map(|term| term[place].sigma[i].powi(2)).sum();
            let off = squares.sqrt() / sigma[i] - 1.0;
            assert!(off.abs() < 1e-6, "σ {i} at {time_s}: {off}");
        }
    }
}

#[test]
fn switching_a_term_off_shows_what_theory_says() {
    let scene = scene();
    let source = Source::new(&scene, false).unwrap();
    let ground = Ground::new(&scene, &source);
    let (runs, stops) = (96, [3000, scene.samples()]);
    let unit = ground.widest(runs);
    let flown = fleet::fly_range(&ground, 0..runs, unit, 2, &stops, &|_| {}).unwrap();
    let kept = Kept::new(0..runs, flown);
    let times: Vec<f64> = kept.instants().iter().map(|&n| source.time_s(n)).collect();
    for term in terms(&scene) {
        let contribution = |unit, batch| {
            let means = Means { unit, threads: 2, stops: &stops, batch };
            by_switching_off::<FlightError>(&ground, &term, &kept, 64, means).unwrap()
        };
        let found = contribution(unit, None);
        let theory = by_theory(&term, &times).unwrap();
        assert_eq!(found.len(), 2, "{}", term.name);
        for (found, theory) in found.iter().zip(&theory) {
            for i in 0..9 {
                let what = format!("{} {i}", term.name);
                let size = theory.mean[i].hypot(theory.sigma[i]);
                // Where a term moves next to nothing, second-order terms of the others are all that is seen.
                let whole = nine(&Theory::new(&scene).unwrap().at(300.0).sigma).numbers()[i];
                if size < 1e-2 * whole {
                    continue;
                }
                // Five standard errors of 64 runs, and a share for what is not linear.
                let error = 5.0 * theory.sigma[i] / 8.0 + 0.02 * size;
                assert!((found.mean[i] - theory.mean[i]).abs() < error, "mean: {what}");
                let error = 5.0 * theory.sigma[i] / f64::sqrt(128.0) + 0.02 * size;
                assert!((found.sigma[i] - theory.sigma[i]).abs() < error, "σ: {what}");
            }
        }
        // Neither lanes nor batches show.
        if term.name == "gyro angle random walk" {
            assert_eq!(contribution(Unit::Alone, Some(13)), found);
        }
    }
}
