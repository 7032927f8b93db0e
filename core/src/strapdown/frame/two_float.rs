//! Single precision to millimetres: the products of the local-level step that are carried to twice the
//! digits, because their systematic rounding would grow with time.
//!
//! These are the quotients that turn metres into radians, the rotation of the velocity increment, and the
//! two products that turn the attitude. All other terms round at random, which is harmless.

use super::meridian::{PlaceChange, square};
use crate::earth::{
    CENTRIFUGAL_RATIO, ECCENTRICITY_SQUARED, EQUATORIAL_GRAVITY, FLATTENING, Geodetic,
    SEMI_MAJOR_AXIS, SOMIGLIANA,
};
use crate::math::compensated::{Pair, two_sum};
use crate::math::quaternion::Quaternion;
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::strapdown::block::body::BodyMotion;

/// The start of a block: sine and cosine of its latitude, and its altitude (m).
#[derive(Clone, Copy)]
pub(crate) struct Place<R> {
    pub sine: Pair<R>,
    pub cosine: Pair<R>,
    pub altitude: Pair<R>,
}

impl<R: Real> Place<R> {
    /// The change of place, rad and m, whose leading digits are known.
    #[inline(always)]
    pub fn change(
        &self,
        rough: &PlaceChange<R>,
        moved: Vector<R>,
        moved_low: Vector<R>,
    ) -> Geodetic<Pair<R>> {
        let Self { sine, cosine, altitude } = *self;
        // 1/W, R_N = a/W, R_M = a(1 − e²)/W³
        let bulge = Pair::of(ECCENTRICITY_SQUARED) * sine * sine;
        let inverse_w = (Pair::new(R::ONE) - bulge).sqrt().reciprocal();
        let prime_vertical = Pair::of(SEMI_MAJOR_AXIS) * inverse_w;
        let meridian =
            prime_vertical * Pair::of(1.0 - ECCENTRICITY_SQUARED) * inverse_w * inverse_w;
        // Δφ = N′/R − bend/R: bend is below an ulp of N′ and must not be subtracted from it
        let inverse_radius = (meridian + altitude).reciprocal();
        let (arc, low) = two_sum(moved.x, -rough.inward);
        let mut latitude = Pair { hi: arc, lo: low + moved_low.x } * inverse_radius;
        latitude.lo = latitude.lo - rough.bend * inverse_radius.hi;
        // Δλ = y − y³/3, y = D_E/((R_N + h)c − D_N s − D_D c)
        let nearer = Pair::new(moved.x * sine.hi + moved.z * cosine.hi);
        let distance = (prime_vertical + altitude) * cosine - nearer;
        let mut longitude = Pair { hi: moved.y, lo: moved_low.y } * distance.reciprocal();
        let y = longitude.hi;
        longitude.lo = longitude.lo - y * square(y) * R::of(1.0 / 3.0);
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

/// γ − γ_e at a latitude and altitude, m/s², with its remainder: half an ulp of γ − γ_e is a steady fall of
/// centimetres in half an hour.
#[inline(always)]
pub(crate) fn gravity_excess<R: Real>(sine: Pair<R>, altitude: Pair<R>) -> Pair<R> {
    // γ/γ_e − 1 = A + B + AB with A = k s² + (1 + k s²)(1/W − 1) and B = −(2/a)(1 + f + m − 2f s²)h + 3h²/a².
    // The rounding of the first order, (k + ½e²)s² − (2/a)(1 + f + m)h, matters; that of the rest does not.
    const A: f64 = SEMI_MAJOR_AXIS;
    const BY_LATITUDE: f64 = SOMIGLIANA + 0.5 * ECCENTRICITY_SQUARED;
    const BY_HEIGHT: f64 = -2.0 / A * (1.0 + FLATTENING + CENTRIFUGAL_RATIO);
    let s2 = sine * sine;
    let (x, h) = (s2.hi, altitude.hi);
    // 1/W − 1 = ½e²s² + ⅜(e²s²)² + ⁵⁄₁₆(e²s²)³ + ³⁵⁄₁₂₈(e²s²)⁴
    let bulge = R::of(ECCENTRICITY_SQUARED) * x;
    let curved =
        bulge * bulge * (R::of(0.375) + bulge * (R::of(0.3125) + bulge * R::of(35.0 / 128.0)));
    let somigliana = R::of(SOMIGLIANA) * x;
    let bent = curved + somigliana * (bulge * R::HALF + curved);
    let lifted = h * (R::of(4.0 * FLATTENING / A) * x + R::of(3.0 / (A * A)) * h);
    let a = R::of(BY_LATITUDE) * x + bent;
    let b = R::of(BY_HEIGHT) * h + lifted;
    let rest = (bent + lifted + a * b) * R::of(EQUATORIAL_GRAVITY);
    Pair::of(EQUATORIAL_GRAVITY * BY_LATITUDE) * s2
        + Pair::of(EQUATORIAL_GRAVITY * BY_HEIGHT) * altitude
        + Pair::new(rest)
}

/// sin ½x of a small angle.
#[inline(always)]
fn half_sine<R: Real>(x: Pair<R>) -> Pair<R> {
    let half = Pair { hi: x.hi * R::HALF, lo: x.lo * R::HALF };
    let h = half.hi;
    Pair { hi: h, lo: half.lo - h * square(h) * R::of(1.0 / 6.0) }
}

/// cos ½x − 1 of a small angle, from its half's sine.
#[inline(always)]
fn cosine_less_one<R: Real>(half: R) -> R {
    -(square(half) * R::HALF)
}

/// Δl = Δλ + ωT, rounded, including the remainder of the blocks before; returns the new remainder, too.
#[inline(always)]
pub(crate) fn inertial_longitude<R: Real>(change: Pair<R>, turn: Pair<R>, rest: R) -> (R, R) {
    let (sum, low) = two_sum(change.hi, turn.hi);
    let low = low + turn.lo + change.lo + rest;
    let rounded = sum + low;
    (rounded, low - (rounded - sum))
}

/// A factor of exact products: a number in two halves, and its remainder.
#[derive(Clone, Copy)]
struct Factor<R> {
    number: R,
    upper: R,
    lower: R,
    remainder: R,
}

impl<R: Real> Factor<R> {
    #[inline(always)]
    fn of(x: Pair<R>) -> Self {
        let upper = x.hi.upper_half();
        Self { number: x.hi, upper, lower: x.hi - upper, remainder: x.lo }
    }
}

impl<R: Real> core::ops::Neg for Factor<R> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        let Self { number, upper, lower, remainder } = self;
        Self { number: -number, upper: -upper, lower: -lower, remainder: -remainder }
    }
}

