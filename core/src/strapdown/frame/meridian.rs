//! From a displacement in north-east-down to latitude, longitude and height, without trigonometry.
//!
//! The displacement D is a straight line, and the ellipsoid curves away from it. Two passes over a
//! short series reach the rounding floor for blocks of up to 500 m, and leave 3e-9 m over 5 km.
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::strapdown::frame::meridian::{Meridian, curvature};
//!
//! // 100 m to the north at 45° of latitude.
//! let sine = 45_f64.to_radians().sin();
//! let change = Meridian::at(sine, sine, 0.0, curvature(sine)).moved(Vector::new(100.0, 0.0, 0.0));
//! assert!((change.latitude - 100.0 / 6_367_382.0).abs() < 1e-11);
//! // A straight line rises above the ellipsoid.
//! assert!((change.altitude - 100.0 * 100.0 / (2.0 * 6_367_382.0)).abs() < 1e-8);
//! ```

use crate::earth::{ECCENTRICITY_SQUARED, Geodetic, SEMI_MAJOR_AXIS};
use crate::math::compensated::Pair;
use crate::math::quaternion::Quaternion;
use crate::math::real::Real;
use crate::math::vector::Vector;

/// The ellipsoid at the start of a block.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Meridian<R> {
    /// sinφ.
    pub sine: R,
    /// cosφ.
    pub cosine: R,
    /// (R_N + h)cosφ, m: the distance from the axis.
    axis_distance: R,
    /// R = R_M + h, m.
    radius: R,
    /// 1/R.
    inverse_radius: R,
    /// R_M′, m/rad.
    slope: R,
    /// R_M″, m/rad².
    second_slope: R,
}

/// The change of place by a displacement.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PlaceChange<R> {
    /// Δφ, rad.
    pub latitude: R,
    /// Δλ, rad.
    pub longitude: R,
    /// Δh, m.
    pub altitude: R,
    /// sin Δφ.
    pub sine: R,
    /// cos Δφ − 1.
    pub cosine_less_one: R,
    /// N − N′, the effect of the displacement to the east, m: RΔφ = N′ − bend.
    pub(crate) inward: R,
    /// Δh sinΔφ + R_M′Δφ²/2 + (R_M″ − R)Δφ³/6 − 7R_M′Δφ⁴/24, m.
    pub(crate) bend: R,
}

impl<R: Real> PlaceChange<R> {
    /// Δφ, Δλ and Δh as they are.
    #[inline(always)]
    pub(crate) fn whole(&self) -> Geodetic<Pair<R>> {
        let Self { latitude, longitude, altitude, .. } = *self;
        Geodetic { latitude, longitude, altitude }.map(Pair::new)
    }
}

/// 1/W − 1 at a latitude's sine, W = √(1 − e² sin²φ), without cancellation.
#[inline(always)]
pub fn curvature<R: Real>(sine: R) -> R {
    let bulge = R::of(ECCENTRICITY_SQUARED) * sine * sine;
    let w2 = R::ONE - bulge;
    bulge / (w2.sqrt() + w2)
}

impl<R: Real> Meridian<R> {
    /// At a latitude and altitude; `curvature` is 1/W − 1 there.
    #[inline(always)]
    pub fn at(sine: R, cosine: R, altitude: R, curvature: R) -> Self {
        const E2: f64 = ECCENTRICITY_SQUARED;
        // R_N = a/W, R_M = a(1 − e²)/W³
        let inverse_w = R::ONE + curvature;
        let inverse_w2 = inverse_w * inverse_w;
        let prime_vertical = R::of(SEMI_MAJOR_AXIS) * inverse_w;
        let meridian = R::of(SEMI_MAJOR_AXIS * (1.0 - E2)) * inverse_w * inverse_w2;
        // R_M′ = 3R_M e²sc/W²,  R_M″ = 3e²[R_M(c² − s²) + R_M′sc + 2R_M e²s²c²/W²]/W²
        let sc = sine * cosine;
        let bend = R::of(E2) * inverse_w2;
        let slope = R::of(3.0) * bend * meridian * sc;
        let second_slope = R::of(3.0)
            * bend
            * (meridian * (cosine * cosine - sine * sine)
                + sc * (slope + R::TWO * bend * meridian * sc));
        let radius = meridian + altitude;
        Self {
            sine,
            cosine,
            axis_distance: (prime_vertical + altitude) * cosine,
            radius,
            inverse_radius: R::ONE / radius,
            slope,
            second_slope,
        }
    }

    /// (R_N + h)cosφ, m: the distance from the axis.
    pub(crate) fn axis_distance(&self) -> R {
        self.axis_distance
    }

