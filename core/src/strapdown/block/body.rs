//! The body step: rotation, velocity and position increments of one block, in body axes.
//!
//! From the fitted rates w(σ), f(σ) a power series about the block's centre solves
//! q′ = ½ q ⊗ w, U′ = f − w × U, D′ = U − w × D, without trigonometry and without iteration. The sums of the
//! increments enter once, as they are, and the polynomials only add the effect of rotation. So single
//! precision loses nothing of what the sensor delivered.
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::sample::Increment;
//! use schuler::strapdown::block::body::{Sum, integrate};
//! use schuler::strapdown::block::fit::Fit;
//!
//! // A quarter turn about the third axis in one second, under a steady force along the first.
//! let quarter = core::f64::consts::FRAC_PI_2;
//! let sample = Increment {
//!     angle_b: Vector::new(0.0, 0.0, quarter / 4.0),
//!     velocity_b: Vector::new(0.25, 0.0, 0.0),
//! };
//! let (fit, _) = Fit::<f64, 4>::from_any(&[sample; 4], 0, 4);
//! let (body, _) = integrate::<f64, 4, 23>(&fit, &Sum::plain(&[sample; 4]), 0.5, 22);
//! // u = ∫(cos ωt, sin ωt) dt = (1, 1)/ω
//! let expected = Vector::new(1.0 / quarter, 1.0 / quarter, 0.0);
//! assert!((body.velocity - expected).norm() < 1e-14);
//! ```

use super::fit::Fit;
use super::series::Series;
use crate::math::compensated::two_sum;
use crate::math::quaternion::Quaternion;
use crate::math::real::Real;
use crate::math::real::Twin as _;
use crate::math::vector::Vector;
use crate::sample::Increment;

/// The motion over a block, or its first part, of a body that starts at rest.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BodyMotion<R> {
    /// Rotation end → start, less one: e = q_bb − 1.
    pub rotation: Quaternion<R>,
    /// The part of its vector that rounding drops; 0 without two-float products.
    pub rotation_low: Vector<R>,
    /// u = ∫ C f dt in the axes at the start, m/s.
    pub velocity: Vector<R>,
    /// The part that rounding drops from it.
    pub velocity_low: Vector<R>,
    /// s = ∬ C f dt² in the axes at the start, m.
    pub position: Vector<R>,
    /// ∫s dt in the axes at the start, m·s; 0 inside a block.
    pub position_integral: Vector<R>,
}

/// The sum of a block's increments.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Sum<R> {
    increment: Increment<R>,
    /// What rounding dropped from it.
    low: Increment<R>,
    two_float: bool,
}

impl<R: Real> Sum<R> {
    /// From a sum that is rounded.
    #[inline(always)]
    pub fn rounded(increment: Increment<R>) -> Self {
        Self { increment, low: Increment::ZERO, two_float: false }
    }

    /// The sum of increments, rounded.
    #[inline(always)]
    pub fn plain(samples: &[Increment<R>]) -> Self {
        let mut sum = Increment::ZERO;
        for sample in samples {
            sum.angle_b = sum.angle_b + sample.angle_b;
            sum.velocity_b = sum.velocity_b + sample.velocity_b;
        }
        Self::rounded(sum)
    }

    /// With something small added.
    #[inline(always)]
    pub fn and(self, small: &Increment<R>) -> Self {
        let add = |to: Increment<R>| Increment {
            angle_b: to.angle_b + small.angle_b,
            velocity_b: to.velocity_b + small.velocity_b,
        };
        if self.two_float {
            Self { low: add(self.low), ..self }
        } else {
            Self { increment: add(self.increment), ..self }
        }
    }

    /// The sum of increments with the part that rounding drops.
    #[inline(always)]
    pub fn exact(samples: &[Increment<R>]) -> Self {
        let (mut increment, mut low) = (Increment::ZERO, Increment::ZERO);
        for sample in samples {
            let (angle, angle_low) = two_sums(increment.angle_b, sample.angle_b);
            let (velocity, velocity_low) = two_sums(increment.velocity_b, sample.velocity_b);
            increment = Increment { angle_b: angle, velocity_b: velocity };
            low.angle_b = low.angle_b + angle_low;
            low.velocity_b = low.velocity_b + velocity_low;
        }
        Self { increment, low, two_float: true }
    }
}

