//! Normal gravity in closed form, at any height, to compare the series of [`gravity`] with.
//!
//! The gravity of the ellipsoid that is its own level surface has a form without series in ellipsoidal
//! coordinates u and β: u the semi-minor axis of the confocal ellipsoid through the point, β its reduced
//! latitude. Navigation and truth share the series; this shows its error.
//! Source: Heiskanen & Moritz, *Physical Geodesy* (1967), §2-7 and §2-8, equations 2-66 to 2-74.
//!
//! ```
//! use schuler::earth::{closed_form::gravity_ned, gravity};
//!
//! // 10 km above 45° of latitude: down agrees to 0.1 µg, and there is a component of 8 µg to the north.
//! let latitude = 45_f64.to_radians();
//! let exact = gravity_ned(latitude, 10_000.0);
//! assert!((gravity(latitude.sin(), 10_000.0) - exact.z).abs() < 1e-6);
//! assert!((exact.x.abs() / 9.80665e-6 - 8.3).abs() < 0.1);
//! ```

use super::{
    ECCENTRICITY_SQUARED, Geodetic, ROTATION_RATE, SEMI_MAJOR_AXIS, SEMI_MINOR_AXIS, gravity,
};
use crate::math::real::Real;
use crate::math::vector::Vector;

/// Gravitational constant times the Earth's mass, GM, m³/s² (NIMA TR8350.2).
pub const GRAVITATIONAL_CONSTANT: f64 = 3.986004418e14;

/// Normal gravity along north and down at a latitude in rad and an altitude in m, m/s²; east is 0.
pub fn gravity_ned(latitude: f64, altitude: f64) -> Vector<f64> {
    const A: f64 = SEMI_MAJOR_AXIS;
    const B: f64 = SEMI_MINOR_AXIS;
    const W2: f64 = ROTATION_RATE * ROTATION_RATE;
    let at = Geodetic { latitude, longitude: 0.0, altitude }.to_earth_fixed();
    let (axis, polar) = (at.x, at.z);
    // E² = a² − b²;  u² = ½(r² − E²)(1 + √(1 + 4E²z²/(r² − E²)²));  tanβ = z√(u² + E²)/(u p)
    let e2 = ECCENTRICITY_SQUARED * A * A;
    let d = axis * axis + polar * polar - e2;
    let u2 = 0.5 * d * (1.0 + Real::sqrt(1.0 + 4.0 * e2 * polar * polar / (d * d)));
    let (u, e, v) = (Real::sqrt(u2), Real::sqrt(e2), Real::sqrt(u2 + e2));
    let (sine, cosine) = (polar / u, axis / v);
    // w² = (u² + E² sin²β)/(u² + E²)
    let w = Real::sqrt(u2 + e2 * sine * sine) / v;
    // q = ½[(1 + 3u²/E²)atan(E/u) − 3u/E],  q′ = 3(1 + u²/E²)(1 − (u/E)atan(E/u)) − 1
    let q = |u: f64| 0.5 * ((1.0 + 3.0 * u * u / e2) * Real::atan2(e, u) - 3.0 * u / e);
    let q0 = q(B);
    let q_prime = 3.0 * (1.0 + u2 / e2) * (1.0 - u / e * Real::atan2(e, u)) - 1.0;
    // γ_u = −[GM/v² + ω²a²E q′/(v² q₀)(½sin²β − ⅙) − ω²u cos²β]/w
    let outward = -(GRAVITATIONAL_CONSTANT / (v * v)
        + W2 * A * A * e / (v * v) * (q_prime / q0) * (0.5 * sine * sine - 1.0 / 6.0)
        - W2 * u * cosine * cosine)
        / w;
    // γ_β = −[−ω²a² q/(v q₀) + ω² v] sinβ cosβ/w
    let along = (W2 * A * A / v * (q(u) / q0) - W2 * v) * sine * cosine / w;
    // The coordinates' directions: û = (u cosβ/v, sinβ)/w,  β̂ = (−sinβ, u cosβ/v)/w
    let (level, lift) = (u * cosine / (v * w), sine / w);
    let from_axis = outward * level - along * lift;
    let to_pole = outward * lift + along * level;
    let (s, c) = Real::sin_cos(latitude);
    Vector::new(to_pole * c - from_axis * s, 0.0, -(to_pole * s + from_axis * c))
}

/// What [`gravity`] lacks of normal gravity, north, east and down, m/s².
pub fn neglected_ned(latitude: f64, altitude: f64) -> Vector<f64> {
    let whole = gravity_ned(latitude, altitude);
    let (sine, _) = Real::sin_cos(latitude);
    Vector::new(whole.x, whole.y, whole.z - gravity(sine, altitude))
}
