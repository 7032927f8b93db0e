//! Single precision to millimetres in Earth-fixed axes: the terms of the step that are carried to twice the
//! digits.
//!
//! These are position and the terms of similar effect: its rotation with the Earth, v T, and gravitation, whose
//! direction is that of the position. The other terms of a block round at random, which is harmless.

use super::{EarthFixed, EarthFixedStep};
use crate::earth::{ECCENTRICITY_SQUARED, EQUATORIAL_GRAVITY, ROTATION_RATE, SEMI_MAJOR_AXIS};
use crate::math::compensated::{Accumulate, Pair, two_product};
use crate::math::quaternion::Quaternion;
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::strapdown::block::body::BodyMotion;
use crate::strapdown::frame::block_time::BlockTime;
use crate::strapdown::frame::gravitation::Latitude;
use crate::strapdown::frame::two_float::{Attitude, gravity_excess};

/// Gravitation at a position, m/s², with its remainder, from the latitude of the leading parts and one Newton
/// step with all digits.
#[inline(never)]
pub(super) fn gravitation<R: Real>(
    latitude: &mut Latitude<R>,
    position_e: Vector<Pair<R>>,
) -> Vector<Pair<R>> {
    const E2: f64 = ECCENTRICITY_SQUARED;
    let one = Pair::new(R::ONE);
    let scaled = |x: Pair<R>, k: R| Pair { hi: x.hi * k, lo: x.lo * k };
    latitude.gravitation(position_e.map(|c| c.hi));
    // Of unit length to twice the digits: s + ½s(1 − s² − c²)
    let (s, c) = (Pair::new(latitude.sine), Pair::new(latitude.cosine));
    let short = (one - s * s - c * c).hi * R::HALF;
    let (s, c) = (Pair { lo: s.hi * short, ..s }, Pair { lo: c.hi * short, ..c });
    let Vector { x, y, z } = position_e;
    let p = root(x * x + y * y);
    // W = √(1 − e²s²), N = a/W, R_M = a(1 − e²)/W³,  h = pc + zs − aW
    let w = (one - Pair::of(E2) * s * s).sqrt();
    let prime_vertical = Pair::of(SEMI_MAJOR_AXIS) * w.reciprocal();
    let altitude = p * c + z * s - Pair::of(SEMI_MAJOR_AXIS) * w;
    // e = (cz − sp + e²N sc)/(R_M + h)
    let along = (c * z - s * p + Pair::of(E2) * prime_vertical * s * c).hi;
    let w3 = w.hi * w.hi * w.hi;
    let meridian = R::of(SEMI_MAJOR_AXIS * (1.0 - E2)) / w3;
    let error = along / (meridian + altitude.hi);
    // s ← s + ec − ½e²s,  h ← h + ½·e·along,  N ← N + N e²sc·e/W²
    let bend = error * error * R::HALF;
    let sine = s + Pair::new(error * c.hi - bend * s.hi);
    let altitude = altitude + Pair::new(along * error * R::HALF);
    let growth = R::of(E2 * SEMI_MAJOR_AXIS) * s.hi * c.hi * error / w3;
    // G = (−(γ/(N + h) + ω²)x, −(γ/(N + h) + ω²)y, −γ sinφ)
    let gravity = Pair::of(EQUATORIAL_GRAVITY) + gravity_excess(sine, altitude);
    let pull = gravity * (prime_vertical + altitude + Pair::new(growth)).reciprocal();
    let spin = R::of(ROTATION_RATE * ROTATION_RATE);
    let pulled = |x: Pair<R>| -(pull * x + scaled(x, spin));
    Vector::new(pulled(x), pulled(y), -(gravity * sine))
}

/// √x, to about twice the digits; if it is nearly 0, without a remainder.
#[inline(always)]
pub(crate) fn root<R: Real>(x: Pair<R>) -> Pair<R> {
    let s = x.hi.sqrt();
    let (p, e) = two_product(s, s);
    let none = s.less(R::of(1e-6));
    let twice = R::select(none, R::ONE, s + s);
    Pair::sum(s, R::select(none, R::ZERO, ((x.hi - p) - e + x.lo) / twice))
}