    /// The change of place of a displacement relative to the Earth, north, east, down at the start, m.
    #[inline(always)]
    pub fn moved(&self, displacement: Vector<R>) -> PlaceChange<R> {
        let Vector { x: north, y: east, z: down } = displacement;
        let (s, c) = (self.sine, self.cosine);
        // x = (R_N + h)c − D_N s − D_D c,  tan Δλ = y = D_E/x
        let y = east / (self.axis_distance - north * s - down * c);
        let y2 = square(y);
        // atan y = y − y³/3 + y⁵/5
        let longitude = y - y * y2 * (R::of(1.0 / 3.0) - y2 * R::of(0.2));
        // A displacement to the east increases the distance from the axis beyond x by
        // δ = √(x² + D_E²) − x = ½D_E y(1 − y²/4)
        let outward = east * y * R::HALF * (R::ONE - y2 * R::of(0.25));
        let inward = s * outward;
        let north = north - inward;
        let up = c * outward - down;
        // Δh = U′ + RΔ²/2 + R_M′Δ³/3 + (R_M″/8 − R/24)Δ⁴ + Δh(1 − cosΔ)
        // Δ = (N′ − Δh sinΔ − R_M′Δ²/2 − (R_M″ − R)Δ³/6 − (R_M‴/24 − R_M′/8)Δ⁴)/R, R_M‴ ≈ −4R_M′
        let fourth = self.second_slope * R::of(0.125) - self.radius * R::of(1.0 / 24.0);
        let third = (self.second_slope - self.radius) * R::of(1.0 / 6.0);
        let last = self.slope * R::of(7.0 / 24.0);
        let mut latitude = north * self.inverse_radius;
        let mut altitude = up;
        let mut bend = R::ZERO;
        for _ in 0..2 {
            let d = latitude;
            let d2 = square(d);
            let versine = d2 * (R::HALF - d2 * R::of(1.0 / 24.0));
            altitude = up
                + d2 * (self.radius * R::HALF + d * (self.slope * R::of(1.0 / 3.0) + d * fourth))
                + altitude * versine;
            let sine = d - d * d2 * R::of(1.0 / 6.0);
            bend = altitude * sine + d2 * (self.slope * R::HALF + d * (third - d * last));
            latitude = (north - bend) * self.inverse_radius;
        }
        let d2 = square(latitude);
        PlaceChange {
            latitude,
            longitude,
            altitude,
            sine: latitude - latitude * d2 * (R::of(1.0 / 6.0) - d2 * R::of(1.0 / 120.0)),
            cosine_less_one: -(d2 * (R::HALF - d2 * R::of(1.0 / 24.0))),
            inward,
            bend,
        }
    }

    /// q_{n1}^{n0} less one: the rotation of the local-level frame in inertial space while it moves by
    /// `change` and the Earth rotates; `inertial_longitude` is Δl = Δλ + ωT.
    #[inline(always)]
    pub fn frame_turn(&self, change: &PlaceChange<R>, inertial_longitude: R) -> Quaternion<R> {
        // [cos ½Δl, sin ½Δl·(c, 0, −s)] ⊗ [cos ½Δφ, 0, −sin ½Δφ, 0]
        let (a, a_less_one) = half_angle(inertial_longitude);
        let (b, b_less_one) = half_angle(change.latitude);
        let (s, c) = (self.sine, self.cosine);
        Quaternion::new(
            a_less_one + b_less_one + a_less_one * b_less_one,
            Vector::new(
                a * c + (a * c * b_less_one - a * s * b),
                -(b + b * a_less_one),
                -(a * s + (a * s * b_less_one + a * c * b)),
            ),
        )
    }
}

/// x², or 0 if it vanishes beside 1: at rest higher powers would be subnormal, and slow on some processors.
#[inline(always)]
pub(crate) fn square<R: Real>(x: R) -> R {
    let square = x * x;
    R::select(square.less(R::of(1e-20)), R::ZERO, square)
}

/// sin ½x and cos ½x − 1 of a small angle.
#[inline(always)]
fn half_angle<R: Real>(x: R) -> (R, R) {
    let half = x * R::HALF;
    let h2 = square(half);
    (
        half - half * h2 * (R::of(1.0 / 6.0) - h2 * R::of(1.0 / 120.0)),
        -(h2 * (R::HALF - h2 * R::of(1.0 / 24.0))),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sine_and_cosine_of_a_step_are_those_of_its_angle() {
        // The equator is among them: there R_M′ is 0.
        for latitude in [0.0, 0.4, -1.2] {
            let (s, c) = Real::sin_cos(latitude);
            let here = Meridian::at(s, c, 500.0, curvature(s));
            for north in [0.0, 30.0, -2000.0, 10_000.0] {
                let change = here.moved(Vector::new(north, 1000.0, -20.0));
                let d = change.latitude;
                let (half, _) = Real::sin_cos(0.5 * d);
                let (sine, _) = Real::sin_cos(d);
                // The terms that follow, and rounding.
                let d2 = d * d;
                let left = d2 * d2 * d2 / 720.0 + 4.0 * f64::EPSILON * d2;
                assert!((change.cosine_less_one + 2.0 * half * half).abs() <= left, "{change:?}");
                let left = d2 * d2 * d2 * d.abs() / 5040.0 + 4.0 * f64::EPSILON * d.abs();
                assert!((change.sine - sine).abs() <= left, "{change:?}");
            }
        }
    }
}
