//! Single precision to millimetres: the products of the local-level step that are carried to twice the
//! digits, where a systematic rounding would grow with time.
//!
//! These are the quotients that turn metres into radians, the rotation of the velocity increment, and the
//! two products that turn the attitude. Everything else rounds at random and may.

use super::body::BodyMotion;
use super::meridian::PlaceChange;
use crate::earth::{ECCENTRICITY_SQUARED, Geodetic, SEMI_MAJOR_AXIS};
use crate::math::compensated::{Pair, two_sum};
use crate::math::quaternion::Quaternion;
use crate::math::real::Real;
use crate::math::vector::Vector;

/// Where a block starts: sine and cosine of its latitude, its altitude (m).
#[derive(Clone, Copy)]
pub(super) struct Place<R> {
    pub sine: Pair<R>,
    pub cosine: Pair<R>,
    pub altitude: Pair<R>,
}

impl<R: Real> Place<R> {
    /// The change of place, rad and m, whose leading digits are known.
    #[inline(always)]
    pub fn change(&self, rough: &PlaceChange<R>, moved: Vector<R>) -> Geodetic<Pair<R>> {
        let Self { sine, cosine, altitude } = *self;
        // 1/W, R_N = a/W, R_M = a(1 − e²)/W³
        let bulge = Pair::of(ECCENTRICITY_SQUARED) * sine * sine;
        let inverse_w = (Pair::new(R::ONE) - bulge).sqrt().reciprocal();
        let prime_vertical = Pair::of(SEMI_MAJOR_AXIS) * inverse_w;
        let meridian =
            prime_vertical * Pair::of(1.0 - ECCENTRICITY_SQUARED) * inverse_w * inverse_w;
        // Δφ = N′/R − bend/R: what bends is below an ulp of N′ and must not be lost in it
        let inverse_radius = (meridian + altitude).reciprocal();
        let mut latitude = Pair::new(rough.arc) * inverse_radius;
        latitude.lo = latitude.lo - rough.bend * inverse_radius.hi;
        // Δλ = y − y³/3, y = D_E/((R_N + h)c − D_N s − D_D c)
        let nearer = Pair::new(moved.x * sine.hi + moved.z * cosine.hi);
        let distance = (prime_vertical + altitude) * cosine - nearer;
        let mut longitude = Pair::new(moved.y) * distance.reciprocal();
        let y = longitude.hi;
        longitude.lo = longitude.lo - y * y * y * R::of(1.0 / 3.0);
        Geodetic { latitude, longitude, altitude: Pair::new(rough.altitude) }
    }

    /// The frame's turn less one (`rough`) with its remainder: q_{n1}^{n0} for Δφ and Δl.
    #[inline(always)]
    pub fn frame_turn(
        &self,
        rough: Quaternion<R>,
        latitude: Pair<R>,
        inertial_longitude: R,
    ) -> Quaternion<Pair<R>> {
        let (a, b) = (half_sine(Pair::new(inertial_longitude)), half_sine(latitude));
        // (a cosφ, −b, −a sinφ) to first order; the rest of second order is small
        let first = Vector::new(a * self.cosine, -b, -(a * self.sine));
        let (s, c) = (self.sine.hi, self.cosine.hi);
        let (a_less_one, b_less_one) = (cosine_less_one(a.hi), cosine_less_one(b.hi));
        let second = Vector::new(
            a.hi * c * b_less_one - a.hi * s * b.hi,
            -(b.hi * a_less_one),
            -(a.hi * s * b_less_one + a.hi * c * b.hi),
        );
        Quaternion::new(Pair::new(rough.w), first.zip(second, |a, b| a + Pair::new(b)))
    }
}

/// sin ½x of a small angle.
#[inline(always)]
fn half_sine<R: Real>(x: Pair<R>) -> Pair<R> {
    let half = Pair { hi: x.hi * R::HALF, lo: x.lo * R::HALF };
    let h = half.hi;
    Pair { hi: h, lo: half.lo - h * h * h * R::of(1.0 / 6.0) }
}

/// cos ½x − 1 of a small angle, from its half's sine.
#[inline(always)]
fn cosine_less_one<R: Real>(half: R) -> R {
    -(half * half * R::HALF)
}

/// Δl = Δλ + ωT rounded, with what rounding left over from the blocks before; returns the new rest.
#[inline(always)]
pub(super) fn inertial_longitude<R: Real>(change: Pair<R>, turn: Pair<R>, rest: R) -> (R, R) {
    let (sum, low) = two_sum(change.hi, turn.hi);
    let low = low + turn.lo + change.lo + rest;
    let rounded = sum + low;
    (rounded, low - (rounded - sum))
}

/// C u with its remainder.
#[inline(always)]
pub(super) fn rotated<R: Real>(
    attitude: Quaternion<Pair<R>>,
    body: &BodyMotion<R>,
) -> Vector<Pair<R>> {
    let u = body.velocity.zip(body.velocity_low, |hi, lo| Pair { hi, lo });
    attitude.matrix(Pair::new(R::ONE)) * u
}

/// e with its remainder.
#[inline(always)]
pub(super) fn rotation<R: Real>(body: &BodyMotion<R>) -> Quaternion<Pair<R>> {
    let Quaternion { w, v } = body.rotation;
    Quaternion::new(Pair::new(w), v.zip(body.rotation_low, |hi, lo| Pair { hi, lo }))
}
