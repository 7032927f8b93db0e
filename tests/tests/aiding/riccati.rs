//! What theory allows on the drive: the covariance of errors in north, east and down by the textbook, along the truth,
//! as a full matrix in double precision. Nothing of it is the filter's.

use super::dense::{self, Matrix, N};
use super::drive::{
    ACCELEROMETER_BIAS, ACCELEROMETER_NOISE, GYRO_BIAS, GYRO_NOISE, LEVER, OUTAGE, POSITION_SIGMA,
    RATE_HZ, VELOCITY_SIGMA, course,
};
use schuler::earth::{self, Radii, gradient};
use schuler::prelude::*;
use schuler::trajectory::Trajectory;
use schuler::units::DEGREE;

/// Seconds of a step.
const STEP_S: f64 = 0.1;

/// Puts k·[a×] into a matrix.
fn cross(matrix: &mut Matrix, row: usize, column: usize, k: f64, a: Vector<f64>) {
    let skew = [[0.0, -a.z, a.y], [a.z, 0.0, -a.x], [-a.y, a.x, 0.0]];
    for (i, cells) in skew.into_iter().enumerate() {
        for (j, x) in cells.into_iter().enumerate() {
            matrix[row + i][column + j] += k * x;
        }
    }
}

/// What the errors depend on, at an instant.
struct Here {
    to_ned: [[f64; 3]; 3],
    force_ned: Vector<f64>,
    lever_ned: Vector<f64>,
    swing_ned: Vector<f64>,
    earth_rate: Vector<f64>,
    transport_rate: Vector<f64>,
    gradient: [f64; 3],
}

fn here(time_s: f64) -> Here {
    let flight = course();
    let at = Pair::new(time_s);
    let (solution, rates) = (flight.initial_at(at), flight.rates_at(at));
    let matrix = solution.attitude.map(|c| c.hi).matrix(1.0);
    let (latitude, altitude) = (solution.position.latitude.hi, solution.position.altitude.hi);
    let (s, c) = (latitude.sin(), latitude.cos());
    let radii = Radii::at(s, c);
    let (north, east) = (radii.meridian + altitude, radii.prime_vertical + altitude);
    let v = solution.velocity_ned.map(|c| c.hi);
    let gravity = earth::gravity(s, altitude);
    let (_, per_height) = gradient::of_gravity(s, c, altitude);
    let earth_rate = earth::rotation_ned(s, c);
    let rate_eb_b = rates.rate_ib_b - matrix.transpose() * earth_rate;
    Here {
        to_ned: matrix.rows.map(Vector::into_array),
        force_ned: matrix * rates.specific_force_b,
        lever_ned: matrix * LEVER,
        swing_ned: matrix * rate_eb_b.cross(LEVER),
        earth_rate,
        transport_rate: Vector::new(v.y / east, -v.x / north, -v.y * s / c / east),
        gradient: [-gravity / north, -gravity / east, -per_height],
    }
}

/// exp(FT) to its second order, over a step about an instant.
fn transition(here: &Here) -> Matrix {
    let mut f = dense::zero();
    let coriolis = here.earth_rate + here.earth_rate + here.transport_rate;
    cross(&mut f, 0, 0, -1.0, here.transport_rate);
    cross(&mut f, 3, 3, -1.0, coriolis);
    cross(&mut f, 3, 6, -1.0, here.force_ned);
    cross(&mut f, 6, 6, -1.0, here.earth_rate + here.transport_rate);
    for i in 0..3 {
        f[i][3 + i] += 1.0;
        f[3 + i][i] += here.gradient[i];
        for j in 0..3 {
            f[6 + i][9 + j] += here.to_ned[i][j];
            f[3 + i][12 + j] += here.to_ned[i][j];
        }
    }
    let mut phi = dense::diagonal([1.0; N]);
    for i in 0..N {
        for j in 0..N {
            let square: f64 = (0..N).map(|k| f[i][k] * f[k][j]).sum();
            phi[i][j] += f[i][j] * STEP_S + square * (0.5 * STEP_S * STEP_S);
        }
    }
    phi
}

