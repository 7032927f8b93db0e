//! The specific force at the beginning of a block.

use crate::math::quaternion::Matrix;
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::strapdown::block::body::BodyMotion;

/// The specific force at the beginning of a block, in the axes at its start.
pub(crate) struct Beginning<R> {
    /// a, m/s².
    pub value: Vector<R>,
    /// ȧ, m/s³.
    pub rate: Vector<R>,
    /// ä, m/s⁴.
    pub rate_growth: Vector<R>,
}

impl<R: Real> Beginning<R> {
    /// The parabola whose first, second and third integrals over T are u, s and ∫s, turned by a matrix.
    pub fn of(matrix: &Matrix<R>, body: &BodyMotion<R>, time: R) -> Self {
        // With U = u/T, V = s/T² and Z = ∫s/T³: a = 3U − 24V + 60Z,
        // ȧT = −24U + 168V − 360Z,  äT² = 60U − 360V + 720Z
        let inverse = R::ONE / time;
        let inverse_square = inverse * inverse;
        let once = *matrix * body.velocity * inverse;
        let twice = *matrix * body.position * inverse_square;
        let thrice = *matrix * body.position_integral * (inverse_square * inverse);
        let sum = |u: f64, v: f64, z: f64| once * R::of(u) + twice * R::of(v) + thrice * R::of(z);
        Self {
            value: sum(3.0, -24.0, 60.0),
            rate: sum(-24.0, 168.0, -360.0) * inverse,
            rate_growth: sum(60.0, -360.0, 720.0) * inverse_square,
        }
    }
}
