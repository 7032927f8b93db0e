//! Random initial errors: drawn from streams of their own, the same alone and in an ensemble, and as theory says.

use super::erring;
use schuler_simulator::ensemble::fleet;
use schuler_simulator::ensemble::group::{Ground, Unit};
use schuler_simulator::scene::{Scene, Vertical, WindowShape};
use schuler_simulator::simulate::{Simulation, nine, start};
use schuler_simulator::source::Source;
use schuler_simulator::theory::Theory;
use schuler_simulator::units::ARCSECOND;

/// A standing unit with an initial error of each kind.
fn scattered() -> Scene {
    let mut scene = erring("stationary", 60.0);
    let initial = &mut scene.initial_error;
    initial.position_sigma_m = [3.0, 5.0, 2.0];
    initial.velocity_sigma_m_s = [0.1, 0.2, 0.05];
    initial.attitude_sigma_rad = [20.0 * ARCSECOND, 30.0 * ARCSECOND, 200.0 * ARCSECOND];
    initial.position_m = [1.0, 0.0, -4.0];
    scene
}

#[test]
fn draws_are_normal_independent_and_each_their_own() {
    let scene = scattered();
    let runs = 20_000;
    let initial = scene.initial_error;
    let sigma = [initial.position_sigma_m, initial.velocity_sigma_m_s, initial.attitude_sigma_rad];
    let sigma: Vec<f64> = sigma.into_iter().flatten().collect();
    let unit = |run: u64| -> [f64; 9] {
        let x = nine(&start::error(&scene, run)).numbers();
        let fixed = |i: usize| if i < 3 { initial.position_m[i] } else { 0.0 };
        std::array::from_fn(|i| {
            let si = if i < 6 { 1.0 } else { ARCSECOND };
            (x[i] - fixed(i)) * si / sigma[i]
        })
    };
    let all: Vec<[f64; 9]> = (0..runs).map(unit).collect();
    // Five standard errors of a mean and of a correlation.
    let bound = 5.0 / (runs as f64).sqrt();
    for i in 0..9 {
        let mean = all.iter().map(|z| z[i]).sum::<f64>() / runs as f64;
        assert!(mean.abs() < bound, "mean {i}: {mean}");
        for j in 0..=i {
            let product = all.iter().map(|z| z[i] * z[j]).sum::<f64>() / runs as f64;
            let expected = if i == j { 1.0 } else { 0.0 };
            assert!((product - expected).abs() < 1.5 * bound, "{i} {j}: {product}");
        }
    }
    // One σ less changes nothing else, and another seed changes all.
    let mut less = scene.clone();
    less.initial_error.velocity_sigma_m_s[1] = 0.0;
    let (with, without) = (start::error(&scene, 7), start::error(&less, 7));
    assert_ne!(with.velocity_ned.y, 0.0);
    assert_eq!(without.velocity_ned.y, 0.0);
    assert_eq!(
        (with.position_ned, with.attitude_ned),
        (without.position_ned, without.attitude_ned)
    );
    assert_eq!(with.velocity_ned.z, without.velocity_ned.z);
    let other = Scene { seed: 99, ..scene.clone() };
    assert_ne!(start::error(&scene, 0).position_ned.x, start::error(&other, 0).position_ned.x);
    // What is held is not off.
    let mut held = scene;
    held.navigator.vertical = Vertical::Held;
    let error = start::error(&held, 3);
    assert_eq!((error.position_ned.z, error.velocity_ned.z), (0.0, 0.0));
    assert_ne!(error.position_ned.x, 1.0);
}

#[test]
fn without_sigma_nothing_is_drawn() {
    let mut scene = scattered();
    let initial = &mut scene.initial_error;
    initial.position_sigma_m = [0.0; 3];
    initial.velocity_sigma_m_s = [0.0; 3];
    initial.attitude_sigma_rad = [0.0; 3];
    assert_eq!(start::error(&scene, 5), start::error(&scene, 0));
    assert_eq!(start::error(&scene, 5).position_ned.x, 1.0);
    // Sensors do not notice a σ.
    let (with, without) = (scattered(), scene);
    let sources = [&with, &without].map(|scene| Source::new(scene, false).unwrap());
    let [mut a, mut b] = sources.each_ref().map(|source| source.start(3));
    for _ in 0..50 {
        assert_eq!(a.advance(), b.advance());
    }
}

#[test]
fn a_run_alone_is_that_of_the_ensemble_in_every_unit() {
    let mut scene = scattered();
    scene.duration_s = 3.0;
    scene.navigator.window = Some(WindowShape { history: 0, block: 4, lookahead: 0 });
    let runs = 11;
    let alone: Vec<_> = (0..runs)
        .map(|run| {
            let simulation = Simulation::of_run(&scene, false, run).unwrap();
            simulation.fly(&mut |_| Ok(()), &|_| {}).unwrap().last.drift
        })
        .collect();
    assert_ne!(alone[0], alone[1]);
    let source = Source::new(&scene, false).unwrap();
    let ground = Ground::new(&scene, &source);
    for &unit in Unit::ALL {
        // From a number that no group begins with.
        let stops = [scene.samples()];
        let flown = fleet::fly_range(&ground, 3..runs, unit, 2, &stops, &|_| {}).unwrap();
        let drifts: Vec<_> = flown.readings[0].drifts.iter().map(nine).collect();
        assert_eq!(drifts, alone[3..], "{unit:?}");
    }
}

#[test]
fn theory_begins_with_the_sigma_that_is_drawn_and_carries_it() {
    // Tilt about east alone, at rest: x_N = −Rψ(1 − cos ωt), v_N = −gψ sin(ωt)/ω, with Schuler's ω² = g/R. The Earth's
    // turn and the height enter at a thousandth over so short a time.
    let mut scene = scattered();
    scene.gyro = Default::default();
    scene.accelerometer = Default::default();
    scene.initial_error = Default::default();
    scene.duration_s = 600.0;
    let psi = 30.0 * ARCSECOND;
    scene.initial_error.attitude_sigma_rad = [0.0, psi, 0.0];
    let mut theory = Theory::new(&scene).unwrap();
    let start = theory.at(0.0);
    assert_eq!(start.mean.attitude_ned.y, 0.0);
    assert!((start.sigma.attitude_ned.y / psi - 1.0).abs() < 1e-12, "{:?}", start.sigma);
    let (g, radius) = (9.806, 6.3681e6);
    let omega = f64::sqrt(g / radius);
    for time_s in [60.0, 300.0, 600.0] {
        let sigma = theory.at(time_s).sigma;
        let (sin, cos) = (omega * time_s).sin_cos();
        let near = |a: f64, b: f64, what: &str| {
            assert!((a / b - 1.0).abs() < 5e-3, "{what} at {time_s}: {a} is not {b}");
        };
        near(sigma.position_ned.x, radius * psi * (1.0 - cos), "position");
        near(sigma.velocity_ned.x, g * psi * sin / omega, "velocity");
        near(sigma.attitude_ned.y, psi * cos, "tilt");
    }
    // And every covariance is that of the drawn start at the start.
    let scene = scattered();
    let covariance = Theory::new(&scene).unwrap().covariance(0.0);
    let initial = &scene.initial_error;
    let sigma =
        [initial.position_sigma_m, initial.velocity_sigma_m_s, initial.attitude_sigma_rad].concat();
    for i in 0..9 {
        for j in 0..9 {
            let expected = if i == j { sigma[i] * sigma[i] } else { 0.0 };
            let off = (covariance[i][j] - expected) / (sigma[i] * sigma[j]);
            assert!(off.abs() < 1e-9, "{i} {j}: {off}");
        }
    }
}
