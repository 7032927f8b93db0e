//! Rotations: quaternions against matrices and closed forms.

use schuler::math::quaternion::{Matrix, Quaternion};
use schuler::math::vector::Vector;
use schuler_tests::Numbers;
use std::f64::consts::PI;

fn about(axis: Vector<f64>, angle: f64) -> Quaternion<f64> {
    let (s, c) = (angle / 2.0).sin_cos();
    Quaternion::new(c, axis * (s / axis.norm()))
}

/// Rodrigues' formula: x cosα + (n × x) sinα + n(n·x)(1 − cosα).
fn turned(axis: Vector<f64>, angle: f64, x: Vector<f64>) -> Vector<f64> {
    let n = axis * (1.0 / axis.norm());
    let (s, c) = angle.sin_cos();
    x * c + n.cross(x) * s + n * (n.dot(x) * (1.0 - c))
}

#[test]
fn matrix_product_and_small_turn_are_the_rotation() {
    let mut numbers = Numbers(21);
    for _ in 0..2000 {
        let (axis, x) = (numbers.vector(1.0), numbers.vector(1.0));
        let angle = numbers.within(PI);
        let q = about(axis, angle);
        let expected = turned(axis, angle, x);
        let matrix: Matrix<f64> = q.matrix(1.0);
        let sandwich = q * Quaternion::new(0.0, x) * q.conjugate();
        let small = Quaternion::new(q.w - 1.0, q.v);
        for (what, result) in [
            ("matrix", matrix * x),
            ("sandwich", sandwich.v),
            ("less one", x + small.turn_less_one(x)),
        ] {
            assert!((result - expected).norm() <= 2e-15, "{what}: {result:?} {expected:?}");
        }
        let back = matrix.transpose() * expected;
        assert!((back - x).norm() <= 2e-15);

        // a ⊗ b is first b, then a.
        let (other_axis, other_angle) = (numbers.vector(1.0), numbers.within(PI));
        let both = (q * about(other_axis, other_angle)).matrix(1.0) * x;
        let in_turn = turned(axis, angle, turned(other_axis, other_angle, x));
        assert!((both - in_turn).norm() <= 3e-15);
    }
}

#[test]
fn a_small_turn_keeps_all_its_digits() {
    // (R − I)x = α(n × x) − ½α²… : a rotation by 1e-12 rad seen to 16 digits of its own size.
    let angle: f64 = 1e-12;
    let small = Quaternion::new(-angle * angle / 8.0, Vector::new(0.0, 0.0, angle / 2.0));
    let change = small.turn_less_one(Vector::new(3.0, 4.0, 5.0));
    assert!((change.x + 4.0 * angle + 1.5 * angle * angle).abs() <= 1e-27, "{change:?}");
    assert!((change.y - 3.0 * angle + 2.0 * angle * angle).abs() <= 1e-27, "{change:?}");
    assert_eq!(change.z, 0.0);
}

#[test]
fn normalising_leaves_the_square_of_the_error() {
    let mut numbers = Numbers(22);
    for _ in 0..1000 {
        let q = about(numbers.vector(1.0), numbers.within(1.0));
        let stretch = 1.0 + numbers.within(1e-4);
        let long = Quaternion::new(q.w * stretch - 1.0, q.v * stretch).normalised_less_one();
        let rest = long - Quaternion::new(q.w - 1.0, q.v);
        // A Newton step leaves 3/2 of the square.
        let bound = 1.6 * (stretch - 1.0).powi(2) + 4e-16;
        assert!(rest.dot(rest).sqrt() <= bound, "{stretch} {rest:?}");
    }
}

#[test]
fn rotation_vectors_of_every_length() {
    let mut numbers = Numbers(23);
    for angle in [0.0, 1e-200, 1e-19, 1e-17, 1e-12, 1e-8, 1e-3, 1.0, 3.0, PI - 1e-9, PI - 1e-14] {
        for _ in 0..100 {
            let axis = numbers.vector(1.0);
            let n = axis * (1.0 / axis.norm());
            let q = about(n, angle);
            let expected = n * angle;
            // q and −q are one rotation.
            for q in [q, q * -1.0] {
                let miss = (q.rotation_vector() - expected).norm();
                assert!(miss <= 1e-15 * angle.max(1e-300), "{angle:e}: {miss:e}");
            }
        }
    }
    // Beyond π the shorter way round is meant.
    let over = about(Vector::new(0.0, 1.0, 0.0), PI + 0.5).rotation_vector();
    assert!((over - Vector::new(0.0, 0.5 - PI, 0.0)).norm() <= 1e-15);
}

#[test]
fn vectors_follow_the_right_hand() {
    let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Vector::from);
    assert_eq!((x.cross(y), y.cross(z), z.cross(x)), (z, x, y));
    let a = Vector::new(3.0, -4.0, 12.0);
    assert_eq!((a.norm(), a.dot(Vector::new(1.0, 2.0, 3.0))), (13.0, 31.0));
    assert!(a.is_within(12.0) && !a.is_within(11.9));
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for i in 0..3 {
            let mut broken = a.into_array();
            broken[i] = bad;
            assert!(!Vector::from(broken).is_within(1e300));
        }
    }
}