/// Σ aᵢbᵢ with its remainder.
#[inline(always)]
fn sum_of_products<R: Real, const N: usize>(factors: [(Factor<R>, Factor<R>); N]) -> Pair<R> {
    let mut sum = Pair { hi: R::ZERO, lo: R::ZERO };
    for (n, (a, b)) in factors.into_iter().enumerate() {
        let p = a.number * b.number;
        let rounded =
            ((a.upper * b.upper - p) + a.upper * b.lower + a.lower * b.upper) + a.lower * b.lower;
        let low = rounded + (a.number * b.remainder + a.remainder * b.number);
        sum = if n == 0 {
            Pair { hi: p, lo: low }
        } else {
            let (hi, rest) = two_sum(sum.hi, p);
            Pair { hi, lo: sum.lo + (rest + low) }
        };
    }
    sum
}

/// An attitude whose products are carried to twice the digits.
#[derive(Clone, Copy)]
pub(crate) struct Attitude<R> {
    w: Factor<R>,
    v: Vector<Factor<R>>,
}

impl<R: Real> Attitude<R> {
    #[inline(always)]
    pub fn of(q: Quaternion<Pair<R>>) -> Self {
        Self { w: Factor::of(q.w), v: q.v.map(Factor::of) }
    }

    /// C u with its remainder.
    #[inline(always)]
    pub fn rotated(&self, body: &BodyMotion<R>) -> Vector<Pair<R>> {
        // t = 2 qᵥ × u,  C u = u + w t + qᵥ × t
        let Self { w, v: Vector { x, y, z } } = *self;
        let u = body.velocity.zip(body.velocity_low, |hi, lo| Pair { hi, lo });
        let f = u.map(Factor::of);
        let twice = |p: Pair<R>| Factor::of(Pair::sum(p.hi + p.hi, p.lo + p.lo));
        let t = Vector::new(
            twice(sum_of_products([(y, f.z), (-z, f.y)])),
            twice(sum_of_products([(z, f.x), (-x, f.z)])),
            twice(sum_of_products([(x, f.y), (-y, f.x)])),
        );
        let added = Vector::new(
            sum_of_products([(w, t.x), (y, t.z), (-z, t.y)]),
            sum_of_products([(w, t.y), (z, t.x), (-x, t.z)]),
            sum_of_products([(w, t.z), (x, t.y), (-y, t.x)]),
        );
        u.zip(added, |u, d| {
            let (hi, rest) = two_sum(u.hi, d.hi);
            Pair { hi, lo: rest + (u.lo + d.lo) }
        })
    }

