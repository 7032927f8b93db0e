//! Further states left alone, uncertainties added and the limit of an alignment, against closed forms.

use schuler::aiding::alignment::limit::Limit;
use schuler::aiding::covariance::ud::Ud;
use schuler::aiding::filter::Filter15;
use schuler::aiding::model::Model;
use schuler::aiding::states::{Process, resonator::Resonator};
use schuler::aiding::surroundings::{Pose, Surroundings};
use schuler::aiding::transition::{Stretch, Transition};
use schuler::prelude::*;
use schuler::units::DEGREE;

const STEP_S: f64 = 0.1;

#[test]
fn a_gauss_markov_process_left_alone_keeps_its_spread_and_forgets() {
    let (rms, correlation_s) = (3.0, 7.0);
    let process = Process::gauss_markov(rms, correlation_s);
    let mut ud = Ud::<f64, 21, 231>::diagonal([1.0; 21]);
    let mut left = 1.0;
    for step in 1..=200 {
        left *= process.advance(&mut ud, 15, STEP_S);
        // From σ² = 1: rms² + (1 − rms²)exp(−2t/τ).
        let faded = (-STEP_S * f64::from(step) / correlation_s).exp();
        let expected = rms * rms + (1.0 - rms * rms) * faded * faded;
        assert!((ud.variance(15) / expected - 1.0).abs() < 1e-13, "{step}: {}", ud.variance(15));
        assert!((left / faded - 1.0).abs() < 1e-13);
    }
}

#[test]
fn an_estimated_sway_swings_out() {
    let sway = Resonator { rms_m: 0.3_f64, rate: 0.9, damping: 0.05 };
    let mut ud = Ud::<f64, 21, 231>::diagonal([0.3; 21]);
    let transition = Transition::new(&Stretch { time_s: STEP_S, ..Stretch::NONE });
    let (start, speed) = ([0.4, -0.2, 0.0], [0.0, 0.1, -0.3]);
    let mut estimate = [start[0], start[1], start[2], speed[0], speed[1], speed[2]];
    let Resonator { rate, damping, .. } = sway;
    let damped = rate * (1.0 - damping * damping).sqrt();
    for step in 1..=300 {
        sway.advance(&mut ud, 15, &mut estimate, &transition);
        let t = STEP_S * f64::from(step);
        let (sine, cosine) = (damped * t).sin_cos();
        let left = (-damping * rate * t).exp();
        for axis in 0..3 {
            // ẍ + 2ζwẋ + w²x = 0
            let (x, v) = (start[axis], speed[axis]);
            let expected = left * (x * cosine + (v + damping * rate * x) / damped * sine);
            let pace = left * (v * cosine - (rate * rate * x + damping * rate * v) / damped * sine);
            assert!((estimate[axis] - expected).abs() < 1e-13, "{step}: {estimate:?}");
            assert!((estimate[axis + 3] - pace).abs() < 1e-13, "{step}: {estimate:?}");
        }
    }
}

#[test]
fn an_added_uncertainty_is_turned_into_body_axes() {
    let none = Process::constant(0.0);
    let mut filter = Filter15::<f64>::new(&Model::new(0.0, 0.0, none, none));
    let attitude = Euler { roll: 0.4, pitch: -0.3, yaw: 2.0 }.quaternion();
    let pose = Pose { body_to_ned: attitude.matrix(1.0), velocity_ned: Vector::ZERO };
    let sigma = [0.02, 0.5, 3.0];
    for first in [0, 3, 6] {
        filter.add_uncertainty(first, Vector::from(sigma), &pose);
        let ned = pose.body_to_ned.rows.map(Vector::into_array);
        for i in 0..3 {
            for j in 0..3 {
                let expected: f64 =
                    (0..3).map(|k| ned[k][i] * ned[k][j] * sigma[k] * sigma[k]).sum();
                let covariance = filter.covariance().covariance(first + i, first + j);
                assert!((covariance - expected).abs() < 1e-14, "{first} {i} {j}: {covariance}");
            }
        }
    }
}

#[test]
fn the_limit_of_an_alignment_is_its_closed_form() {
    let limit = Limit {
        gyro_noise: 6e-7,
        accelerometer_noise: 1e-4,
        gyro_bias: 0.0,
        accelerometer_bias: 0.0,
    };
    let at = Geodetic { latitude: 45.0 * DEGREE, longitude: 0.0, altitude: 0.0 };
    let here = Surroundings::at(&at);
    let tau = limit.accelerometer_noise / (here.gravity * limit.gyro_noise);
    for time_s in [4.0, 10.0, 60.0, 300.0, 3000.0_f64] {
        // N²/(T − 2τ tanh(T/2τ))
        let left = time_s - 2.0 * tau * (time_s / (2.0 * tau)).tanh();
        let expected = limit.gyro_noise / left.sqrt() / here.earth_rate_ned.x;
        let heading = limit.heading_turning(&here, time_s);
        assert!((heading / expected - 1.0).abs() < 1e-12, "{time_s} s: {heading:e} {expected:e}");
        assert!((limit.heading(&here, time_s) / expected - 1.0).abs() < 1e-12);
    }
}
