//! Rotations of a correction, stored less one so that small rotations keep all their bits.

use crate::earth::POLAR_SINE;
use crate::math::compensated::Pair;
use crate::math::quaternion::Quaternion;
use crate::math::real::Real;
use crate::math::vector::Vector;

/// The rotation by a vector of length π at most.
pub(crate) fn rotation<R: Real>(vector: Vector<R>) -> Quaternion<R> {
    // e = (cos ½φ − 1, sin ½φ·n),  cos ½φ − 1 = −2 sin² ¼φ,  sin ½φ = 2 sin ¼φ cos ¼φ
    let quarter = vector.norm() * R::of(0.25);
    // As a pair: libm's functions of single precision compute in double.
    let (sine, cosine) = Pair::new(quarter).sin_cos();
    let none = quarter.less(R::of(1e-18));
    let divisor = R::select(none, R::ONE, quarter + quarter);
    let factor = R::select(none, R::HALF, sine.hi * cosine.hi / divisor);
    Quaternion::new(-(sine.hi * sine.hi * R::TWO), vector * factor)
}

/// (1 + a) ⊗ (1 + b) − 1: first b, then a.
pub(super) fn after<R: Real>(a: Quaternion<R>, b: Quaternion<R>) -> Quaternion<R> {
    a + b + a * b
}

/// The rotation about a vector sin ½θ·n, for θ below π.
pub(super) fn about<R: Real>(v: Vector<R>) -> Quaternion<R> {
    // cos ½θ − 1 = −sin² ½θ/(1 + cos ½θ)
    let square = v.dot(v);
    let cosine = (R::ONE - square).sqrt();
    Quaternion::new(-(square / (R::ONE + cosine)), v)
}

/// Beyond 84° of latitude, the rotation about down from the north that was carried along to the meridian at the
/// corrected place; elsewhere none.
///
/// `half_longitude` is tan ½Δλ; the sines and cosines are those of the two latitudes.
pub(super) fn to_meridian<R: Real>(
    half_longitude: R,
    (s, c): (R, R),
    (s1, c1): (R, R),
) -> Quaternion<R> {
    // tan ½α = tan ½Δλ sin ½(φ + φ₁)/cos ½(φ₁ − φ) = tan ½Δλ (s + s₁)/(1 + cc₁ + ss₁), about down
    let tangent = half_longitude * (s + s1) / (R::ONE + c * c1 + s * s1);
    let sine = tangent / (R::ONE + tangent * tangent).sqrt();
    let sine = R::select(is_polar(s), sine, R::ZERO);
    about(Vector::new(R::ZERO, R::ZERO, sine))
}

/// Whether the place is too near a pole for its meridian to define north.
pub(super) fn is_polar<R: Real>(sine: R) -> R::Mask {
    R::of(POLAR_SINE).less(sine.abs())
}
