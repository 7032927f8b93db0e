//! How far a block carries the vehicle, in axes that stand still in inertial space.
//!
//! The Earth turns under the displacement while it grows: Ω is its rate in the axes at the start, and two
//! orders of it reach the rounding floor for blocks of seconds.

use crate::math::real::Real;
use crate::math::vector::Vector;

/// Displacements over a time t from v₀ and the net velocity integral, in n0.
pub(super) struct Displacement<R> {
    /// d: change of position plus the frame's own motion, inertially, m.
    pub inertial: Vector<R>,
    /// D: relative to the Earth, m.
    pub relative: Vector<R>,
}

/// `low` is what the rounding of velocity and time takes from their product, m.
#[inline(always)]
pub(super) fn displacement<R: Real>(
    velocity: Vector<R>,
    net: Vector<R>,
    omega: Vector<R>,
    time: R,
    low: Vector<R>,
) -> Displacement<R> {
    let t2 = time * time;
    // ∫d = v₀T²/2 + (T/3)net − Ω×(v₀T³/6 + net·T²/12),  ∬d = v₀T³/6 + net·T²/12 − Ω×v₀T⁴/24
    let second = velocity * (t2 * time * R::of(1.0 / 6.0)) + net * (t2 * R::of(1.0 / 12.0));
    let first = velocity * (t2 * R::HALF) + net * (time * R::of(1.0 / 3.0)) - omega.cross(second);
    // d = v₀T + net − Ω×∫d
    let inertial = velocity * time + (net - omega.cross(first) + low);
    // D = d − Ω×(Td − ∫d) + Ω×(Ω×(½T²d − T∫d + ∬d))
    let drag = omega.cross(inertial * time - first);
    let twice = omega.cross(omega.cross(inertial * (t2 * R::HALF) - first * time + second));
    Displacement { inertial, relative: inertial - drag + twice }
}
