//! Theory along moving courses: systematic sensor errors, fast turns, the pole.

use schuler::earth::{ROTATION_RATE, gravity};
use schuler::trajectory::harmonic::Harmonic;
use schuler_simulator::scene::{Channel, GaussMarkov, Scene, SensorErrors, Vertical};
use schuler_simulator::theory::{Expected, Theory};
use schuler_tests::at_rest;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

/// Turning about every axis, fast, while flying a curve.
fn manoeuvre() -> Scene {
    let mut scene = at_rest(60.0);
    let wave = |amplitude, angular_rate, phase| Channel {
        harmonics: vec![Harmonic { amplitude, angular_rate, phase }],
        ..Channel::default()
    };
    scene.trajectory.roll = wave(6.0, 0.8, -FRAC_PI_2);
    scene.trajectory.pitch = wave(0.5, 1.3, 0.4);
    scene.trajectory.yaw = wave(0.8, 0.9, -FRAC_PI_2);
    scene.trajectory.longitude = Channel { rate: 6e-5, ..wave(1e-5, 0.7, 0.0) };
    scene.trajectory.altitude = Channel { offset: 3000.0, ..wave(50.0, 0.9, 0.0) };
    scene
}

/// Every source there is.
fn full_errors(scene: &mut Scene) {
    let errors = |size: f64| SensorErrors {
        constant: Some([size; 3]),
        turn_on: Some([size, 0.5 * size, 0.3 * size]),
        gauss_markov: Some(GaussMarkov { rms: [size; 3], correlation_s: [300.0, 20.0, 0.1] }),
        white: Some([size; 3]),
        random_walk: Some([0.1 * size; 3]),
        bias_instability: Some([size; 3]),
        scale_factor: Some([1e-4, 2e-4, -1e-4]),
        misalignment: Some([1e-4, -3e-4, 2e-4]),
        quantization: Some([size, 2.0 * size, 3.0 * size]),
        bandwidth: Some([50.0, 60.0, 70.0]),
        latency: Some([1e-3, 2e-3, 3e-3]),
        ..SensorErrors::default()
    };
    scene.gyro = errors(1e-6);
    scene.gyro.g_sensitivity = Some([1e-7, 2e-7, 3e-7]);
    scene.accelerometer = errors(1e-3);
}

/// To 2e-3 of a size, as values may swing through zero. The laws leave out the Earth's rotation, which
/// comes to 2ω_ie t = 1.4e-3 at 9.9 s.
fn close(value: f64, expected: f64, size: f64, what: &str) {
    assert!((value - expected).abs() <= 2e-3 * size, "{what}: {value} is not {expected}");
}

const TIMES: [f64; 6] = [0.05, 0.2, 0.55, 1.3, 4.0, 9.9];

#[test]
fn gyro_scale_factor_counts_turns() {
    let (scale, rate) = (1e-5, 3.0);
    let mut scene = at_rest(60.0);
    scene.trajectory.roll.rate = rate;
    scene.gyro.scale_factor = Some([scale, 0.0, 0.0]);
    let mut theory = Theory::new(&scene).unwrap();
    for t in TIMES {
        let turned = (rate + ROTATION_RATE * FRAC_PI_4.cos()) * t;
        close(theory.at(t).mean.attitude_ned.x, scale * turned, scale * turned, "roll");
    }
}

#[test]
fn gyro_misalignment_turns_yaw_into_tilt() {
    // Reading −m × ω: with m forward and ω down, a rate m·ω about right.
    let (m, rate) = (1e-5, 0.7);
    let mut scene = at_rest(60.0);
    scene.trajectory.yaw.rate = rate;
    scene.gyro.misalignment = Some([m, 0.0, 0.0]);
    let mut theory = Theory::new(&scene).unwrap();
    for t in TIMES {
        let attitude = theory.at(t).mean.attitude_ned;
        close(attitude.x, m * ((rate * t).cos() - 1.0), m, "north");
        close(attitude.y, m * (rate * t).sin(), m, "east");
    }
}

#[test]
fn gravity_acts_on_scale_misalignment_and_gyros() {
    let g = gravity(FRAC_PI_4.sin(), 1000.0);
    let (scale, m, sensitivity) = (1e-4, 1e-4, 1e-8);
    let mut scene = at_rest(60.0);
    scene.accelerometer.scale_factor = Some([0.0, 0.0, scale]);
    scene.accelerometer.misalignment = Some([0.0, m, 0.0]);
    scene.gyro.g_sensitivity = Some([0.0, 0.0, sensitivity]);
    let mut theory = Theory::new(&scene).unwrap();
    for t in TIMES {
        let Expected { mean, .. } = theory.at(t);
        // f = (0, 0, −g):  S·f = −sg down,  −m × f = m·g forward,  G·f = −Gg down
        close(mean.velocity_ned.z, -scale * g * t, scale * g * t, "down velocity");
        close(mean.velocity_ned.x, m * g * t, m * g * t, "north velocity");
        close(mean.attitude_ned.z, -sensitivity * g * t, sensitivity * g * t, "azimuth");
    }
}