/// (Rz(−α) − 1)v, given sinα with its remainder and cosα − 1.
#[inline(always)]
fn turn_less_one<R: Real>(
    v: Vector<Pair<R>>,
    sine: Pair<R>,
    cosine_less_one: R,
) -> Vector<Pair<R>> {
    let turned = |a: Pair<R>, b: Pair<R>| {
        let Pair { hi, lo } = b * sine;
        Pair { hi, lo: lo + a.hi * cosine_less_one }
    };
    Vector::new(turned(v.x, v.y), turned(v.y, -v.x), Pair::default())
}

/// sin x of a small angle.
#[inline(always)]
fn small_sine<R: Real>(x: Pair<R>) -> Pair<R> {
    Pair { lo: x.lo - x.hi * x.hi * x.hi * R::of(1.0 / 6.0), ..x }
}

impl<R: Real, S: Accumulate<Real = R>> EarthFixed<S> {
    /// The step with these terms; the equations are [`step`](crate::strapdown::frame::Frame::step)'s.
    #[inline(always)]
    pub(super) fn step_two_float(
        &mut self,
        time: &BlockTime<R>,
        body: &BodyMotion<R>,
    ) -> EarthFixedStep<R> {
        let t = time.time.hi;
        let matrix = self.attitude.value().matrix(R::ONE);
        let attitude = Attitude::of(self.attitude.pair());
        let (g0, low) = (self.gravitation, self.gravitation_low);
        // Δr = vT + C s + T²(½G₀ + …)
        let fall = self.fall();
        let rest = matrix * body.position
            + fall * time.square
            + self.velocity.low_product(time.time, R::ONE);
        let straight = self.velocity.value().map(|v| two_product(v, t));
        let moved = straight.zip(rest, |(hi, lo), rest| Pair { hi, lo: lo + rest });
        let position = self.position.pair().zip(moved, |a, b| a + b);
        // Δv = C u + TG₀ + T(½δ − …)
        let g1 = gravitation(&mut self.latitude, position);
        let g1_low = g1.map(|c| c.lo);
        let g1 = g1.map(|c| c.hi);
        let delta = (g1 - g0) + (g1_low - low);
        let (slope, curvature) = self.history.parabola(delta);
        let mean = self.history.advance(delta);
        let pull = g0.zip(low, |hi, lo| Pair { hi, lo } * time.time);
        let pulled = attitude.rotated(body).zip(pull, |a, b| a + b);
        let gained = pulled.zip(mean * t, |a, b| a + Pair::new(b));
        let velocity = self.velocity.pair().zip(gained, |a, b| a + b);

        // All are rotated with the Earth, by Rz(−ωT), as increments.
        let sine = small_sine(time.turn);
        let turn = |v| turn_less_one(v, sine, time.turn_cosine_less_one);
        self.position.accumulate_pair(moved);
        self.position.accumulate_pair(turn(position));
        self.velocity.accumulate_pair(gained);
        self.velocity.accumulate_pair(turn(velocity));
        let turned = g1.zip(g1_low, |hi, lo| Pair { hi, lo });
        let turned = turned.zip(turn(turned), |a, b| a + b);
        self.gravitation = turned.map(|c| c.hi);
        self.gravitation_low = turned.map(|c| c.lo);
        self.turn_history(time);
        // q ← q_z(−ωT) ⊗ q ⊗ q_bb
        let half = Pair { hi: time.turn.hi * R::HALF, lo: time.turn.lo * R::HALF };
        let axis = Vector::new(Pair::default(), Pair::default(), small_sine(half));
        let frame = Quaternion::new(Pair::new(time.half_turn_cosine_less_one), axis);
        let (body_turn, frame_turn) = attitude.turned(body, frame);
        self.attitude.accumulate_pair(body_turn);
        self.attitude.accumulate_pair(frame_turn);
        self.attitude.keep_unit();
        EarthFixedStep { matrix, slope, curvature }
    }
}
