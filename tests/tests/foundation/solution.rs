//! Position, velocity and attitude in local and in Earth-fixed axes.

use schuler::earth::Geodetic;
use schuler::math::compensated::Pair;
use schuler::math::quaternion::Quaternion;
use schuler::math::vector::Vector;
use schuler::solution::{Euler, Solution};
use schuler_tests::Numbers;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_6, PI};

/// Rows of C_nᵇ = Rx(γ)·Ry(θ)·Rz(ψ), written out.
fn rows([roll, pitch, yaw]: [f64; 3]) -> [[f64; 3]; 3] {
    let ((sr, cr), (sp, cp), (sy, cy)) = (roll.sin_cos(), pitch.sin_cos(), yaw.sin_cos());
    [
        [cp * cy, cp * sy, -sp],
        [sr * sp * cy - cr * sy, sr * sp * sy + cr * cy, sr * cp],
        [cr * sp * cy + sr * sy, cr * sp * sy - sr * cy, cr * cp],
    ]
}

/// The largest difference of a body-to-navigation quaternion's matrix from given angles.
fn apart(q: Quaternion<f64>, angles: [f64; 3]) -> f64 {
    let rotation = q.conjugate().matrix(1.0).rows.map(Vector::into_array);
    let pairs = rotation.iter().flatten().zip(rows(angles).into_iter().flatten());
    pairs.fold(0.0, |most, (a, b)| (a - b).abs().max(most))
}

#[test]
fn angles_to_quaternion_and_back() {
    let mut numbers = Numbers(41);
    for _ in 0..2000 {
        let angles = [numbers.within(PI), numbers.within(FRAC_PI_2 - 1e-3), numbers.within(PI)];
        let [roll, pitch, yaw] = angles;
        let euler = Euler { roll, pitch, yaw };
        let q = euler.quaternion();
        assert!(apart(q, angles) <= 1e-15);
        let back = Euler::from_quaternion(q);
        for (a, b) in [(back.roll, roll), (back.pitch, pitch), (back.yaw, yaw)] {
            assert!((a - b).abs() <= 1e-12, "{back:?} {euler:?}");
        }
    }
}

/// The angle between two attitudes, whatever the lengths of their quaternions.
fn between(a: Quaternion<f64>, b: Quaternion<f64>) -> f64 {
    let turn = b.conjugate() * a;
    2.0 * turn.v.norm().atan2(turn.w.abs())
}

/// Anywhere, upright above all: within 10⁻³ to 10⁻¹⁷ rad of ±90° of pitch, and there itself.
#[test]
fn angles_lead_back_to_the_attitude_everywhere() {
    let mut numbers = Numbers(43);
    let special = [0.0, PI, -PI, FRAC_PI_2, -FRAC_PI_2, FRAC_PI_6];
    for n in 0..40_000 {
        let off = match n % 4 {
            0 => FRAC_PI_2 + numbers.within(FRAC_PI_2),
            1 => 10.0_f64.powf(-10.0 + numbers.within(7.0)),
            2 => 0.0,
            _ => FRAC_PI_2 + numbers.within(1e-9),
        };
        let pitch = if n % 8 < 4 { FRAC_PI_2 - off } else { off - FRAC_PI_2 };
        let mut angle = || match numbers.word() % 12 {
            word @ 0..6 => special[word as usize],
            _ => numbers.within(PI),
        };
        let euler = Euler { roll: angle(), pitch, yaw: angle() };
        let q = euler.quaternion();
        let back = Euler::from_quaternion(q);
        assert!(between(back.quaternion(), q) <= 4e-15, "{euler:?} {back:?}");
        assert!(back.roll.abs() <= PI && back.yaw.abs() <= PI && back.pitch.abs() <= FRAC_PI_2);
        assert!((back.pitch - pitch).abs() <= 1e-15, "{euler:?} {back:?}");
        // A quaternion's length is not part of its attitude.
        let long = Euler::from_quaternion(q * 1.001);
        assert!(between(long.quaternion(), q) <= 4e-15, "{euler:?} {long:?}");

        let single = q.map(|c| c as f32);
        let back = Euler::from_quaternion(single).quaternion();
        let apart = between(back.map(f64::from), single.map(f64::from));
        assert!(apart <= 1e-6, "{euler:?} {apart:e}");
    }
}

/// Where roll and yaw turn about the same axis, the turn is called yaw.
#[test]
fn straight_up_there_is_no_roll() {
    for (pitch, yaw) in [(FRAC_PI_2, 0.25), (-FRAC_PI_2, -0.75)] {
        let back = Euler::from_quaternion(Euler { roll: 0.0, pitch, yaw }.quaternion());
        assert!(back.roll == 0.0 && (back.yaw - yaw).abs() < 1e-15, "{back:?}");
    }
}

