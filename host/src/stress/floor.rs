//! Bounds that follow from the arithmetic, the sampling and the Earth.
//!
//! Every one is a closed form with the number of roundings that it counts stated; none is fitted to
//! what is measured.

use crate::units::ARCSECOND;
use schuler::earth::{
    CENTRIFUGAL_RATIO, EQUATORIAL_GRAVITY, FLATTENING, ROTATION_RATE, SEMI_MAJOR_AXIS,
};

/// Half an ulp of 1 in double precision: the most that one rounding drops of 1.
pub const UNIT: f64 = f64::EPSILON / 2.0;
/// The same in single precision.
pub const SINGLE_UNIT: f64 = f32::EPSILON as f64 / 2.0;

/// What input, truth and comparison add within half an hour, m: an ulp of a longitude of 100° is
/// 1.4e-9 m, of an Earth-fixed coordinate 9e-10 m, and the vertical channel grows twelvefold.
pub const POSITION_M: f64 = 1e-8;
/// Why.
pub const POSITION_WHY: &str = "the floor of f64 input, truth and comparison within half an hour";

/// Roundings that a constant input goes through, each with its own sign, on its way into the state:
/// the rates' rotation by three angles, their sum, the product with the interval; C from q, C u, γ.
pub const ROUNDINGS: f64 = 8.0;

/// ω_s = √(g/R), rad/s.
pub fn schuler_rate() -> f64 {
    (EQUATORIAL_GRAVITY / SEMI_MAJOR_AXIS).sqrt()
}

/// κ of the free vertical channel at a latitude's sine and the ellipsoid, 1/s.
pub fn vertical_rate(sine: f64) -> f64 {
    // κ² = −∂γ/∂h = (2γ/a)(1 + f + m − 2f sin²φ): √2·ω_s with the ellipsoid's own gradient
    let bracket = 1.0 + FLATTENING + CENTRIFUGAL_RATIO - 2.0 * FLATTENING * sine * sine;
    let gravity = schuler::earth::gravity(sine, 0.0);
    (2.0 * gravity / SEMI_MAJOR_AXIS * bracket).sqrt()
}

/// Horizontal position after a time with the vertical held, m, where each rounding has relative size
/// `unit`.
pub fn held_m(unit: f64, time_s: f64) -> f64 {
    // Rounding of gravity tilts the level by Ku: at most 2KuR of a Schuler swing. Rounding of the
    // Earth's rate turns it by Kuω_ie t.
    ROUNDINGS * unit * SEMI_MAJOR_AXIS * (2.0 + ROTATION_RATE * time_s)
}
/// Why.
pub const HELD_WHY: &str = "8 roundings of gravity (2uR, a Schuler swing) and of the Earth's rate";

/// Attitude in arcsec after the body turned by some angle, rad, where the position is good to some
/// metres: roundings of each increment, and the level that the position takes along.
pub fn attitude_arcsec(position_m: f64, turned: f64) -> f64 {
    (ROUNDINGS * UNIT * (1.0 + turned) + position_m / SEMI_MAJOR_AXIS) / ARCSECOND
}
/// Why.
pub const ATTITUDE_WHY: &str = "8 roundings per radian turned, and the position's own share";

/// Truncation of gravity's parabola over blocks of `block_s` after a time, m, for a vertical that turns
/// at `rate`, rad/s.
pub fn gravity_parabola_m(rate: f64, block_s: f64, time_s: f64) -> f64 {
    // The first term that T²(½G₀ + ⅙∇ + ⅛∇²) leaves is T²(19/180)∇³, ∇³ ≤ g(ωT)³, in each of t/T blocks
    19.0 / 180.0 * EQUATORIAL_GRAVITY * rate.powi(3) * block_s.powi(4) * time_s
}
