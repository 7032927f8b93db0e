//! Bandwidth, latency, temperature and matrices in theory's mean, against closed forms and against the emulator.

use schuler::earth::gravity;
use schuler::trajectory::harmonic::Harmonic;
use schuler_simulator::scene::{Channel, Scene, Temperature};
use schuler_simulator::source::Source;
use schuler_simulator::theory::Theory;
use schuler_tests::at_rest;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, TAU};

const AMPLITUDE: f64 = 0.2;
const TURN: f64 = 1.3;
const TIMES: [f64; 5] = [0.6, 1.3, 4.0, 7.7, 9.9];

/// Rocking about forward, θ = a(1 − cos ωt): at rest at the start.
fn rocking() -> Scene {
    let mut scene = at_rest(60.0);
    scene.rate_hz = 200.0;
    let harmonics = vec![Harmonic { amplitude: -AMPLITUDE, angular_rate: TURN, phase: 0.0 }];
    scene.trajectory.roll = Channel { offset: AMPLITUDE, rate: 0.0, harmonics };
    scene
}

fn angle(t: f64) -> f64 {
    AMPLITUDE * (1.0 - (TURN * t.max(0.0)).cos())
}

fn close(value: f64, expected: f64, size: f64, what: &str) {
    assert!((value - expected).abs() <= 2e-3 * size, "{what}: {value} is not {expected}");
}

/// The mean rate of the first sample: the emulator takes it for that of before.
const FIRST: f64 = AMPLITUDE * TURN * TURN * 0.5 / 200.0;

/// What the gyros read too much along forward up to a time, and theory's attitude error about north, which it is.
fn read_and_expected(scene: &Scene, time_s: f64) -> [f64; 2] {
    let source = Source::new(scene, false).unwrap();
    let mut sensors = source.start(0);
    let samples = (time_s * scene.rate_hz).round() as u64;
    let off = |sample| {
        let perfect = source.perfect_sample(sample);
        sensors.sense(&perfect).angle_b.x - perfect.angle_b.x
    };
    let read: f64 = (1..=samples).map(off).sum();
    [read, Theory::new(scene).unwrap().at(time_s).mean.attitude_ned.x]
}

#[test]
fn a_late_gyro_is_off_by_what_was_turned_since() {
    let delay_s = 0.0325;
    let mut scene = rocking();
    scene.gyro.latency = Some([delay_s; 3]);
    let mut theory = Theory::new(&scene).unwrap();
    let size = AMPLITUDE * TURN * delay_s;
    for t in TIMES {
        let expected = angle(t - delay_s) - angle(t);
        close(theory.at(t).mean.attitude_ned.x, expected, size, "latency");
    }
    for t in TIMES {
        let [read, expected] = read_and_expected(&scene, t);
        close(read, expected + delay_s * FIRST, size, "latency, read");
    }
}

#[test]
fn a_slow_gyro_is_off_by_its_lag_times_its_rate() {
    let frequency_hz = 3.0;
    let mut scene = rocking();
    scene.gyro.bandwidth = Some([frequency_hz; 3]);
    let mut theory = Theory::new(&scene).unwrap();
    let lag_s = 1.0 / (TAU * frequency_hz);
    // y′ = (x − y)/T of x = aω sin ωt, from 0: ∫(y − x)dt = −T y
    let wt = TURN * lag_s;
    let y = |t: f64| {
        let steady = (TURN * t).sin() - wt * (TURN * t).cos() + wt * (-t / lag_s).exp();
        AMPLITUDE * TURN * steady / (1.0 + wt * wt)
    };
    let size = AMPLITUDE * TURN * lag_s;
    for t in TIMES {
        close(theory.at(t).mean.attitude_ned.x, -lag_s * y(t), size, "bandwidth");
        let [read, expected] = read_and_expected(&scene, t);
        close(read, expected + lag_s * FIRST, size, "bandwidth, read");
    }
}

#[test]
fn a_late_accelerometer_falls_behind_a_heave() {
    // Height a sin ωt: the reading −g − ḧ is late by D.
    let (delay_s, amplitude, turn) = (0.02, 3.0, 1.1);
    let mut scene = at_rest(60.0);
    let harmonics = vec![Harmonic { amplitude, angular_rate: turn, phase: -FRAC_PI_2 }];
    scene.trajectory.altitude = Channel { offset: 1000.0, rate: 0.0, harmonics };
    scene.accelerometer.latency = Some([0.0, 0.0, delay_s]);
    let mut theory = Theory::new(&scene).unwrap();
    // The reading along down is v̇ − g, and was v̇(0) = 0 before the start.
    let down = |t: f64| -amplitude * turn * (turn * t).cos();
    for t in TIMES {
        let expected = down(t - delay_s) - down(t);
        close(
            theory.at(t).mean.velocity_ned.z,
            expected,
            amplitude * turn * turn * delay_s,
            "heave",
        );
    }
}

#[test]
fn a_sensor_that_warms_up_drifts_until_it_is_warm() {
    let (coefficient, scale) = (1e-4, 1e-5);
    let temperature = Temperature { offset_k: 5.0, rate_k_s: 2.0, until_s: 4.0 };
    let mut scene = at_rest(60.0);
    scene.accelerometer.temperature_bias = Some([coefficient; 3]);
    scene.accelerometer.temperature = Some(temperature);
    let warmth = |t: f64| {
        let rising = t.min(4.0);
        5.0 * t + rising * rising + 8.0 * (t - rising)
    };
    let mut theory = Theory::new(&scene).unwrap();
    for t in TIMES {
        let expected = coefficient * warmth(t);
        close(theory.at(t).mean.velocity_ned.z, expected, expected, "bias");
    }
    scene.accelerometer.temperature_bias = None;
    scene.accelerometer.temperature_scale = Some([0.0, 0.0, scale]);
    let g = gravity(FRAC_PI_4.sin(), 1000.0);
    let mut theory = Theory::new(&scene).unwrap();
    for t in TIMES {
        let expected = -scale * g * warmth(t);
        close(theory.at(t).mean.velocity_ned.z, expected, expected.abs(), "scale factor");
    }
    let mut scene = rocking();
    scene.gyro.temperature_bias = Some([1e-6; 3]);
    scene.gyro.temperature_scale = Some([1e-5; 3]);
    scene.gyro.temperature = Some(temperature);
    let [read, expected] = read_and_expected(&scene, 9.9);
    close(read, expected, 1e-6 * warmth(9.9), "read");
}

#[test]
fn matrices_act_across_axes() {
    let g = gravity(FRAC_PI_4.sin(), 1000.0);
    let mut scene = at_rest(60.0);
    let (m, k) = (1e-4, 1e-8);
    scene.accelerometer.misalignment_matrix = Some([[0.0, 0.0, m], [0.0; 3], [0.0; 3]]);
    scene.gyro.g_sensitivity_matrix = Some([[0.0; 3], [0.0; 3], [0.0, 0.0, k]]);
    let mut theory = Theory::new(&scene).unwrap();
    for t in TIMES {
        let mean = theory.at(t).mean;
        close(mean.velocity_ned.x, -m * g * t, m * g * t, "north velocity");
        close(mean.attitude_ned.z, -k * g * t, k * g * t, "azimuth");
    }
}
