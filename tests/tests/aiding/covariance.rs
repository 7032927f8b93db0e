//! Six scenes in which covariances have failed elsewhere: single precision's gains against the optimum.
//!
//! The true covariance of gains, whatever they are, follows from Joseph's form in double precision.

use super::dense::{self, N};
use super::factors::matrices;
use schuler::aiding::covariance::ud::Ud;
use schuler::aiding::measurement;
use schuler::aiding::transition::{StepNoise, Stretch, Transition};
use schuler::prelude::*;
use schuler::units::{DEGREE, DEGREE_PER_HOUR, MICRO_G};

const STEP_S: f64 = 0.1;

#[derive(Clone, Copy)]
pub struct Case {
    pub name: &'static str,
    moving: bool,
    /// °/√h, m/s/√h.
    noise: [f64; 2],
    /// °/h, m/s².
    bias: [f64; 2],
    /// m, m/s; 0: none.
    fix: [f64; 2],
    /// Steps from fix to fix.
    every: usize,
    /// m, m/s, rad, rad.
    start: [f64; 4],
    /// Noise of the biases per √s, as a fraction of them.
    walk: f64,
}

pub const CASES: [Case; 6] = [
    Case {
        name: "a drive with fixes of 1 m",
        moving: true,
        noise: [0.1, 0.05],
        bias: [10.0, 1e-3],
        fix: [1.0, 0.05],
        every: 10,
        start: [1.0, 0.1, 0.0035, 0.035],
        walk: 0.0,
    },
    Case {
        name: "RTK of 1 cm at 10 Hz, from 100 m and an unknown heading",
        moving: true,
        noise: [0.1, 0.05],
        bias: [10.0, 1e-3],
        fix: [0.01, 0.0],
        every: 1,
        start: [100.0, 10.0, 0.02, 1.0],
        walk: 0.0,
    },
    Case {
        name: "static RTK of 1 cm at 10 Hz",
        moving: false,
        noise: [0.1, 0.05],
        bias: [10.0, 1e-3],
        fix: [0.01, 0.0],
        every: 1,
        start: [100.0, 10.0, 0.02, 1.0],
        walk: 0.0,
    },
    Case {
        name: "almost no noise",
        moving: true,
        noise: [1e-4, 1e-4],
        bias: [10.0, 1e-3],
        fix: [1e-3, 0.0],
        every: 1,
        start: [100.0, 10.0, 0.02, 1.0],
        walk: 0.0,
    },
    Case {
        name: "a navigation-grade unit at rest",
        moving: false,
        noise: [0.002, 0.0059],
        bias: [0.01, 50.0 * MICRO_G],
        fix: [0.0, 1e-4],
        every: 1,
        start: [1.0, 0.1, 0.01, 0.1],
        walk: 0.0,
    },
    Case {
        name: "a MEMS unit whose biases walk",
        moving: true,
        noise: [0.3, 0.1],
        bias: [100.0, 0.02],
        fix: [2.0, 0.1],
        every: 10,
        start: [10.0, 1.0, 0.05, 0.5],
        walk: 0.01,
    },
];

/// The body's motion over a step: figures of eight, or none.
fn stretch(moving: bool, step: usize) -> Stretch<f64> {
    let rest = Vector::new(0.0, 0.0, -9.8);
    let (rate, force) = if moving {
        let t = (step as f64 + 0.5) * STEP_S;
        let wave = |period: f64, phase: f64| (core::f64::consts::TAU * t / period + phase).sin();
        let turn = -70.0 * DEGREE * core::f64::consts::TAU / 120.0 * wave(120.0, 0.3);
        (
            Vector::new(0.005 * wave(23.0, 0.1), 0.004 * wave(37.0, 0.7), turn),
            rest + Vector::new(1.4 * wave(60.0, 0.0), 20.0 * turn, 0.3 * wave(13.0, 0.0)),
        )
    } else {
        (Vector::new(0.0, 0.0, 0.0), rest)
    };
    Stretch {
        time_s: STEP_S,
        rotation: Quaternion::new(0.0, rate * (0.5 * STEP_S)).normalised_less_one(),
        velocity: force * STEP_S,
        position: force * (0.5 * STEP_S * STEP_S),
    }
}

fn narrowed(wide: &Stretch<f64>) -> Stretch<f32> {
    let narrow = |x: f64| x as f32;
    Stretch {
        time_s: wide.time_s as f32,
        rotation: wide.rotation.map(narrow),
        velocity: wide.velocity.map(narrow),
        position: wide.position.map(narrow),
    }
}

/// The rows of a fix.
fn rows(case: &Case) -> Vec<([f64; N], f64)> {
    let lever = Vector::new(0.5, -0.3, -1.0);
    let mut rows = Vec::new();
    let mut take = |vector: schuler::aiding::gate::Rows<f64, N, 3>| {
        rows.extend(vector.rows.into_iter().zip(vector.variance));
    };
    if case.fix[0] > 0.0 {
        take(measurement::position(Vector::ZERO, lever, case.fix[0]));
    }
    if case.fix[1] > 0.0 {
        take(measurement::zero_velocity(Vector::ZERO, Vector::ZERO, case.fix[1]));
    }
    rows
}