    /// The change of q by the body's rotation e and the frame's rotation m: (1 + m)* ⊗ q ⊗ (1 + e) − q.
    #[inline(always)]
    pub fn turned(
        &self,
        body: &BodyMotion<R>,
        frame: Quaternion<Pair<R>>,
    ) -> (Quaternion<Pair<R>>, Quaternion<Pair<R>>) {
        let Self { w, v: Vector { x, y, z } } = *self;
        // q ⊗ e
        let e = Attitude::of(rotation(body));
        let (ew, e) = (e.w, e.v);
        let body_turn = Quaternion::new(
            sum_of_products([(-x, e.x), (-y, e.y), (-z, e.z), (w, ew)]),
            Vector::new(
                sum_of_products([(w, e.x), (y, e.z), (-z, e.y), (x, ew)]),
                sum_of_products([(w, e.y), (z, e.x), (-x, e.z), (y, ew)]),
                sum_of_products([(w, e.z), (x, e.y), (-y, e.x), (z, ew)]),
            ),
        );
        // m* ⊗ (q + q ⊗ e): m's scalar part and its product with q ⊗ e are small
        let m = frame.v.map(Factor::of);
        let frame_turn = Quaternion::new(
            sum_of_products([(x, m.x), (y, m.y), (z, m.z)]),
            Vector::new(
                sum_of_products([(-w, m.x), (y, m.z), (-z, m.y)]),
                sum_of_products([(-w, m.y), (z, m.x), (-x, m.z)]),
                sum_of_products([(-w, m.z), (x, m.y), (-y, m.x)]),
            ),
        );
        let back = frame.map(|c| c.hi).conjugate();
        let whole = Quaternion::new(w.number, self.v.map(|c| c.number));
        let both = back * body_turn.map(|c| c.hi) + whole * back.w;
        let frame_turn = Quaternion::new(
            Pair { lo: frame_turn.w.lo + both.w, ..frame_turn.w },
            frame_turn.v.zip(both.v, |t, small| Pair { lo: t.lo + small, ..t }),
        );
        (body_turn, frame_turn)
    }
}

/// e with its remainder.
#[inline(always)]
fn rotation<R: Real>(body: &BodyMotion<R>) -> Quaternion<Pair<R>> {
    let Quaternion { w, v } = body.rotation;
    Quaternion::new(Pair::new(w), v.zip(body.rotation_low, |hi, lo| Pair { hi, lo }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::earth;

    #[test]
    fn gravity_beyond_that_of_the_equator_is_the_difference() {
        for (latitude, altitude) in [(0.0, 0.0), (0.3, -400.0), (0.8, 20_000.0), (-1.57, 3000.0)] {
            let (s, _) = Real::sin_cos(latitude);
            let excess = gravity_excess(Pair::new(s), Pair::new(altitude)).hi;
            let exact = earth::gravity(s, altitude) - EQUATORIAL_GRAVITY;
            // The fifth term of 1/W − 1, 63/256 of the power, and four ulps of gravity.
            let bulge = ECCENTRICITY_SQUARED * s * s;
            let left = 2.5 * (bulge * bulge) * (bulge * bulge) * bulge + 8e-15;
            assert!((excess - exact).abs() <= left, "{latitude} {altitude}: {excess} {exact}");
        }
    }

    #[test]
    fn the_frames_turn_is_the_product_of_two() {
        let about = |axis: Vector<f64>, angle: f64| {
            let (sine, cosine) = Real::sin_cos(0.5 * angle);
            Quaternion::new(cosine, axis * sine)
        };
        let (s, c) = Real::sin_cos(0.7);
        let place = Place { sine: Pair::new(s), cosine: Pair::new(c), altitude: Pair::default() };
        for (latitude, longitude) in [(1e-4, 0.0), (0.0, 2e-4), (1e-4, 2e-4), (-3e-4, 1e-4)] {
            let exact = about(Vector::new(c, 0.0, -s), longitude)
                * about(Vector::new(0.0, -1.0, 0.0), latitude);
            let turn = place.frame_turn(exact, Pair::new(latitude), longitude);
            let off = turn.v.zip(exact.v, |a, b| a.hi - b).norm();
            // The product of the half angles stands for that of their sines.
            let (a, b) = (0.5 * longitude, 0.5 * latitude);
            let left = (a * b * (a * a + b * b)).abs() / 6.0 * 1.001 + 1e-19;
            assert!(off <= left, "{latitude} {longitude}: {off:e}");
        }
    }
}