/// The rows of a fix, with their variances.
fn rows(here: &Here, velocity: bool) -> Vec<([f64; N], f64)> {
    let mut h = dense::zero();
    cross(&mut h, 0, 6, -1.0, here.lever_ned);
    cross(&mut h, 3, 6, -1.0, here.swing_ned);
    let lever = LEVER.into_array();
    for i in 0..3 {
        h[i][i] = 1.0;
        h[3 + i][3 + i] = 1.0;
        // C(b × l)
        let c = here.to_ned[i];
        let l = lever;
        h[3 + i][9] = c[2] * l[1] - c[1] * l[2];
        h[3 + i][10] = c[0] * l[2] - c[2] * l[0];
        h[3 + i][11] = c[1] * l[0] - c[0] * l[1];
    }
    let variances = [POSITION_SIGMA, VELOCITY_SIGMA].map(|sigma| sigma * sigma);
    let count = if velocity { 6 } else { 3 };
    (0..count).map(|n| (h[n], variances[n / 3])).collect()
}

/// Root mean squares as of [`Figures`](super::figures::Figures): position, velocity, tilt, heading from 120 to 400 s, and
/// position at the end of the outage.
pub fn optimum(velocity: bool) -> [f64; 5] {
    let level = 0.2 * DEGREE;
    let sigmas = [
        [POSITION_SIGMA; 3],
        [0.1; 3],
        [level, level, 2.0 * DEGREE],
        [GYRO_BIAS; 3],
        [ACCELEROMETER_BIAS; 3],
    ];
    let mut p = dense::diagonal(core::array::from_fn(|n| sigmas[n / 3][n % 3]));
    let (mut sums, mut count, mut end) = ([0.0; 4], 0.0, 0.0);
    let every = (1.0 / STEP_S).round() as usize;
    assert_eq!(RATE_HZ * STEP_S, 10.0);
    for step in 1..=(OUTAGE[1] / STEP_S).round() as usize {
        let now = here((step as f64 - 0.5) * STEP_S);
        let phi = transition(&now);
        p = dense::mapped(&phi, &p);
        for axis in 0..3 {
            let half = now.force_ned * (0.5 * STEP_S);
            let along = Vector::from(now.to_ned.map(|row| row[axis]));
            let (a, v) = (along.into_array(), along.cross(half).into_array());
            let gyro = [0.0, 0.0, 0.0, v[0], v[1], v[2], a[0], a[1], a[2]];
            dense::add(&mut p, GYRO_NOISE * GYRO_NOISE * STEP_S, &gyro);
            let r = a.map(|x| 0.5 * STEP_S * x);
            let force = [r[0], r[1], r[2], a[0], a[1], a[2]];
            dense::add(&mut p, ACCELEROMETER_NOISE * ACCELEROMETER_NOISE * STEP_S, &force);
        }
        let second = step as f64 * STEP_S;
        if step % every == 0 && !(second > OUTAGE[0] && second <= OUTAGE[1]) {
            for (h, r) in rows(&here(second), velocity) {
                let gain = dense::gain(&p, &h, r);
                p = dense::measured(&p, &h, &gain, r);
            }
        }
        let trace = |from: usize, to: usize| (from..to).map(|n| p[n][n]).sum::<f64>();
        if step % every == 0 && (120.0..=400.0).contains(&second) {
            for (sum, x) in
                sums.iter_mut().zip([trace(0, 3), trace(3, 6), trace(6, 8), trace(8, 9)])
            {
                *sum += x;
            }
            count += 1.0;
        }
        end = trace(0, 3).sqrt();
    }
    let [a, b, c, d] = sums.map(|sum| (sum / count).sqrt());
    [a, b, c, d, end]
}