/// What became of a case.
pub struct Outcome {
    /// The largest true σ of the gains of single precision over the optimal σ.
    pub over_optimal: f64,
    /// The largest difference of the claimed σ from the one of double precision, relative.
    pub claimed: f64,
    pub negative: bool,
}

pub fn fly(case: &Case, steps: usize) -> Outcome {
    let [p, v, tilt, heading] = case.start;
    let gyro = case.bias[0] * DEGREE_PER_HOUR;
    let force = case.bias[1];
    let sigmas = [p, p, p, v, v, v, tilt, tilt, heading, gyro, gyro, gyro, force, force, force];
    let noise =
        StepNoise { gyro: case.noise[0] * DEGREE / 60.0, accelerometer: case.noise[1] / 60.0 };
    let narrow_noise =
        StepNoise { gyro: noise.gyro as f32, accelerometer: noise.accelerometer as f32 };
    let mut single = Ud::<f32, N, 120>::diagonal(sigmas.map(|x| x as f32));
    let mut double = Ud::<f64, N, 120>::diagonal(sigmas);
    let (mut truth, mut optimum) = (dense::diagonal(sigmas), dense::diagonal(sigmas));
    let measured = rows(case);
    let mut outcome = Outcome { over_optimal: 0.0, claimed: 0.0, negative: false };
    for step in 0..steps {
        let wide = stretch(case.moving, step);
        let transition = Transition::new(&wide);
        single.propagate(&Transition::new(&narrowed(&wide)), &narrow_noise);
        double.propagate(&transition, &noise);
        let phi = matrices(&transition);
        for p in [&mut truth, &mut optimum] {
            *p = dense::mapped(&phi, p);
            step_noise(p, &wide, &transition, &noise);
        }
        if case.walk > 0.0 && step % 10 == 9 {
            for n in 9..N {
                let q = (case.walk * sigmas[n]).powi(2);
                single.add_variance(n, q as f32);
                double.add_variance(n, q);
                truth[n][n] += q;
                optimum[n][n] += q;
            }
        }
        if step % case.every != case.every - 1 {
            continue;
        }
        for (h, r) in &measured {
            let gain = single.measure(&h.map(|x| x as f32), *r as f32);
            let k = gain.along.map(|x| f64::from(x) / f64::from(gain.variance));
            truth = dense::measured(&truth, h, &k, *r);
            let best = dense::gain(&optimum, h, *r);
            optimum = dense::measured(&optimum, h, &best, *r);
            double.measure(h, *r);
        }
        outcome.negative |= (0..N).any(|n| single.column(n).1 < 0.0);
        if step > steps / 100 && step % 50 == 49 {
            for n in 0..N {
                let over = (truth[n][n] / optimum[n][n]).sqrt();
                outcome.over_optimal = outcome.over_optimal.max(over);
                let claimed = (f64::from(single.sigma(n)) / double.sigma(n) - 1.0).abs();
                outcome.claimed = outcome.claimed.max(claimed);
                // The factors in double precision are the optimum itself.
                let apart = (double.variance(n) / optimum[n][n] - 1.0).abs();
                assert!(apart < 1e-4, "{}: step {step}, state {n}: {apart:e}", case.name);
            }
        }
    }
    outcome
}

/// G·Q·Gᵀ.
fn step_noise(
    p: &mut dense::Matrix,
    stretch: &Stretch<f64>,
    transition: &Transition<f64>,
    noise: &StepNoise<f64>,
) {
    let half = *transition.back() * stretch.velocity * 0.5;
    for axis in 0..3 {
        let e = [0, 1, 2].map(|n| f64::from(u8::from(n == axis)));
        let v = Vector::new(e[0], e[1], e[2]).cross(half);
        let angle = [0.0, 0.0, 0.0, v.x, v.y, v.z, e[0], e[1], e[2]];
        dense::add(p, noise.gyro * noise.gyro * STEP_S, &angle);
        let r = e.map(|x| 0.5 * STEP_S * x);
        let force = [r[0], r[1], r[2], e[0], e[1], e[2]];
        dense::add(p, noise.accelerometer * noise.accelerometer * STEP_S, &force);
    }
}

#[test]
fn single_precision_is_as_good_as_the_optimum() {
    for case in &CASES {
        let outcome = fly(case, 3000);
        assert!(!outcome.negative, "{}", case.name);
        assert!(outcome.over_optimal <= 1.001, "{}: {}", case.name, outcome.over_optimal);
        assert!(outcome.claimed <= 1e-3, "{}: {:e}", case.name, outcome.claimed);
    }
}
