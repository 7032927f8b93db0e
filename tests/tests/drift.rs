//! Solution less truth: against Earth-fixed chords in two-float arithmetic, and across the pole.

use schuler::drift::compare::{Drift, drift};
use schuler::earth::Geodetic;
use schuler::math::compensated::Pair;
use schuler::math::quaternion::Quaternion;
use schuler::math::vector::Vector;
use schuler::solution::{Euler, Solution};
use std::f64::consts::{FRAC_PI_2, PI};

fn solution(latitude: f64, longitude: f64, altitude: f64) -> Solution<f64> {
    let attitude = Euler { roll: 0.3, pitch: -0.2, yaw: 2.0 };
    let position = Geodetic { latitude, longitude, altitude };
    Solution::new(position, Vector::new(120.0, -75.0, 3.0), attitude)
}

/// The chord's north and east components, about thirty digits deep.
fn chord(computed: &Solution<f64>, truth: &Solution<f64>) -> [f64; 2] {
    let (a, b) = (computed.to_earth_fixed().position_e, truth.to_earth_fixed().position_e);
    let chord = a - b;
    let (s, c) = truth.position.latitude.sin_cos();
    let (sl, cl) = truth.position.longitude.sin_cos();
    let outward = chord.x * cl + chord.y * sl;
    [(chord.z * c - outward * s).widen(), (chord.y * cl - chord.x * sl).widen()]
}

#[test]
fn position_resolves_a_tenth_of_a_nanometre() {
    let latitudes = [0.0, 0.5, -1.2, 1.57, FRAC_PI_2 - 1e-6, -FRAC_PI_2 + 1e-9];
    let steps = [0.0, 3e-17, -2e-13, 1e-8, -7e-5, 2e-3];
    for latitude in latitudes {
        for north in steps {
            for east in steps.into_iter().chain([2.5, PI]) {
                let truth = solution(latitude, 0.4, 3000.0);
                let mut computed = solution(latitude, 0.4, 3001.5);
                let add = |x: &mut Pair<f64>, d| *x = *x + Pair::new(d);
                add(&mut computed.position.latitude, north);
                add(&mut computed.position.longitude, east);
                if computed.position.latitude.hi.abs() > FRAC_PI_2 {
                    continue;
                }
                let Vector { x, y, z } = drift(&computed, &truth).position_ned;
                let [n, e] = chord(&computed, &truth);
                let tolerance = 1e-10 + 1e-15 * n.hypot(e);
                assert!((x - n).abs() <= tolerance, "north at {latitude}: {x}, {n}");
                assert!((y - e).abs() <= tolerance, "east at {latitude}: {y}, {e}");
                assert_eq!(z, -1.5);
            }
        }
    }
}

#[test]
fn no_difference_is_zero() {
    let truth = solution(0.8, -3.0, 10.0);
    let Drift { position_ned, velocity_ned, attitude_ned } = drift(&truth, &truth);
    assert_eq!([position_ned, velocity_ned], [Vector::ZERO; 2]);
    assert!(attitude_ned.norm() < 1e-15);
}

#[test]
fn velocity_and_attitude_against_their_own_axes() {
    let truth = solution(0.8, -3.0, 10.0);
    let mut computed = truth;
    computed.position.longitude = computed.position.longitude + Pair::new(0.001);
    computed.velocity_ned.y = computed.velocity_ned.y + Pair::new(1e-20);
    computed.velocity_ned.z = computed.velocity_ned.z + Pair::new(0.25);
    // From the true to the computed body frame, about an axis in north, east, down
    let turn = Vector::<f64>::new(1e-3, -2e-3, 5e-4);
    let angle: f64 = turn.norm();
    let step = Quaternion::new((angle / 2.0).cos(), turn * ((angle / 2.0).sin() / angle));
    computed.attitude = step.map(Pair::new) * computed.attitude;
    let Drift { velocity_ned, attitude_ned, .. } = drift(&computed, &truth);
    assert_eq!(velocity_ned, Vector::new(0.0, 1e-20, 0.25));
    assert!((attitude_ned - turn).norm() < 1e-15, "{attitude_ned:?}");
}

/// A vehicle a few metres away, with the same velocity and attitude in Earth-fixed axes: next to a pole
/// its meridian is quite another one.
#[test]
fn the_meridian_at_a_pole_is_no_attitude_error() {
    for sign in [1.0, -1.0] {
        let truth = solution(sign * (FRAC_PI_2 - 1e-7), 0.2, 0.0);
        for (x, y) in [(0.5, 0.2), (-2.0, 0.1), (-0.9, -1.5), (0.0, 3.0), (-30.0, 4.0)] {
            let mut moved = truth.to_earth_fixed();
            moved.position_e = moved.position_e + Vector::new(x, y, 0.0).map(Pair::new);
            let seen = drift(&moved.to_local(), &truth);
            let Vector { x: north, y: east, .. } = seen.position_ned;
            assert!((north.hypot(east) - f64::hypot(x, y)).abs() < 1e-3, "{seen:?}");
            // The verticals differ by metres over the Earth's radius: by 5e-6 rad at most.
            assert!(seen.velocity_ned.norm() < 142.0 * 5e-6, "{seen:?}");
            assert!(seen.attitude_ned.norm() < 5e-6, "{seen:?}");
        }
    }
}

/// Where the error is small beside the distance from the axis, the meridian is part of the attitude.
#[test]
fn elsewhere_the_meridian_counts() {
    let truth = solution(FRAC_PI_2 - 1e-3, 0.2, 0.0);
    let mut computed = truth;
    computed.position.longitude = truth.position.longitude + Pair::new(0.01);
    let seen = drift(&computed, &truth);
    assert_eq!(seen.velocity_ned, Vector::ZERO);
    assert!(seen.attitude_ned.norm() < 1e-15);
}
