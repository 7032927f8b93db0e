//! How normal gravity changes with latitude and height.
//!
//! ```
//! use schuler::earth::gradient::of_gravity;
//!
//! let (_, per_height) = of_gravity(0.8_f64.sin(), 0.8_f64.cos(), 0.0);
//! assert!((per_height + 3.09e-6).abs() < 1e-8);
//! ```

use super::{
    CENTRIFUGAL_RATIO, ECCENTRICITY_SQUARED, EQUATORIAL_GRAVITY, FLATTENING, SEMI_MAJOR_AXIS as A,
    SOMIGLIANA, height_factor,
};
use crate::math::real::Real;

/// ∂γ/∂φ in m/s² per rad and ∂γ/∂h in 1/s² of normal gravity, exactly.
pub fn of_gravity<R: Real>(sine: R, cosine: R, altitude: R) -> (R, R) {
    // γ = γ_e·S·H,  S = (1 + k sin²φ)/W,  H = 1 − (2/a)(1 + f + m − 2f sin²φ)h + 3h²/a²
    let s2 = sine * sine;
    let w2 = R::ONE - R::of(ECCENTRICITY_SQUARED) * s2;
    let w = w2.sqrt();
    let numerator = R::ONE + R::of(SOMIGLIANA) * s2;
    let surface = R::of(EQUATORIAL_GRAVITY) * numerator / w;
    let factor = R::ONE + height_factor(s2, altitude);
    // dS/d sin²φ = (k + ½e²(1 + k sin²φ)/W²)/W,  ∂H/∂sin²φ = 4fh/a
    let surface_slope = R::of(EQUATORIAL_GRAVITY)
        * (R::of(SOMIGLIANA) + R::of(0.5 * ECCENTRICITY_SQUARED) * numerator / w2)
        / w;
    let factor_slope = R::of(4.0 * FLATTENING / A) * altitude;
    let per_latitude = (surface_slope * factor + surface * factor_slope) * R::TWO * sine * cosine;
    // ∂H/∂h = −(2/a)(1 + f + m − 2f sin²φ) + 6h/a²
    let per_height = surface
        * (R::of(-2.0 / A * (1.0 + FLATTENING + CENTRIFUGAL_RATIO))
            + R::of(4.0 * FLATTENING / A) * s2
            + R::of(6.0 / (A * A)) * altitude);
    (per_latitude, per_height)
}
