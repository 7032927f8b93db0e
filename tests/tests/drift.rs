//! Solution less truth: against Earth-fixed chords in two-float arithmetic, and across the pole.

use schuler::drift::compare::{Drift, drift};
use schuler::drift::linear::ErrorState;
use schuler::drift::meridian::MeridianShift;
use schuler::earth::{Geodetic, SEMI_MINOR_AXIS};
use schuler::math::compensated::Pair;
use schuler::math::quaternion::Quaternion;
use schuler::math::vector::Vector;
use schuler::solution::{EarthFixedSolution, Euler, Solution};
use schuler::trajectory::{Jet, Motion};
use schuler_tests::Numbers;
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

/// A vehicle with the same velocity and attitude in Earth-fixed axes, some metres to hundreds of kilometres
/// away: about a pole its meridian is quite another one, or there is none, and the drift does not see it.
#[test]
fn the_meridian_about_a_pole_is_no_drift() {
    let mut numbers = Numbers(71);
    let off = [0.0, 1e-16, 1e-12, 1e-7, 1e-4, 0.01, 0.1];
    for (n, off) in off.into_iter().cycle().enumerate().take(700) {
        let sign = if n % 2 == 0 { 1.0 } else { -1.0 };
        let latitude = sign * (FRAC_PI_2 - off);
        let truth = solution(latitude, numbers.within(PI), 1000.0);
        let far = 10.0_f64.powf(-3.0 + numbers.within(8.0));
        let angle = numbers.within(PI);
        let (north, east) = (far * angle.cos(), far * angle.sin());
        let (s, c) = latitude.sin_cos();
        let (sl, cl) = truth.position.longitude.hi.sin_cos();
        let step = Vector::new(-north * s * cl - east * sl, east * cl - north * s * sl, north * c);
        let mut moved = truth.to_earth_fixed();
        moved.position_e = moved.position_e + step.map(Pair::new);
        let seen = drift(&moved.to_local(), &truth);
        let Vector { x, y, .. } = seen.position_ned;
        assert!((x - north).hypot(y - east) <= 1e-8, "{seen:?}");
        // The verticals differ by the distance over the Earth's radius; about them, nothing turns.
        let tilt = 1.01 * far / SEMI_MINOR_AXIS;
        assert!(seen.attitude_ned.norm() <= tilt + 2e-15, "{far} {seen:?}");
        assert!(seen.attitude_ned.z.abs() <= tilt * tilt + 2e-15, "{far} {seen:?}");
        assert!(seen.velocity_ned.norm() <= 142.0 * tilt + 1e-12, "{far} {seen:?}");
    }
}

/// The same rule for every error at one true place: at 84° it changes, whatever the error.
#[test]
fn elsewhere_the_meridian_counts() {
    for (latitude, counts) in [(84.001, false), (83.999, true), (-84.001, false), (-83.999, true)] {
        for east in [1e-9, 0.01] {
            let latitude: f64 = latitude / 180.0 * PI;
            let truth = solution(latitude, 0.2, 0.0);
            let mut computed = truth;
            computed.position.longitude = truth.position.longitude + Pair::new(east);
            let seen = drift(&computed, &truth);
            let turned = if counts { 0.0 } else { east };
            let speed = 120.0_f64.hypot(75.0);
            assert!((seen.velocity_ned.norm() - turned * speed).abs() <= 1e-2 * turned * speed);
            assert!((seen.attitude_ned.norm() - turned).abs() <= 1e-2 * turned + 1e-15);
        }
    }
}

/// A solution that is off by a drift has that drift, at a pole too, and across it.
#[test]
fn what_is_added_is_the_drift() {
    let mut numbers = Numbers(72);
    let off = [0.0, 1e-12, 1e-6, 1e-3, 0.09, 0.11, 0.8, FRAC_PI_2];
    for (n, off) in off.into_iter().cycle().enumerate().take(400) {
        let sign = if n % 2 == 0 { 1.0 } else { -1.0 };
        let truth = solution(sign * (FRAC_PI_2 - off), numbers.within(PI), 1000.0);
        let size = 10.0_f64.powf(numbers.within(4.0));
        let given = Drift {
            position_ned: numbers.vector(size),
            velocity_ned: numbers.vector(10.0),
            attitude_ned: numbers.vector(0.01),
        };
        let seen = drift(&given.added_to(&truth), &truth);
        let apart = (seen.position_ned - given.position_ned).norm();
        assert!(apart <= 3e-9 + 1e-13 * size, "{off} {size} {apart:e}");
        assert!((seen.velocity_ned - given.velocity_ned).norm() <= 1e-13, "{off} {size} {seen:?}");
        assert!((seen.attitude_ned - given.attitude_ned).norm() <= 1e-15, "{off} {size} {seen:?}");
    }
}

/// To first order, theory's shift of the axes is the comparison's: on either side of 84°, and across.
#[test]
fn theory_sees_the_same_shift() {
    for latitude in [80.0, 83.999, 84.001, 89.99, 90.0, 90.01, 97.0, -83.999, -84.001, -90.0, -91.0]
    {
        let jet = |value: f64, first: f64| Jet { value, first, second: 0.0 };
        let motion = Motion {
            roll: jet(0.3, 0.0),
            pitch: jet(-0.2, 0.0),
            yaw: jet(2.0, 0.0),
            latitude: jet(latitude / 180.0 * PI, 1e-5),
            longitude: jet(0.4, 2e-6),
            altitude: jet(3000.0, 1.0),
        };
        let truth = motion.initial();
        let shift = MeridianShift::new(&motion);
        for axis in 0..3 {
            let mut moved = [0.0; 3];
            moved[axis] = 1e-3;
            let moved = Vector::from(moved);
            let attitude = moved * 1e-2;
            let error = ErrorState { position: moved, velocity: Vector::ZERO, attitude };
            let expected = shift.drift(&error);
            // The same along the axes of the printed position, in Earth-fixed components.
            let at = truth.to_earth_fixed();
            let facing = expected.position_ned;
            let (s, c) = truth.position.latitude.hi.sin_cos();
            let (sl, cl) = truth.position.longitude.hi.sin_cos();
            let to_earth = |n: Vector<f64>| {
                let outward = -(n.x * s) - n.z * c;
                Vector::new(outward * cl - n.y * sl, outward * sl + n.y * cl, n.x * c - n.z * s)
            };
            let step = to_earth(facing);
            let half = step * 0.5e-2;
            let turn = Quaternion::new((1.0 - half.dot(half)).sqrt(), half).map(Pair::new);
            let computed = EarthFixedSolution {
                position_e: at.position_e + step.map(Pair::new),
                attitude: turn * at.attitude,
                ..at
            };
            let seen = drift(&computed.to_local(), &truth);
            // An Earth-fixed double resolves 1e-9 m, which is what a meridian at 84° makes of it.
            let apart = (seen.attitude_ned - expected.attitude_ned).norm();
            assert!(apart < 2e-12, "{latitude} {axis} {apart:e} {seen:?} {expected:?}");
            let apart = (seen.velocity_ned - expected.velocity_ned).norm();
            assert!(apart < 1e-9, "{latitude} {axis} {apart:e} {seen:?} {expected:?}");
        }
    }
}
