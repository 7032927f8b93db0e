//! How far a block carries the vehicle, in axes that stand still in inertial space.
//!
//! The Earth turns under the displacement while it grows: Ω is its rate in the axes at the start, and two
//! orders of it reach the rounding floor for blocks of seconds.

use crate::math::compensated::{two_product, two_sum};
use crate::math::real::Real;
use crate::math::vector::Vector;

/// Displacements over a time t from v₀ and the net velocity integral, in n0.
pub(super) struct Displacement<R> {
    /// d: change of position plus the frame's own motion, inertially, m.
    pub inertial: Vector<R>,
    /// D: relative to the Earth, m.
    pub relative: Vector<R>,
    /// What rounding drops from D; 0 unless two-float numbers are asked for.
    pub relative_low: Vector<R>,
}

/// `low` is what the rounding of velocity and time takes from their product, m; with `two_float` what the
/// product itself drops is found, too.
#[inline(always)]
pub(super) fn displacement<R: Real>(
    velocity: Vector<R>,
    net: Vector<R>,
    omega: Vector<R>,
    time: R,
    low: Vector<R>,
    two_float: bool,
) -> Displacement<R> {
    let t2 = time * time;
    // ∫d = v₀T²/2 + (T/3)net − Ω×(v₀T³/6 + net·T²/12),  ∬d = v₀T³/6 + net·T²/12 − Ω×v₀T⁴/24
    let second = velocity * (t2 * time * R::of(1.0 / 6.0)) + net * (t2 * R::of(1.0 / 12.0));
    let first = velocity * (t2 * R::HALF) + net * (time * R::of(1.0 / 3.0)) - omega.cross(second);
    // d = v₀T + net − Ω×∫d
    let fallen = net - omega.cross(first) + low;
    let straight = velocity * time;
    let inertial = straight + fallen;
    // D = d − Ω×(Td − ∫d) + Ω×(Ω×(½T²d − T∫d + ∬d))
    let drag = omega.cross(inertial * time - first);
    let twice = omega.cross(omega.cross(inertial * (t2 * R::HALF) - first * time + second));
    if two_float {
        let dropped = velocity.map(|v| two_product(v, time).1);
        let sums = straight.zip(fallen - drag + twice + dropped, two_sum);
        let (relative, relative_low) = (sums.map(|(s, _)| s), sums.map(|(_, e)| e));
        Displacement { inertial, relative, relative_low }
    } else {
        Displacement { inertial, relative: inertial - drag + twice, relative_low: Vector::ZERO }
    }
}