#[test]
fn a_starts_attitude_has_twice_the_digits() {
    let mut numbers = Numbers(42);
    for _ in 0..200 {
        let euler = Euler {
            roll: numbers.within(2.0 * PI),
            pitch: numbers.within(2.0 * PI),
            yaw: numbers.within(2.0 * PI),
        };
        let q = euler.quaternion_pair();
        let square = q.w * q.w + q.v.x * q.v.x + q.v.y * q.v.y + q.v.z * q.v.z - Pair::new(1.0);
        assert!((square.hi + square.lo).abs() < 5e-30, "{square:?}");
        let plain = euler.quaternion();
        let rest = q.map(|c| c.hi) - plain;
        assert!(rest.dot(rest).sqrt() < 4e-16);
        // In single precision the pair agrees with the doubles to 14 digits.
        let narrow = |x: f64| x as f32;
        let single =
            Euler { roll: narrow(euler.roll), pitch: narrow(euler.pitch), yaw: narrow(euler.yaw) };
        let wide = |x: f32| f64::from(x);
        let same =
            Euler { roll: wide(single.roll), pitch: wide(single.pitch), yaw: wide(single.yaw) };
        let rest = single.quaternion_pair().map(Pair::widen) - same.quaternion();
        assert!(rest.dot(rest).sqrt() < 1e-13, "{rest:?}");
    }
}

fn random(numbers: &mut Numbers, latitude: f64) -> Solution<f64> {
    let position =
        Geodetic { latitude, longitude: numbers.within(PI), altitude: numbers.within(2e4) };
    let attitude = Euler {
        roll: numbers.within(PI),
        pitch: numbers.within(FRAC_PI_2),
        yaw: numbers.within(PI),
    };
    Solution::new(position, numbers.vector(300.0), attitude)
}

#[test]
fn earth_fixed_axes_by_geometry() {
    let mut numbers = Numbers(43);
    for i in 0..500 {
        let latitude = if i < 20 { FRAC_PI_2 } else { numbers.within(FRAC_PI_2) };
        let solution = random(&mut numbers, latitude);
        let at = solution.to_earth_fixed();
        let place = solution.position.map(|c| c.hi);
        let hi = |v: Vector<Pair<f64>>| v.map(|c| c.hi);
        assert!((hi(at.position_e) - place.to_earth_fixed()).norm() < 3e-9);
        // Down is inwards along the ellipsoid's normal, north along the meridian.
        let ((s, c), (sl, cl)) = (place.latitude.sin_cos(), place.longitude.sin_cos());
        let axes =
            [[-s * cl, -s * sl, c], [-sl, cl, 0.0], [-c * cl, -c * sl, -s]].map(Vector::from);
        let to_earth = |v: Vector<f64>| axes[0] * v.x + axes[1] * v.y + axes[2] * v.z;
        let v = hi(solution.velocity_ned);
        assert!((hi(at.velocity_e) - to_earth(v)).norm() < 3e-13);
        let attitude = solution.attitude.map(|c| c.hi).matrix(1.0);
        let turned = at.attitude.map(|c| c.hi).matrix(1.0);
        for x in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Vector::from) {
            assert!((turned * x - to_earth(attitude * x)).norm() < 3e-15);
        }
    }
}

#[test]
fn local_axes_and_back_at_the_poles_too() {
    let mut numbers = Numbers(44);
    for i in 0..500 {
        let latitude = match i {
            0..10 => FRAC_PI_2,
            10..20 => -FRAC_PI_2,
            20..30 => FRAC_PI_2 - numbers.within(1e-9).abs(),
            _ => numbers.within(FRAC_PI_2),
        };
        let at = random(&mut numbers, latitude).to_earth_fixed();
        let back = at.to_local().to_earth_fixed();
        let gap = |a: Vector<Pair<f64>>, b: Vector<Pair<f64>>| (a - b).map(Pair::widen).norm();
        assert!(gap(at.position_e, back.position_e) < 5e-9, "{at:?}");
        assert!(gap(at.velocity_e, back.velocity_e) < 1e-12, "{at:?}");
        let turn = at.attitude.map(Pair::widen) * back.attitude.map(Pair::widen).conjugate();
        assert!(turn.rotation_vector().norm() < 3e-15, "{turn:?}");
    }
}

#[test]
fn single_precision_carries_fourteen_digits_there_and_back() {
    let mut numbers = Numbers(45);
    for _ in 0..200 {
        let solution = random(&mut numbers, 0.8);
        let narrow = Solution::<f32>::narrow(&solution);
        let back = narrow.widen();
        let close = |a: Pair<f64>, b: Pair<f64>| {
            assert!((a.widen() - b.widen()).abs() <= 1e-14 * b.hi.abs().max(1e-20), "{a:?} {b:?}");
        };
        close(back.position.latitude, solution.position.latitude);
        close(back.position.longitude, solution.position.longitude);
        close(back.position.altitude, solution.position.altitude);
        back.velocity_ned.zip(solution.velocity_ned, close);
        back.attitude.v.zip(solution.attitude.v, close);
        close(back.attitude.w, solution.attitude.w);
        // Earth-fixed axes keep them: 1e-14 of an Earth's radius is 6e-8 m.
        let (single, double) = (narrow.to_earth_fixed().widen(), solution.to_earth_fixed());
        let apart = (single.position_e - double.position_e).map(Pair::widen).norm();
        assert!(apart < 6e-7, "{apart:e}");
        assert_eq!(Solution::<f32>::narrow(&back), narrow);
    }
}
