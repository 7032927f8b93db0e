//! Theory's mean and covariance against closed forms and an independently computed table.
//!
//! The laws hold for one channel at rest. The Earth's rotation, which they leave out, turns one channel
//! into the others: by (ω_ie t)² at most, 2e-5 at 60 s and 5e-4 at 300 s.

use schuler::earth::{Radii, gravity};
use schuler_simulator::scene::{GaussMarkov, Scene, Vertical};
use schuler_simulator::theory::{Expected, Theory};
use schuler_tests::{at_rest, near};
use std::f64::consts::{FRAC_PI_4, PI};

const DEG_H: f64 = PI / 180.0 / 3600.0;
const DEG_SQRT_H: f64 = PI / 180.0 / 60.0;
const UG: f64 = 9.80665e-6;
const ARCSEC: f64 = PI / 180.0 / 3600.0;

/// Times up to 300 s, on and between the steps, and the tolerance there.
fn each_time(scene: &Scene, mut check: impl FnMut(f64, f64, &Expected)) {
    let mut theory = Theory::new(scene).unwrap();
    for t in [0.05, 0.35, 1.3, 7.7, 60.0, 61.15, 300.0] {
        let turn = schuler::earth::ROTATION_RATE * t;
        check(t, turn * turn + 1e-3, &theory.at(t));
    }
}

/// γ, R_M + h and Schuler's rate at rest.
fn schuler_constants() -> (f64, f64, f64) {
    let (s, c) = FRAC_PI_4.sin_cos();
    let (g, r) = (gravity(s, 1000.0), Radii::at(s, c).meridian + 1000.0);
    (g, r, (g / r).sqrt())
}

#[test]
fn covariance_of_the_reference_table() {
    let mut scene = at_rest(3600.0);
    let process = |rms: f64| Some(GaussMarkov { rms: [rms; 3], correlation_s: [720.0; 3] });
    scene.gyro.turn_on = Some([0.1 * DEG_H; 3]);
    scene.gyro.gauss_markov = process(0.1 * DEG_H);
    scene.gyro.white = Some([0.01 * DEG_SQRT_H; 3]);
    scene.accelerometer.gauss_markov = process(100.0 * UG);
    let mut theory = Theory::new(&scene).unwrap();
    for [t, position_n, position_d, velocity_n, velocity_d, tilt, azimuth] in [
        [300.0, 51.7, 42.8, 0.405, 0.288, 41.4, 42.4],
        [600.0, 277.5, 174.6, 1.217, 0.618, 74.2, 81.7],
        [900.0, 798.7, 420.8, 2.39, 1.08, 96.1, 121.0],
        [1800.0, 4683.0, 2727.0, 6.30, 5.06, 94.3, 268.8],
        [3600.0, 16098.0, 66861.0, 6.10, 117.4, 161.6, 660.7],
    ] {
        let sigma = theory.at(t).sigma;
        near(sigma.position_ned.x, position_n, 0.01, "north");
        near(sigma.position_ned.z, position_d, 0.01, "down");
        near(sigma.velocity_ned.x, velocity_n, 0.01, "north velocity");
        near(sigma.velocity_ned.z, velocity_d, 0.01, "down velocity");
        near(sigma.attitude_ned.x, tilt * ARCSEC, 0.01, "tilt");
        near(sigma.attitude_ned.z, azimuth * ARCSEC, 0.01, "azimuth");
    }
}

#[test]
fn accelerometer_bias() {
    let (g, _, w) = schuler_constants();
    let b = 1e-3;
    let mut scene = at_rest(3600.0);
    scene.accelerometer.constant = Some([b, 0.0, 0.0]);
    each_time(&scene, |t, tolerance, Expected { mean, .. }| {
        let versine = 2.0 * (w * t / 2.0).sin().powi(2);
        near(mean.position_ned.x, b * versine / (w * w), tolerance, "position");
        near(mean.velocity_ned.x, b * (w * t).sin() / w, tolerance, "velocity");
        near(mean.attitude_ned.y, b * versine / g, tolerance, "tilt");
    });
}

#[test]
fn gyro_drift() {
    let (_, r, w) = schuler_constants();
    let drift = 1e-7;
    let mut scene = at_rest(3600.0);
    scene.gyro.constant = Some([0.0, drift, 0.0]);
    each_time(&scene, |t, tolerance, Expected { mean, .. }| {
        // t − sin(ωt)/ω, by its series where it cancels
        let x = w * t;
        let lag = if x < 0.1 {
            x * x * x / 6.0 * (1.0 - x * x / 20.0 * (1.0 - x * x / 42.0)) / w
        } else {
            t - x.sin() / w
        };
        // A positive drift about east lets the navigator fall back southward.
        near(mean.position_ned.x, -drift * r * lag, tolerance, "position");
        let versine = 2.0 * (x / 2.0).sin().powi(2);
        near(mean.velocity_ned.x, -drift * r * versine, tolerance, "velocity");
        near(mean.attitude_ned.y, drift * x.sin() / w, tolerance, "tilt");
    });
}