/// a + b = s + e, component by component, exactly.
#[inline(always)]
fn two_sums<R: Real>(a: Vector<R>, b: Vector<R>) -> (Vector<R>, Vector<R>) {
    let pairs = a.zip(b, two_sum);
    (pairs.map(|(s, _)| s), pairs.map(|(_, e)| e))
}

/// A block's motion and its series up to σ^`order`, at most N − 1. `sum` is the sum of the block's own
/// increments, `half_time_s` half the block's duration.
#[inline(always)]
pub fn integrate<R: Real, const K: usize, const N: usize>(
    fit: &Fit<R, K>,
    sum: &Sum<R>,
    half_time_s: R,
    order: usize,
) -> (BodyMotion<R>, Series<R, N>) {
    let series = Series::solve(fit, order);
    let Series { even, odd, curved, .. } = series;
    // With q(±1) − 1 = (a, A) ± (b, B), even ± odd, e = e₋* + e₊ + e₋* ⊗ e₊ is
    // eₛ = 2a + a² + |A|² − b² − |B|²,  eᵥ = ½ΣΔθ + 2(Σ_odd qₙ beyond wₙ₋₁/2n + aB − bA + B × A)
    let (a, b) = (even.rotation(), odd.rotation());
    let bent = b.v * a.w - a.v * b.w + b.v.cross(a.v) + curved.rotation().v;
    let half_sum = sum.increment.angle_b * R::HALF;
    let scalar = a.w + a.w + (a.dot(a) - b.dot(b));
    let (e, rotation_low) = if sum.two_float {
        // Normalisation changes the remainder, not the rounded rotation.
        let (v, low) = two_sums(half_sum, bent + bent);
        let k = Quaternion::new(scalar, v).excess();
        let low = low + sum.low.angle_b * R::HALF - v * k;
        (Quaternion::new(scalar - k * (R::ONE + scalar), v), low)
    } else {
        let v = half_sum + (bent + bent);
        (Quaternion::new(scalar, v).normalised_less_one(), Vector::ZERO)
    };
    let turned = e.map(R::Twin::both).turn_less_one(even.motion + odd.motion);
    // u = ΣΔv + 2Σ_odd Uₙ beyond fₙ₋₁/n + (R − I)U₊
    let bent = curved.velocity();
    let added = bent + bent + turned.map(|c| c.parts().0);
    let (velocity, velocity_low) = if sum.two_float {
        let (velocity, low) = two_sums(sum.increment.velocity_b, added);
        (velocity, low + sum.low.velocity_b)
    } else {
        (sum.increment.velocity_b + added, Vector::ZERO)
    };
    // s = (T/2)(R D₊ − D₋ − 2U₋) = (T/2)(2D_odd + 2U_odd − 2U_even + (R − I)D₊)
    let straight = odd.position() + odd.velocity() - even.velocity();
    let position = (straight + straight + turned.map(|c| c.parts().1)) * half_time_s;
    // ∫s over the block, of s₀ = 0, s at the middle −(T/2)(D₋ + U₋), and s and ṡ = u at the end: with
    // s = ṡ = 0 at the start, ∫s = T(⁷⁄₃₀s + ⁸⁄₁₅s_mid − ¹⁄₆₀Tu) is exact to t⁵ (quartic Hermite).
    let middle = odd.position() + odd.velocity() - even.position() - even.velocity();
    let weighed = position * R::of(7.0 / 30.0)
        + (middle * R::of(8.0 / 15.0) - velocity * R::of(1.0 / 30.0)) * half_time_s;
    let position_integral = (weighed + weighed) * half_time_s;
    let motion = BodyMotion {
        rotation: e,
        rotation_low,
        velocity,
        velocity_low,
        position,
        position_integral,
    };
    (motion, series)
}
