//! Gravitation at an Earth-fixed position, with a latitude that is kept from step to step.
//!
//! Nothing divides by the distance from the axis, so the poles are like any other place. The latitude
//! of the last position plus its last change predicts the next one so well that one Newton step
//! reaches full precision; only a cold start takes more.
//!
//! ```
//! use schuler::earth::Geodetic;
//! use schuler::strapdown::frame::gravitation::Latitude;
//!
//! let at = Geodetic { latitude: 0.8_f64, longitude: 0.0, altitude: 100.0 };
//! let mut latitude = Latitude { sine: 0.8_f64.sin(), cosine: 0.8_f64.cos(), change: 0.0 };
//! let gravitation = latitude.gravitation(at.to_earth_fixed());
//! assert!((gravitation.norm() - 9.82).abs() < 0.01);
//! ```

use crate::earth::{
    ECCENTRICITY_SQUARED, EQUATORIAL_GRAVITY, ROTATION_RATE, SEMI_MAJOR_AXIS, SOMIGLIANA,
    height_factor,
};
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::record::{Record, record};

/// Sine and cosine of a latitude, and its change since the position before.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Latitude<R> {
    /// sinφ.
    pub sine: R,
    /// cosφ, not negative.
    pub cosine: R,
    /// Δφ since the position before, rad.
    pub change: R,
}

/// A correction of the predicted latitude, rad, beyond which the last change is not used again.
const LEAP: f64 = 1e-3;

/// The result of one Newton step.
struct Newton<R> {
    error: R,
    inverse_w: R,
    altitude: R,
}

impl<R: Real> Latitude<R> {
    /// Moves on to a position and returns the gravitation there, m/s², in the position's axes.
    #[inline(always)]
    pub fn gravitation(&mut self, position_e: Vector<R>) -> Vector<R> {
        let Vector { x, y, z } = position_e;
        let axis_distance = (x * x + y * y).sqrt();
        self.predict();
        let mut newton = self.correct(axis_distance, z);
        // One step leaves at most 0.0051 times the square of its correction: below this bound that is rounding.
        let bound = R::entry(1e-5, 5e-7);
        let mut cold = bound.less(newton.error.abs());
        // After a leap the last change is no prediction.
        let leap = R::of(LEAP).less(newton.error.abs());
        self.change = R::select(leap, R::ZERO, self.change);
        let mut tries = 0;
        while R::any(cold) && tries < 8 {
            let mut again = *self;
            let length = (again.sine * again.sine + again.cosine * again.cosine).sqrt();
            again.sine = again.sine / length;
            again.cosine = again.cosine / length;
            let second = again.correct(axis_distance, z);
            again.change = R::select(leap, R::ZERO, again.change);
            self.sine = R::select(cold, again.sine, self.sine);
            self.cosine = R::select(cold, again.cosine, self.cosine);
            self.change = R::select(cold, again.change, self.change);
            newton.inverse_w = R::select(cold, second.inverse_w, newton.inverse_w);
            newton.altitude = R::select(cold, second.altitude, newton.altitude);
            newton.error = R::select(cold, second.error, R::ZERO);
            cold = bound.less(newton.error.abs());
            tries += 1;
        }
        // G = −γ n̂ + ω × (ω × r) = (−(γ/(N + h) + ω²)x, −(γ/(N + h) + ω²)y, −γ sinφ)
        let s2 = self.sine * self.sine;
        let gravity = R::of(EQUATORIAL_GRAVITY)
            * (R::ONE + R::of(SOMIGLIANA) * s2)
            * newton.inverse_w
            * (R::ONE + height_factor(s2, newton.altitude));
        let pull = gravity / (R::of(SEMI_MAJOR_AXIS) * newton.inverse_w + newton.altitude)
            + R::of(ROTATION_RATE * ROTATION_RATE);
        Vector::new(-(pull * x), -(pull * y), -(gravity * self.sine))
    }