#[test]
fn initial_tilt() {
    let (g, r, w) = schuler_constants();
    let tilt = 1e-5;
    let mut scene = at_rest(3600.0);
    scene.initial_error.attitude_rad = [0.0, tilt, 0.0];
    each_time(&scene, |t, tolerance, Expected { mean, .. }| {
        let versine = 2.0 * (w * t / 2.0).sin().powi(2);
        near(mean.position_ned.x, -r * tilt * versine, tolerance, "position");
        near(mean.velocity_ned.x, -g * tilt * (w * t).sin() / w, tolerance, "velocity");
        near(mean.attitude_ned.y, tilt * (w * t).cos(), tolerance, "tilt");
    });
}

#[test]
fn angle_random_walk() {
    let (g, r, w) = schuler_constants();
    let n = 0.01 * DEG_SQRT_H;
    let mut scene = at_rest(3600.0);
    scene.gyro.white = Some([0.0, n, 0.0]);
    each_time(&scene, |t, tolerance, Expected { sigma, .. }| {
        let x = w * t;
        let position = if x < 0.1 {
            // ∫(1 − cos)², by its series where it cancels
            t * x.powi(4) / 20.0 * (1.0 - 5.0 / 42.0 * x * x)
        } else {
            1.5 * t - 2.0 * x.sin() / w + (2.0 * x).sin() / (4.0 * w)
        };
        near(sigma.position_ned.x, n * r * position.sqrt(), tolerance, "position");
        let sine = sine_squared(w, t);
        near(sigma.velocity_ned.x, n * g / w * sine.sqrt(), tolerance, "velocity");
        near(sigma.attitude_ned.y, n * (t - sine).sqrt(), tolerance, "tilt");
    });
}

/// ∫sin²(ωt)dt = t/2 − sin(2ωt)/4ω.
fn sine_squared(w: f64, t: f64) -> f64 {
    let x = w * t;
    if x < 0.1 {
        t * x * x / 3.0 * (1.0 - x * x / 5.0)
    } else {
        t / 2.0 - (2.0 * x).sin() / (4.0 * w)
    }
}

#[test]
fn velocity_random_walk() {
    let (g, r, w) = schuler_constants();
    let m = 1e-3;
    let mut scene = at_rest(3600.0);
    scene.accelerometer.white = Some([m, 0.0, 0.0]);
    each_time(&scene, |t, tolerance, Expected { sigma, .. }| {
        let sine = sine_squared(w, t);
        near(sigma.position_ned.x, m / w * sine.sqrt(), tolerance, "position");
        near(sigma.velocity_ned.x, m * (t - sine).sqrt(), tolerance, "velocity");
        near(sigma.attitude_ned.y, m * (sine / (g * r)).sqrt(), tolerance, "tilt");
    });
}

#[test]
fn vertical_channel() {
    // κ² = −∂γ/∂h, by differences
    let s = FRAC_PI_4.sin();
    let k = ((gravity(s, 900.0) - gravity(s, 1100.0)) / 200.0).sqrt();
    near(1.0 / k, 569.0, 1e-3, "time constant");
    let (b, m, down) = (1e-3, 1e-3, 10.0);
    let mut scene = at_rest(3600.0);
    scene.accelerometer.white = Some([0.0, 0.0, m]);
    scene.accelerometer.constant = Some([0.0, 0.0, b]);
    each_time(&scene, |t, tolerance, Expected { mean, sigma }| {
        let x = k * t;
        let versine = 2.0 * (x / 2.0).sinh().powi(2);
        near(mean.position_ned.z, b * versine / (k * k), tolerance, "bias");
        let variance = if x < 0.1 {
            t * x * x / 3.0 * (1.0 + x * x / 5.0)
        } else {
            (2.0 * x).sinh() / (4.0 * k) - t / 2.0
        };
        near(sigma.position_ned.z, m / k * variance.sqrt(), tolerance, "random walk");
    });
    scene = at_rest(3600.0);
    scene.initial_error.position_m = [0.0, 0.0, down];
    each_time(&scene, |t, tolerance, Expected { mean, .. }| {
        near(mean.position_ned.z, down * (k * t).cosh(), tolerance, "start");
    });
    scene.initial_error.position_m = [5.0, 0.0, down];
    scene.navigator.vertical = Vertical::Held;
    each_time(&scene, |_, tolerance, Expected { mean, .. }| {
        assert_eq!((mean.position_ned.z, mean.velocity_ned.z), (0.0, 0.0), "held");
        // Level in its own place, the navigator has no reason to move.
        near(mean.position_ned.x, 5.0, tolerance, "north");
    });
}
