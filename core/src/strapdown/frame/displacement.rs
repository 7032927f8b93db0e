//! From velocity and acceleration to displacements, inertially and relative to the rotating Earth.
//!
//! In axes that stand still in inertial space the velocity w relative to the Earth obeys ẇ = a − Ω × w, with a
//! the sum of specific force and plumb gravity and Ω the Earth's rate. With R(α) the turn by α about Ω,
//! w(t) = R(−Ωt)v₀ + ∫R(−Ω(t−s))a(s)ds, and the displacement in the Earth's own axes is
//! D = ∫R(−Ωt)w dt, which contains R(−ΩT) as a factor: with ρ = T − s,
//! ∫ₛᵀ R(−Ω(2t−s))dt = R(−ΩT)(ρ + Ω²ρ³/6 + Ω⁴ρ⁵/120 …), Ω² meaning Ω×(Ω×·). The moments ∫aρ, ∫aρ²/2
//! and ∫aρ³/6 are the integrals of net(t) = ∬a, so that
//!
//! S₀ = v₀T + net,  S₁ = v₀T²/2 + ∫net,  S₂ = v₀T³/6 + ∬net,
//! d = ∫w = S₀ − Ω×S₁ + Ω×(Ω×S₂) − …,  D = R(−ΩT)(S₀ + Ω×(Ω×S₂) + …).
//!
//! Left out are Ω³v₀T⁴/24 of d, which changes velocity only by Ω⁴v₀T⁴/24, terms of Ω⁴v₀T⁵ of D, and Ω²ȧT⁵/180
//! of both, since ∬net = net·T²/12 is exact for constant a.

use crate::earth::ROTATION_RATE;
use crate::math::compensated::{two_product, two_sum};
use crate::math::real::Real;
use crate::math::vector::Vector;

/// Displacements over a time t from v₀ and the net velocity integral, in n0.
pub(crate) struct Displacement<R> {
    /// d = ∫w dt, in axes that stand still in inertial space, m.
    pub inertial: Vector<R>,
    /// D: relative to the Earth, m.
    pub relative: Vector<R>,
    /// The part of D that rounding drops; 0 without two-float products.
    pub relative_low: Vector<R>,
}

/// Integrals of the acceleration.
pub(crate) struct Net<R> {
    /// net = ∬a, m.
    pub once: Vector<R>,
    /// ∫net, m·s.
    pub twice: Vector<R>,
}

impl<R: Real> Net<R> {
    /// Of a = a₀ + ȧt + ½ät² over a time.
    #[inline(always)]
    pub fn of_parabola(a: Vector<R>, rate: Vector<R>, growth: Vector<R>, time: R) -> Self {
        // net = ½a₀t² + ⅙ȧt³ + ¹⁄₂₄ät⁴,  ∫net = ⅙a₀t³ + ¹⁄₂₄ȧt⁴ + ¹⁄₁₂₀ät⁵
        let t2 = time * time;
        let [second, third, fourth, fifth] =
            [1.0 / 2.0, 1.0 / 6.0, 1.0 / 24.0, 1.0 / 120.0].map(R::of);
        Self {
            once: (a * second + rate * (time * third) + growth * (t2 * fourth)) * t2,
            twice: (a * third + rate * (time * fourth) + growth * (t2 * fifth)) * (t2 * time),
        }
    }
}

/// Ω × x for a rate without an east component.
#[inline(always)]
pub(crate) fn turned_by<R: Real>(omega: Vector<R>, x: Vector<R>) -> Vector<R> {
    Vector::new(-(omega.z * x.y), omega.z * x.x - omega.x * x.z, omega.x * x.y)
}

/// `low` is the effect of the remainders of velocity and time on their product, m. With `two_float` the rounding
/// of the product itself is added.
#[inline(always)]
pub(crate) fn displacement<R: Real>(
    velocity: Vector<R>,
    net: &Net<R>,
    omega: Vector<R>,
    time: R,
    low: Vector<R>,
    two_float: bool,
) -> Displacement<R> {
    const OMEGA_SQUARED: f64 = ROTATION_RATE * ROTATION_RATE;
    let t2 = time * time;
    // S₁ = v₀T²/2 + ∫net,  S₂ = v₀T³/6 + ∬net with ∬net = net·T²/12
    let first = velocity * (t2 * R::HALF) + net.twice;
    let second = velocity * (t2 * time * R::of(1.0 / 6.0)) + net.once * (t2 * R::of(1.0 / 12.0));
    // p = S₀ + Ω×(Ω×S₂), d = p − Ω×S₁
    let fallen = net.once + turned_by(omega, turned_by(omega, second)) + low;
    let straight = velocity * time;
    let whole = straight + fallen;
    let inertial = whole - turned_by(omega, first);
    // D = p − (sin ωT/ω) Ω×p + ((1 − cos ωT)/ω²) Ω×(Ω×p)
    let once = turned_by(omega, whole);
    let back = turned_by(omega, once) * (t2 * R::HALF)
        - once * (time - time * t2 * R::of(OMEGA_SQUARED / 6.0));
    if two_float {
        let dropped = velocity.map(|v| two_product(v, time).1);
        let sums = straight.zip(fallen + back + dropped, two_sum);
        let (relative, relative_low) = (sums.map(|(s, _)| s), sums.map(|(_, e)| e));
        Displacement { inertial, relative, relative_low }
    } else {
        Displacement { inertial, relative: whole + back, relative_low: Vector::ZERO }
    }
}