    /// The gravitation at a position, m/s², if this latitude can be that of the position, or of a position half a
    /// sample before.
    pub(crate) fn belongs_to(&self, position_e: Vector<R>) -> Option<Vector<R>> {
        let (s, c) = (self.sine, self.cosine);
        let is_one = s.is_within(R::of(1.1))
            & c.is_within(R::of(1.1))
            & (s * s + c * c - R::ONE).is_within(R::of(1e-3))
            & self.change.is_within(R::ONE);
        if !is_one {
            return None;
        }
        let mut there = *self;
        let gravitation = there.gravitation(position_e);
        // 64 km along the meridian
        let apart =
            (there.sine - s).is_within(R::of(1e-2)) & (there.cosine - c).is_within(R::of(1e-2));
        apart.then_some(gravitation)
    }

    /// The ellipsoid's outward normal at a position with this latitude, and the height of an altitude
    /// above the position, m.
    pub fn vertical(&self, position_e: Vector<R>, altitude: R) -> (Vector<R>, R) {
        let Vector { x, y, z } = position_e;
        let (s, c) = (self.sine, self.cosine);
        let w = (R::ONE - R::of(ECCENTRICITY_SQUARED) * s * s).sqrt();
        let axis_distance = (x * x + y * y).sqrt();
        // h = pc + zs − aW;  n̂ = (x/(N + h), y/(N + h), sinφ)
        let height = axis_distance * c + z * s - R::of(SEMI_MAJOR_AXIS) * w;
        let inverse = R::ONE / (R::of(SEMI_MAJOR_AXIS) / w + height);
        (Vector::new(x * inverse, y * inverse, s), altitude - height)
    }

    /// Adds the last change.
    #[inline(always)]
    fn predict(&mut self) {
        // s ← s + c·S − s·K, c ← c − s·S − c·K,  S = d − d³/6, K = d²/2 − d⁴/24
        let d = self.change;
        let d2 = d * d;
        let sine = d - d * d2 * R::of(1.0 / 6.0);
        let versine = d2 * (R::HALF - d2 * R::of(1.0 / 24.0));
        let (s, c) = (self.sine, self.cosine);
        self.sine = s + (c * sine - s * versine);
        self.cosine = c - (s * sine + c * versine);
    }

    /// One Newton step to the latitude of (axis distance p, z).
    #[inline(always)]
    fn correct(&mut self, p: R, z: R) -> Newton<R> {
        const A: f64 = SEMI_MAJOR_AXIS;
        const E2: f64 = ECCENTRICITY_SQUARED;
        let (s, c) = (self.sine, self.cosine);
        // W = √(1 − e²s²), N = a/W, R_M = a(1 − e²)/W³
        let w = (R::ONE - R::of(E2) * s * s).sqrt();
        let inverse_w = R::ONE / w;
        let w3 = w * w * w;
        // h = pc + zs − aW, stationary in the latitude;  1/(R_M + h) = W³/(a(1 − e²) + W³h)
        let altitude = p * c + z * s - R::of(A) * w;
        // e = g/(R_M + h), g = cz − sp + e²N sc the way along the meridian;  h ← h + ½ge
        let along = c * z - s * p + R::of(E2 * A) * inverse_w * s * c;
        let error = along * w3 / (R::of(A * (1.0 - E2)) + w3 * altitude);
        let altitude = altitude + along * error * R::HALF;
        self.change = self.change + error;
        // s ← s + ec, c ← c − es, both times 1.5 − ½(s² + c²)
        let (s1, c1) = (s + error * c, c - error * s);
        let unit = R::of(1.5) - R::HALF * (s1 * s1 + c1 * c1);
        self.sine = s1 * unit;
        self.cosine = c1 * unit;
        // 1/W ← 1/W + e²sc·e/W³
        let inverse_w = inverse_w + inverse_w * inverse_w * inverse_w * R::of(E2) * s * c * error;
        Newton { error, inverse_w, altitude }
    }
}

impl<R: Record> Record for Latitude<R> {
    record!(sine, cosine, change);
}
