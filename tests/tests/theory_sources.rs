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

/// Variances of velocity and position by the discrete recursion of `schuler::sensor::bandwidth` for white noise.
fn white_behind_a_lag(n: f64, lag_s: f64, interval_s: f64, samples: usize) -> [f64; 2] {
    let h = interval_s / lag_s;
    let u = 1.0 - (-h).exp();
    // Covariance of follower, velocity, position.
    let mut p = [[0.0; 3]; 3];
    for sample in 0..samples {
        let first = sample == 0;
        let (keep, share) = if first { (0.0, 0.0) } else { (1.0 - u, u / h) };
        // out = X + share(Y − X); Y += u(X − Y); v += out; x += Δt(v + out/2)
        let a = [[keep, 0.0, 0.0], [share, 1.0, 0.0], [0.5 * interval_s * share, interval_s, 1.0]];
        let b = [1.0 - keep, 1.0 - share, 0.5 * interval_s * (1.0 - share)];
        let q = n * n * interval_s;
        p = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let turned: f64 = (0..9).map(|k| a[i][k / 3] * p[k / 3][k % 3] * a[j][k % 3]).sum();
                turned + b[i] * b[j] * q
            })
        });
    }
    [p[1][1], p[2][2]]
}

/// The same of a bias that moves, in steps so short that the integral is one.
fn bias_behind_a_lag(start: f64, density: f64, decay: f64, lag_s: f64, time_s: f64) -> [f64; 2] {
    let step = 2e-4;
    // Covariance of b, y, velocity, position; b′ = −decay·b + noise, y′ = (b − y)/T.
    let mut p = [[0.0; 4]; 4];
    (p[0][0], p[0][1], p[1][0], p[1][1]) = (start, start, start, start);
    let f = [
        [-decay, 0.0, 0.0, 0.0],
        [1.0 / lag_s, -1.0 / lag_s, 0.0, 0.0],
        [0.0, 1.0, 0.0, 0.0],
        [0.0, 0.0, 1.0, 0.0],
    ];
    let rate = |p: &[[f64; 4]; 4]| -> [[f64; 4]; 4] {
        std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let grown: f64 = (0..4).map(|k| f[i][k] * p[k][j] + p[i][k] * f[j][k]).sum();
                grown + if (i, j) == (0, 0) { density } else { 0.0 }
            })
        })
    };
    for _ in 0..(time_s / step).round() as usize {
        // The midpoint rule.
        let k = rate(&p);
        let middle: [[f64; 4]; 4] =
            std::array::from_fn(|i| std::array::from_fn(|j| p[i][j] + 0.5 * step * k[i][j]));
        let k = rate(&middle);
        for (p, k) in p.as_flattened_mut().iter_mut().zip(k.as_flattened()) {
            *p += step * k;
        }
    }
    [p[2][2], p[3][3]]
}

#[test]
fn white_noise_behind_a_bandwidth() {
    for frequency_hz in [0.01, 0.1, 0.5, 2.0, 1e3] {
        let mut scene = at_rest(60.0);
        let n = 1e-3;
        scene.accelerometer.white = Some([0.0, 0.0, n]);
        scene.accelerometer.bandwidth = Some([frequency_hz; 3]);
        let mut theory = Theory::new(&scene).unwrap();
        let lag_s = 1.0 / (2.0 * PI * frequency_hz);
        for t in TIMES {
            let samples = (t * scene.rate_hz).round() as usize;
            let [velocity, position] = white_behind_a_lag(n, lag_s, 1.0 / scene.rate_hz, samples);
            let sigma = theory.at(t).sigma;
            let what = format!("f {frequency_hz}, t {t}");
            near(sigma.velocity_ned.z, velocity.sqrt(), 4e-3, &what);
            if t > 0.2 {
                near(sigma.position_ned.z, position.sqrt(), 4e-3, &what);
            }
        }
    }
}

#[test]
fn biases_behind_a_bandwidth() {
    for (frequency_hz, correlation_s) in
        [(0.1, 0.2), (0.1, 3.0), (0.02, 1.0), (1.0, 0.5), (0.5, 40.0)]
    {
        let lag_s = 1.0 / (2.0 * PI * frequency_hz);
        let mut scene = at_rest(60.0);
        // So that the first sample is short.
        scene.rate_hz = 1000.0;
        let rms = 1e-3;
        scene.accelerometer.gauss_markov =
            Some(GaussMarkov { rms: [0.0, 0.0, rms], correlation_s: [correlation_s; 3] });
        scene.accelerometer.bandwidth = Some([frequency_hz; 3]);
        let mut theory = Theory::new(&scene).unwrap();
        let mut walking = at_rest(60.0);
        walking.rate_hz = 1000.0;
        walking.accelerometer.random_walk = Some([0.0, 0.0, rms]);
        walking.accelerometer.bandwidth = Some([frequency_hz; 3]);
        let mut walk = Theory::new(&walking).unwrap();
        for t in &TIMES[1..] {
            let what = format!("f {frequency_hz}, T {correlation_s}, t {t}");
            let density = 2.0 * rms * rms / correlation_s;
            let [velocity, position] =
                bias_behind_a_lag(rms * rms, density, 1.0 / correlation_s, lag_s, *t);
            let sigma = theory.at(*t).sigma;
            near(sigma.velocity_ned.z, velocity.sqrt(), 5e-3, &what);
            near(sigma.position_ned.z, position.sqrt(), 5e-3, &what);
            // Before that the first sample, which the bandwidth takes as it is, is a good part of it.
            if *t < 4.0 * lag_s {
                continue;
            }
            let [velocity, position] = bias_behind_a_lag(0.0, rms * rms, 0.0, lag_s, *t);
            let sigma = walk.at(*t).sigma;
            near(sigma.velocity_ned.z, velocity.sqrt(), 5e-3, &what);
            near(sigma.position_ned.z, position.sqrt(), 5e-3, &what);
        }
    }
}
