//! Coning, sculling and rotation of one sample, with the previous one.

use crate::math::quaternion::Quaternion;
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::sample::Increment;

/// A sample with its coning, sculling and rotation corrections.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Compensated<R> {
    /// The body's rotation over the sample, a unit quaternion: end → start.
    pub rotation: Quaternion<R>,
    /// The velocity increment in the body axes at the start, m/s.
    pub velocity: Vector<R>,
}

impl<R: Real> Compensated<R> {
    /// Of a sample and the one before it.
    #[inline(always)]
    pub fn from_samples(sample: &Increment<R>, previous: &Increment<R>) -> Self {
        let (angle, velocity) = (sample.angle_b, sample.velocity_b);
        let twelfth = R::of(1.0 / 12.0);
        // φ = Δθ + ¹⁄₁₂ Δθ′ × Δθ
        let coned = angle + previous.angle_b.cross(angle) * twelfth;
        // u = Δv + (1 − cosθ)/θ² Δθ×Δv + (1 − sinθ/θ)/θ² Δθ×(Δθ×Δv) + ¹⁄₁₂(Δθ′×Δv + Δv′×Δθ),
        // both series up to θ⁴: they leave θ⁷/40320 of Δv, 2e-7 at 0.5 rad and 0.3 % at 2 rad
        let square = angle.dot(angle);
        let first = R::HALF - square * (R::of(1.0 / 24.0) - square * R::of(1.0 / 720.0));
        let second =
            R::of(1.0 / 6.0) - square * (R::of(1.0 / 120.0) - square * R::of(1.0 / 5040.0));
        let swept = angle.cross(velocity);
        let sculling = previous.angle_b.cross(velocity) + previous.velocity_b.cross(angle);
        let velocity = velocity + swept * first + angle.cross(swept) * second + sculling * twelfth;
        Self { rotation: rotation(coned), velocity }
    }
}

/// The unit quaternion of a rotation vector, rad: the series leave x⁵/10!, 3e-13 of it at 0.5 rad and
/// 3e-7 at 2 rad.
#[inline(always)]
pub(super) fn rotation<R: Real>(vector: Vector<R>) -> Quaternion<R> {
    // q = [cos ½φ, ½ sinc(½φ) φ], x = ¼φ²: cos = 1 − x/2 + x²/24 − …, sinc = 1 − x/6 + x²/120 − …
    let x = vector.dot(vector) * R::of(0.25);
    let cosine = R::ONE
        - x * (R::HALF
            - x * (R::of(1.0 / 24.0) - x * (R::of(1.0 / 720.0) - x * R::of(1.0 / 40320.0))));
    let sinc = R::ONE
        - x * (R::of(1.0 / 6.0)
            - x * (R::of(1.0 / 120.0) - x * (R::of(1.0 / 5040.0) - x * R::of(1.0 / 362880.0))));
    Quaternion::new(cosine, vector * (sinc * R::HALF))
}
