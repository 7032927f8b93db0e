//! Level and north from a vehicle at rest.

use schuler::alignment::{Alignment, AlignmentError};
use schuler::earth::{gravity, rotation_ned};
use schuler::math::vector::Vector;
use schuler::sample::Increment;
use schuler::solution::Euler;
use schuler_tests::Numbers;
use std::f64::consts::{FRAC_PI_2, PI};

/// What a perfect unit at rest delivers over an interval.
fn at_rest(attitude: Euler<f64>, latitude: f64, interval_s: f64) -> Increment<f64> {
    let (s, c) = latitude.sin_cos();
    let to_body = attitude.quaternion().conjugate().matrix(1.0);
    Increment {
        angle_b: to_body * rotation_ned(s, c) * interval_s,
        velocity_b: to_body * Vector::new(0.0, 0.0, -gravity(s, 100.0)) * interval_s,
    }
}

fn narrow(sample: Increment<f64>) -> Increment<f32> {
    let Increment { angle_b, velocity_b } = sample;
    Increment { angle_b: angle_b.map(|c| c as f32), velocity_b: velocity_b.map(|c| c as f32) }
}

#[test]
fn made_up_attitudes_are_found() {
    let mut numbers = Numbers(61);
    for _ in 0..1000 {
        let attitude = Euler {
            roll: numbers.within(PI),
            pitch: numbers.within(FRAC_PI_2 - 1e-3),
            yaw: numbers.within(PI),
        };
        let latitude = numbers.within(1.5);
        let mut alignment = Alignment::default();
        for _ in 0..20 {
            alignment.add(&at_rest(attitude, latitude, 0.005));
        }
        let found = alignment.attitude().unwrap();
        let turn = found.quaternion() * attitude.quaternion().conjugate();
        assert!(turn.rotation_vector().norm() < 1e-12, "{attitude:?} {found:?}");

        let (rate, force) = alignment.mean(0.005);
        let one = at_rest(attitude, latitude, 1.0);
        assert!((rate - one.angle_b).norm() < 1e-18);
        assert!((force - one.velocity_b).norm() < 1e-13);
    }
}

/// Upright, where roll and yaw turn about the same axis and their sum alone is there to be found.
#[test]
fn upright_units_are_found() {
    let mut numbers = Numbers(63);
    for n in 0..2000 {
        let off = if n % 3 == 0 { 0.0 } else { 10.0_f64.powf(-10.0 + numbers.within(7.0)) };
        let pitch = if n % 2 == 0 { FRAC_PI_2 - off } else { off - FRAC_PI_2 };
        let attitude = Euler { roll: numbers.within(PI), pitch, yaw: numbers.within(PI) };
        let sample = at_rest(attitude, numbers.within(1.2), 0.1);
        let mut alignment = Alignment::default();
        alignment.add(&sample);
        let found = alignment.attitude().unwrap();
        let turn = found.quaternion() * attitude.quaternion().conjugate();
        assert!(turn.rotation_vector().norm() < 1e-12, "{attitude:?} {found:?}");
        let mut single = Alignment::<f32>::default();
        single.add(&narrow(sample));
        let found = single.attitude().unwrap().quaternion().map(f64::from);
        let turn = found * attitude.quaternion().conjugate();
        assert!(turn.rotation_vector().norm() < 2e-6, "{attitude:?} {found:?}");
    }
}

#[test]
fn single_precision_finds_them_too() {
    let attitude = Euler { roll: 0.1, pitch: -0.2, yaw: 2.5 };
    let sample = at_rest(attitude, 0.8, 0.01);
    let mut alignment = Alignment::<f32>::default();
    for _ in 0..100 {
        alignment.add(&narrow(sample));
    }
    let found = alignment.attitude().unwrap();
    for (a, b) in [(found.roll, 0.1), (found.pitch, -0.2), (found.yaw, 2.5)] {
        assert!((f64::from(a) - b).abs() < 2e-6, "{found:?}");
    }
}

/// Errors of the sensors tilt and turn the result as the closed forms say (Groves, §5.6).
#[test]
fn sensor_errors_tilt_and_turn() {
    let latitude: f64 = 0.7;
    let level = Euler { roll: 0.0, pitch: 0.0, yaw: 0.0 };
    let mut sample = at_rest(level, latitude, 1.0);
    sample.velocity_b.y += 1e-4;
    sample.angle_b.y += 1e-9;
    let mut alignment = Alignment::default();
    alignment.add(&sample);
    let found = alignment.attitude().unwrap();
    // Roll −∇/g; heading −ε/(ω cosφ) + ∇ tanφ/g.
    let g = gravity(latitude.sin(), 100.0);
    assert!((found.roll + 1e-4 / g).abs() < 1e-13, "{found:?}");
    let heading = 1e-4 / g * latitude.tan() - 1e-9 / (7.292115e-5 * latitude.cos());
    assert!((found.yaw - heading).abs() < 1e-14, "{found:?} {heading}");
}

#[test]
fn what_determines_nothing_is_an_error() {
    assert_eq!(Alignment::<f64>::default().attitude(), Err(AlignmentError::Empty));
    assert_eq!(Alignment::<f64>::default().mean(1.0).0, Vector::ZERO);
    let tilted = Euler { roll: 0.3, pitch: 0.4, yaw: 1.0 };
    let good = at_rest(tilted, 0.8, 0.01);
    let with = |sample: Increment<f64>| {
        let mut alignment = Alignment::default();
        alignment.add(&sample);
        alignment.attitude()
    };
    assert!(with(good).is_ok());
    let undetermined = Err(AlignmentError::Undetermined);
    let mut numbers = Numbers(62);
    for _ in 0..100 {
        let attitude = Euler {
            roll: numbers.within(PI),
            pitch: numbers.within(FRAC_PI_2),
            yaw: numbers.within(PI),
        };
        for pole in [FRAC_PI_2, -FRAC_PI_2] {
            let sample = at_rest(attitude, pole, 0.01);
            assert_eq!(with(sample), undetermined, "{attitude:?}");
            let mut single = Alignment::<f32>::default();
            single.add(&narrow(sample));
            assert_eq!(single.attitude(), Err(AlignmentError::Undetermined), "{attitude:?}");
        }
    }
    assert_eq!(with(Increment { angle_b: Vector::ZERO, ..good }), undetermined);
    assert_eq!(with(Increment { velocity_b: Vector::ZERO, ..good }), undetermined);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300] {
        for axis in 0..3 {
            let mut sample = good;
            *sample.angle_b.each_mut()[axis] = bad;
            assert_eq!(with(sample), undetermined, "{bad}");
            let mut sample = good;
            *sample.velocity_b.each_mut()[axis] = bad;
            assert_eq!(with(sample), undetermined, "{bad}");
        }
    }
}
