//! Quaternions: products, rotations, angles; errors in ulps of the result's length.

use super::big::{Big, big, largest};
use super::{Precision, Worst, ulp};
use schuler::math::quaternion::Quaternion;
use schuler::math::real::Scalar;
use schuler::math::vector::Vector;
use schuler::solution::Euler;
use schuler_tests::Numbers;

const TRIES: u32 = 1000;

/// Everything in this file.
pub fn measure(worst: &mut Worst) {
    rotations::<f64>(worst);
    rotations::<f32>(worst);
}

fn vector<R: Scalar>(numbers: &mut Numbers, bound: f64) -> Vector<R> {
    numbers.vector(bound).map(R::narrow)
}

fn exactly<R: Scalar>(x: Vector<R>) -> Vector<Big> {
    x.map(|c| big(c.widen()))
}

fn exact_quaternion<R: Scalar>(q: Quaternion<R>) -> Quaternion<Big> {
    Quaternion::new(big(q.w.widen()), exactly(q.v))
}

fn square(q: Quaternion<Big>) -> Big {
    q.w * q.w + q.v.dot(q.v)
}

/// q ⊗ (0, x) ⊗ q*: the definition.
fn sandwich(q: Quaternion<Big>, x: Vector<Big>) -> Vector<Big> {
    (q * Quaternion::new(big(0.0), x) * q.conjugate()).v
}

/// A quaternion of length 1 to rounding.
fn unit<R: Scalar>(numbers: &mut Numbers) -> Quaternion<R> {
    let (w, v) = (numbers.within(1.0), numbers.vector(1.0));
    let length = (w * w + v.dot(v)).sqrt();
    Quaternion::new(R::narrow(w / length), v.map(|c| R::narrow(c / length)))
}

fn rotations<R: Scalar + Precision>(worst: &mut Worst) {
    let mut numbers = Numbers(21);
    let mut check = |what: &str, off: f64, length: f64| {
        worst.add(format!("{what} {}", R::NAME), off / (ulp(length) * R::ULP));
    };
    let apart = |a: Vector<R>, b: Vector<Big>| largest((exactly(a) - b).into_array());
    let apart_quaternion = |a: Quaternion<R>, b: Quaternion<Big>| {
        let Quaternion { w, v } = exact_quaternion(a) - b;
        largest([w, v.x, v.y, v.z])
    };
    let one = big(1.0);
    for _ in 0..TRIES {
        let (a, b) = (unit::<R>(&mut numbers), unit::<R>(&mut numbers));
        let x = vector::<R>(&mut numbers, 10.0);
        let length = exactly(x).dot(exactly(x)).sqrt().rough();
        let product = exact_quaternion(a) * exact_quaternion(b);
        check("quaternion product", apart_quaternion(a * b, product), 1.0);

        // The matrix takes q for a unit quaternion: C = I + 2w[v×] + 2[v×][v×].
        let Quaternion { w, v } = exact_quaternion(a);
        let (exact_x, two) = (exactly(x), big(2.0));
        let turned = v.cross(exact_x);
        let rotated = exact_x + turned * (two * w) + v.cross(turned) * two;
        check("rotation by matrix", apart(a.matrix(R::ONE) * x, rotated), length);

        // A rotation by up to 0.5 rad, less one, of unit length to its own rounding.
        let small = vector::<R>(&mut numbers, 0.15);
        let v = exactly(small);
        let w = (one - v.dot(v)).sqrt() - one;
        let e = Quaternion::new(R::narrow(w.rough()), small);
        let exact_e = Quaternion::new(big(e.w.widen()) + one, v);
        let scaled = one / square(exact_e);
        let added = sandwich(exact_e, exact_x) * scaled - exact_x;
        let gained = added.dot(added).sqrt().rough();
        check("turn less one", apart(e.turn_less_one(x), added), gained);

        // Off unit length by 10⁻⁹, of which one Newton step leaves 1.5·10⁻¹⁸.
        let stretched = Quaternion::new(e.w + R::narrow(1e-9), small);
        let exact = Quaternion::new(big(stretched.w.widen()) + one, v);
        let length = square(exact).sqrt();
        let mut normal = exact * (one / length);
        normal.w = normal.w - one;
        let size = (square(normal)).sqrt().rough();
        check(
            "normalised less one",
            apart_quaternion(stretched.normalised_less_one(), normal),
            size,
        );

        let Vector { x: roll, y: pitch, z: yaw } = vector::<R>(&mut numbers, 3.1);
        let euler = Euler { roll, pitch, yaw };
        let half = |angle: R| {
            let x = big(angle.widen()) * big(0.5);
            (x.sin(), x.cos())
        };
        let axis = |(sine, cosine): (Big, Big), unit: [f64; 3]| {
            Quaternion::new(cosine, Vector::from(unit).map(|c| big(c) * sine))
        };
        let exact = axis(half(yaw), [0.0, 0.0, 1.0])
            * axis(half(pitch), [0.0, 1.0, 0.0])
            * axis(half(roll), [1.0, 0.0, 0.0]);
        check("Euler to quaternion", apart_quaternion(euler.quaternion(), exact), 1.0);
        let pair = euler.quaternion_pair();
        let pair = Quaternion::new(
            big(pair.w.hi.widen()) + big(pair.w.lo.widen()),
            pair.v.map(|c| big(c.hi.widen()) + big(c.lo.widen())),
        );
        let Quaternion { w, v } = pair - exact;
        let unit = f64::EPSILON / 2.0 * R::ULP;
        check("Euler to quaternion pair", largest([w, v.x, v.y, v.z]) / unit, 1.0);

        // φ = 2 atan2(|v|, w) v/|v|
        let positive = if a.w.widen() < 0.0 { a.map(|c| -c) } else { a };
        let q = exact_quaternion(positive);
        let length = q.v.dot(q.v).sqrt();
        let angle = big(2.0) * length.atan2(q.w);
        let exact = q.v * (angle / length);
        check("rotation vector", apart(a.rotation_vector(), exact), angle.rough());
    }
}