#[test]
fn accelerometer_bias_turns_with_the_vehicle() {
    let (b, rate) = (1e-3, 3.0);
    let mut scene = at_rest(60.0);
    scene.trajectory.roll.rate = rate;
    scene.accelerometer.constant = Some([0.0, b, 0.0]);
    scene.accelerometer.turn_on = Some([0.0, b, 0.0]);
    let mut theory = Theory::new(&scene).unwrap();
    for t in TIMES {
        let Expected { mean, sigma } = theory.at(t);
        let (s, c) = (rate * t).sin_cos();
        let (east, down) = (b * s / rate, b * (1.0 - c) / rate);
        close(mean.velocity_ned.y, east, b / rate, "east");
        close(mean.velocity_ned.z, down, b / rate, "down");
        close(sigma.velocity_ned.y, east.abs(), b / rate, "east");
        close(sigma.velocity_ned.z, down.abs(), b / rate, "down");
        let product = theory.covariance(t)[4][5];
        close(product, east * down, 2.0 * (b / rate).powi(2), "east and down");
    }
}

#[test]
fn rows_between_steps_agree_with_the_full_covariance() {
    let mut scene = manoeuvre();
    full_errors(&mut scene);
    let mut theory = Theory::new(&scene).unwrap();
    for t in (1..2000).map(|i| f64::from(i) * 0.0137) {
        let Expected { sigma, .. } = theory.at(t);
        let covariance = theory.covariance(t);
        let groups = [sigma.position_ned, sigma.velocity_ned, sigma.attitude_ned];
        for (i, sigma) in groups.into_iter().flat_map(|v| v.into_array()).enumerate() {
            let exact = covariance[i][i].sqrt();
            assert!((sigma - exact).abs() <= 1e-4 * exact, "{t} s, {i}: {sigma}, {exact}");
            for j in 0..9 {
                let (a, b) = (covariance[i][j], covariance[j][i]);
                let limit = (covariance[i][i] * covariance[j][j]).sqrt();
                assert!((a - b).abs() <= 1e-9 * limit, "{t} s: not symmetric");
                assert!(a.abs() <= limit * (1.0 + 1e-9), "{t} s: correlation above one");
            }
        }
    }
}

#[test]
fn a_held_vertical_has_no_drift() {
    let mut scene = manoeuvre();
    full_errors(&mut scene);
    scene.initial_error.position_m = [1.0, 2.0, 3.0];
    scene.navigator.vertical = Vertical::Held;
    let mut theory = Theory::new(&scene).unwrap();
    for t in TIMES {
        let Expected { mean, sigma } = theory.at(t);
        for drift in [mean, sigma] {
            assert_eq!((drift.position_ned.z, drift.velocity_ned.z), (0.0, 0.0));
            assert!(drift.position_ned.x != 0.0);
        }
    }
}

#[test]
fn an_earlier_time_starts_anew() {
    let mut scene = manoeuvre();
    full_errors(&mut scene);
    let mut theory = Theory::new(&scene).unwrap();
    let early = theory.at(3.21);
    theory.at(17.0);
    assert_eq!(theory.at(3.21), early);
}

#[test]
fn nothing_to_expect_of_perfect_sensors() {
    let mut theory = Theory::new(&manoeuvre()).unwrap();
    assert!(theory.is_zero());
    assert_eq!(theory.at(50.0), Expected::default());
    assert_eq!(theory.covariance(50.0), [[0.0; 9]; 9]);
    let mut scene = at_rest(60.0);
    scene.initial_error.velocity_m_s = [0.0, 0.0, 1.0];
    assert!(!Theory::new(&scene).unwrap().is_zero());
}

#[test]
fn over_the_pole() {
    // 11 km before the pole at 250 m/s, along a meridian
    let (b, drift) = (1e-3, 1e-7);
    let mut scene = at_rest(60.0);
    scene.trajectory.latitude =
        Channel { offset: 89.9_f64.to_radians(), rate: 250.0 / 6.4e6, harmonics: Vec::new() };
    scene.accelerometer.constant = Some([b, 0.0, 0.0]);
    scene.accelerometer.turn_on = Some([0.0, b, 0.0]);
    scene.gyro.turn_on = Some([0.0, 0.0, drift]);
    let mut theory = Theory::new(&scene).unwrap();
    for i in 1..1800 {
        let t = f64::from(i) * 0.05;
        let Expected { mean, sigma } = theory.at(t);
        let fallen = b * t * t / 2.0;
        // The printed north turns about at the pole, after 44.7 s.
        let sign = if t < 44.6 { 1.0 } else { -1.0 };
        if !(44.5..44.8).contains(&t) {
            close(mean.position_ned.x, sign * fallen, fallen, "along");
        }
        close(sigma.position_ned.y, fallen, fallen, "across");
        // The error across shows in the azimuth through the meridians' convergence, unless they are
        // not compared.
        let axis_distance = 6.4e6 * (89.9_f64.to_radians() + 250.0 / 6.4e6 * t).cos().abs();
        let azimuth = sigma.attitude_ned.z;
        let limit = (drift * t).hypot(1.05 * fallen / axis_distance).min(0.11);
        assert!(azimuth >= 0.99 * drift * t && azimuth <= limit.max(1.01 * drift * t), "{t}");
    }
}
