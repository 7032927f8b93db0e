//! Each random source in theory's moments: laws of a level vehicle over times that are short beside
//! Schuler's period and the vertical channel's, (ω_s t)² and (κt)² ≤ 1.2e-3, of which the laws see a tenth.

use schuler::earth::gravity;
use schuler_simulator::scene::GaussMarkov;
use schuler_simulator::theory::Theory;
use schuler_tests::{at_rest, near};
use std::f64::consts::{FRAC_PI_4, LN_10, PI};

const TIMES: [f64; 7] = [0.05, 0.2, 0.55, 1.3, 3.0, 7.7, 20.0];

/// Variances of the integral of a Gauss-Markov process and of the integral's integral.
fn gauss_markov_variances(rms: f64, t: f64, correlation_s: f64) -> [f64; 2] {
    let x = t / correlation_s;
    let scale = rms * rms * correlation_s * correlation_s;
    if x < 0.05 {
        // x² − x³/3 + x⁴/12;  x⁴/4 − 2x⁵/15 + x⁶/24
        let first = x * x * (1.0 - x / 3.0 + x * x / 12.0);
        let second = x.powi(4) * (0.25 - x * (1.0 / 15.0 - x / 72.0));
        return [scale * first, scale * correlation_s * correlation_s * second];
    }
    let e = (-x).exp();
    let first = 2.0 * (x - 1.0 + e);
    let second = 2.0 * x * x * x / 3.0 - x * x + 2.0 - 2.0 * (1.0 + x) * e;
    [scale * first, scale * correlation_s * correlation_s * second]
}

#[test]
fn gauss_markov_of_any_correlation_time() {
    for correlation_s in [0.01, 0.3, 3.0, 100.0] {
        let mut scene = at_rest(60.0);
        let rms = [0.0, 0.0, 1e-3];
        scene.accelerometer.gauss_markov =
            Some(GaussMarkov { rms, correlation_s: [correlation_s; 3] });
        let mut theory = Theory::new(&scene).unwrap();
        for t in TIMES {
            let [velocity, position] = gauss_markov_variances(1e-3, t, correlation_s);
            let sigma = theory.at(t).sigma;
            let what = format!("T {correlation_s}, t {t}");
            near(sigma.velocity_ned.z, velocity.sqrt(), 1e-3, &what);
            near(sigma.position_ned.z, position.sqrt(), 1e-3, &what);
        }
    }
}

#[test]
fn bias_instability_has_a_pole_per_decade() {
    let mut scene = at_rest(60.0);
    scene.accelerometer.bias_instability = Some([0.0, 0.0, 1e-3]);
    let mut theory = Theory::new(&scene).unwrap();
    // 1200 samples: poles at 1, 10, 100 and 1000 of them
    let rms = 1e-3 * (LN_10 / PI).sqrt();
    for t in TIMES {
        let (mut velocity, mut position) = (0.0, 0.0);
        for correlation_s in [0.05, 0.5, 5.0, 50.0] {
            let [v, p] = gauss_markov_variances(rms, t, correlation_s);
            velocity += v;
            position += p;
        }
        let sigma = theory.at(t).sigma;
        near(sigma.velocity_ned.z, velocity.sqrt(), 1e-3, "velocity");
        near(sigma.position_ned.z, position.sqrt(), 1e-3, "position");
    }
}

#[test]
fn random_walk_of_the_bias() {
    let g = gravity(FRAC_PI_4.sin(), 1000.0);
    let k = 1e-6;
    let mut scene = at_rest(60.0);
    scene.gyro.random_walk = Some([0.0, k, 0.0]);
    scene.accelerometer.random_walk = Some([0.0, 0.0, k]);
    let mut theory = Theory::new(&scene).unwrap();
    for t in TIMES {
        let sigma = theory.at(t).sigma;
        near(sigma.velocity_ned.z, k * (t.powi(3) / 3.0).sqrt(), 1e-3, "down velocity");
        near(sigma.position_ned.z, k * (t.powi(5) / 20.0).sqrt(), 1e-3, "down");
        near(sigma.attitude_ned.y, k * (t.powi(3) / 3.0).sqrt(), 1e-3, "tilt");
        near(sigma.velocity_ned.x, k * g * (t.powi(5) / 20.0).sqrt(), 1e-3, "north velocity");
        near(sigma.position_ned.x, k * g * (t.powi(7) / 252.0).sqrt(), 6e-3, "north");
    }
}

#[test]
fn quantization_is_bounded_and_drives_the_next_integral() {
    let g = gravity(FRAC_PI_4.sin(), 1000.0);
    let (angle, velocity) = (1e-5, 1e-3);
    let mut scene = at_rest(60.0);
    scene.gyro.quantization = Some([0.0, angle, 0.0]);
    let mut theory = Theory::new(&scene).unwrap();
    for t in TIMES {
        let sigma = theory.at(t).sigma;
        let q = angle / 12.0_f64.sqrt();
        near(sigma.attitude_ned.y, q, 1e-3, "tilt");
        near(sigma.velocity_ned.x, g * q * (0.05 * t).sqrt(), 1e-3, "velocity");
        near(sigma.position_ned.x, g * q * (0.05 * t.powi(3) / 3.0).sqrt(), 1e-3, "position");
    }
    scene = at_rest(60.0);
    scene.accelerometer.quantization = Some([0.0, 0.0, velocity]);
    theory = Theory::new(&scene).unwrap();
    for t in TIMES {
        let sigma = theory.at(t).sigma;
        let q = velocity / 12.0_f64.sqrt();
        near(sigma.velocity_ned.z, q, 1e-3, "velocity");
        near(sigma.position_ned.z, q * (0.05 * t).sqrt(), 1e-3, "position");
    }
}
