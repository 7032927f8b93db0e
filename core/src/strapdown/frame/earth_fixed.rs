//! The navigation step in Earth-fixed axes, which are singular nowhere.
//!
//! Velocity is inertial, resolved in the Earth-fixed axes: within a block the axes stand still, and
//! at its end position, velocity and gravity are rotated with the Earth. Gravitation is evaluated once per
//! block and extrapolated from its history (Adams).
//!
//! ```
//! use schuler::earth::Geodetic;
//! use schuler::math::{compensated::Pair, vector::Vector};
//! use schuler::solution::{Euler, Solution};
//! use schuler::strapdown::frame::{Frame, earth_fixed::EarthFixed};
//!
//! let at = Geodetic { latitude: 0.8_f64, longitude: 0.1, altitude: 100.0 };
//! let frame = EarthFixed::<Pair<f64>>::start(&Solution::new(at, Vector::ZERO, Euler::default()));
//! assert!(frame.check_place().is_ok());
//! ```

mod correct;
mod plausible;
mod stored;
mod two_float;

pub(crate) use two_float::root;

use super::block_time::{BlockTime, small_turn};
use super::gravitation::Latitude;
use super::gravity_history::GravityHistory;
use crate::earth::ROTATION_RATE;
use crate::math::compensated::{Accumulate, Pair, two_product, two_sum};
use crate::math::quaternion::{Matrix, Quaternion};
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::solution::{EarthFixedSolution, Solution};
use crate::strapdown::block::body::BodyMotion;
use crate::strapdown::correction::Correction;
use crate::strapdown::frame::Frame;
use crate::strapdown::frame::beginning::Beginning;
use crate::strapdown::limits::Rejected;
use crate::strapdown::place::check_earth_fixed;

/// State in Earth-fixed axes, summed by `S`.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct EarthFixed<S: Accumulate> {
    /// Position, m.
    position: Vector<S>,
    /// Velocity relative to inertial space, m/s.
    velocity: Vector<S>,
    /// Body → Earth-fixed.
    attitude: Quaternion<S>,
    /// G₀, m/s².
    gravitation: Vector<S::Real>,
    /// Its remainder; 0 without two-float products.
    gravitation_low: Vector<S::Real>,
    history: GravityHistory<S::Real>,
    latitude: Latitude<S::Real>,
}

/// What rows inside a block need: the attitude matrix and gravitation's parabola over the block.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct EarthFixedStep<R> {
    matrix: Matrix<R>,
    /// (G₁ − G₋₁)/2.
    slope: Vector<R>,
    /// (G₁ − 2G₀ + G₋₁)/2.
    curvature: Vector<R>,
}

/// (Rz(−α) − 1)v, given sinα and cosα − 1.
#[inline(always)]
fn turn_less_one<R: Real>(v: Vector<R>, sine: R, cosine_less_one: R) -> Vector<R> {
    Vector::new(v.x * cosine_less_one + v.y * sine, v.y * cosine_less_one - v.x * sine, R::ZERO)
}

/// q_z(−α) less one, given sin ½α and cos ½α − 1.
#[inline(always)]
fn turn_back<R: Real>(half_sine: R, half_cosine_less_one: R) -> Quaternion<R> {
    Quaternion::new(half_cosine_less_one, Vector::new(R::ZERO, R::ZERO, -half_sine))
}

/// Gravitation at a position with its remainder, as far as it is known.
#[inline(always)]
fn gravitation<R: Real, S: Accumulate<Real = R>>(
    latitude: &mut Latitude<R>,
    position_e: Vector<Pair<R>>,
) -> Vector<Pair<R>> {
    if S::TWO_FLOAT {
        two_float::gravitation(latitude, position_e)
    } else {
        latitude.gravitation(position_e.map(|c| c.hi)).map(Pair::new)
    }
}

impl<R: Real, S: Accumulate<Real = R>> EarthFixed<S> {
    /// The twofold integral of gravitation over a block, per T².
    #[inline(always)]
    fn fall(&self) -> Vector<R> {
        self.gravitation * R::HALF + self.history.twofold()
    }

    /// Rotates the history with the Earth, except ∇⁴, which is too small to need it.
    #[inline(always)]
    fn turn_history(&mut self, time: &BlockTime<R>) {
        let turn = |x: &mut Vector<R>| {
            *x = *x + turn_less_one(*x, time.turn_sine, time.turn_cosine_less_one);
        };
        turn(&mut self.history.difference);
        turn(&mut self.history.second_difference);
        turn(&mut self.history.third_difference);
    }
}

impl<R: Real, S: Accumulate<Real = R>> Frame for EarthFixed<S> {
    type Real = R;
    type Output = EarthFixedSolution<R>;
    type Step = EarthFixedStep<R>;
    const TWO_FLOAT: bool = S::TWO_FLOAT;

    fn start(initial: &Solution<R>) -> Self {
        let at = initial.to_earth_fixed();
        // v = v_e + ω × r
        let omega = Vector::new(Pair::default(), Pair::default(), Pair::of(ROTATION_RATE));
        let velocity = at.velocity_e + omega.cross(at.position_e);
        // As a pair: libm's functions of single precision compute in double.
        let (sine, cosine) = initial.position.latitude.sin_cos();
        let mut latitude = Latitude { sine: sine.hi, cosine: cosine.hi, change: R::ZERO };
        let gravitation = gravitation::<R, S>(&mut latitude, at.position_e);
        Self {
            position: at.position_e.map(S::from_pair),
            velocity: velocity.map(S::from_pair),
            attitude: at.attitude.map(S::from_pair),
            gravitation: gravitation.map(|c| c.hi),
            gravitation_low: gravitation.map(|c| c.lo),
            history: GravityHistory::NONE,
            latitude,
        }
    }

    #[inline(never)]
    fn seed(&mut self, time: &BlockTime<R>, body: &BodyMotion<R>) {
        self.history = GravityHistory::NONE;
        // G₋ₖ = G(r − kTv + ½(kT)²(a + G₀) − ⅙(kT)³(ȧ + ∇/T) + ¹⁄₂₄(kT)⁴ä), k = 1, 2, 3, 4
        let matrix = self.attitude.value().matrix(R::ONE);
        let force = Beginning::of(&matrix, body, time.time.hi);
        let acceleration = force.value + self.gravitation;
        for _ in 0..2 {
            let jerk = force.rate + self.history.difference * (R::ONE / time.time.hi);
            let back = |t: R| {
                let rest = jerk * R::of(1.0 / 6.0) - force.rate_growth * (t * R::of(1.0 / 24.0));
                let moved =
                    (acceleration * R::HALF - rest * t) * (t * t) - self.velocity.value() * t;
                let mut position = self.position;
                position.accumulate(moved);
                let mut latitude = self.latitude;
                // Relative to G₀.
                let there = gravitation::<R, S>(&mut latitude, position.map(S::pair));
                let high = there.map(|c| c.hi) - self.gravitation;
                high + (there.map(|c| c.lo) - self.gravitation_low)
            };
            self.history =
                GravityHistory::of([1, 2, 3, 4].map(|k| back(R::count(k) * time.time.hi)));
        }
        self.latitude.change = R::ZERO;
    }

    fn stretch(&mut self, factor: R) {
        self.history.stretch(factor);
        self.latitude.change = self.latitude.change * factor;
    }

    #[inline(always)]
    fn step(&mut self, time: &BlockTime<R>, body: &BodyMotion<R>) -> EarthFixedStep<R> {
        if S::TWO_FLOAT {
            return self.step_two_float(time, body);
        }
        let t = time.time.hi;
        let q = self.attitude.value();
        let matrix = q.matrix(R::ONE);
        let v = self.velocity.value();
        let moved = v * t
            + (matrix * body.position
                + self.fall() * time.square
                + self.velocity.low_product(time.time, R::ONE));
        let position = self.position.value() + moved;
        let g1 = self.latitude.gravitation(position);
        let delta = g1 - self.gravitation;
        // Δv = C u + T(G₀ + ½δ − …)
        let (slope, curvature) = self.history.parabola(delta);
        let mean = self.history.advance(delta);
        let gained = matrix * body.velocity + (self.gravitation + mean) * t;

        // All are rotated with the Earth, by Rz(−ωT), as increments.
        let turn = |x: Vector<R>| turn_less_one(x, time.turn_sine, time.turn_cosine_less_one);
        self.position.accumulate(moved + turn(position));
        self.velocity.accumulate(gained + turn(v + gained));
        self.gravitation = g1 + turn(g1);
        self.turn_history(time);
        // q ← q_z(−ωT) ⊗ q ⊗ q_bb
        let turned = q * body.rotation;
        let back = turn_back(time.half_turn_sine, time.half_turn_cosine_less_one);
        self.attitude.accumulate(turned + back * (q + turned));
        self.attitude.keep_unit();
        EarthFixedStep { matrix, slope, curvature }
    }

    #[inline]
    fn within(
        &self,
        step: &EarthFixedStep<R>,
        time: &BlockTime<R>,
        body: &BodyMotion<R>,
        fraction: R,
    ) -> EarthFixedSolution<R> {
        let t = time.time.hi;
        let (tau, tau2) = (fraction, fraction * fraction);
        let (g0, b, c) = (self.gravitation, step.slope, step.curvature);
        let v0 = self.velocity.value();
        // r = r₀ + vτT + C s + T²(τ²G₀/2 + τ³b/6 + τ⁴c/12)
        let fall =
            (g0 * R::HALF + b * (tau * R::of(1.0 / 6.0)) + c * (tau2 * R::of(1.0 / 12.0))) * tau2;
        let moved = v0 * (tau * t)
            + (step.matrix * body.position
                + fall * time.square
                + self.velocity.low_product(time.time, tau));
        // v = v₀ + C u + T(τG₀ + τ²b/2 + τ³c/3)
        let fall = g0 * tau + b * (tau2 * R::HALF) + c * (tau2 * tau * R::of(1.0 / 3.0));
        let gained = step.matrix * body.velocity + fall * t;
        // then Rz(−ωτT)
        let angle = time.turn.hi * tau;
        let (sine, cosine_less_one) = small_turn(angle);
        let turn = |x: Vector<R>| turn_less_one(x, sine, cosine_less_one);
        let (mut position, mut velocity, mut attitude) =
            (self.position, self.velocity, self.attitude);
        position.accumulate(moved + turn(position.value() + moved));
        velocity.accumulate(gained + turn(v0 + gained));
        let q = attitude.value();
        let turned = q * body.rotation;
        let (half_sine, half_cosine_less_one) = small_turn(angle * R::HALF);
        attitude.accumulate(turned + turn_back(half_sine, half_cosine_less_one) * (q + turned));
        solution(position, velocity, attitude)
    }

    fn hold_vertical(&mut self, altitude: R, down: R) {
        let r = self.position.value();
        let (up, lift) = self.latitude.vertical(r, altitude);
        let lifted = up * lift;
        self.position.accumulate(lifted);
        // Vertical velocity is the same relative to the Earth and to inertial space; horizontal velocity
        // relative to the Earth, v − ω × r, is kept.
        let omega = Vector::new(R::ZERO, R::ZERO, R::of(ROTATION_RATE));
        let climb = up.dot(self.velocity.value()) + down;
        self.velocity.accumulate(omega.cross(lifted) - up * climb);
        let mut latitude = self.latitude;
        let gravitation = gravitation::<R, S>(&mut latitude, self.position.map(S::pair));
        self.gravitation = gravitation.map(|c| c.hi);
        self.gravitation_low = gravitation.map(|c| c.lo);
    }

    fn correct(&mut self, correction: &Correction<R>) -> Result<(), Rejected> {
        self.corrected(correction)
    }

    #[inline(always)]
    fn check_place(&self) -> Result<(), Rejected> {
        check_earth_fixed(self.position.value())
    }

    #[inline]
    fn output(&self) -> EarthFixedSolution<R> {
        solution(self.position, self.velocity, self.attitude)
    }
}

/// The velocity relative to the Earth is v − ω × r.
#[inline]
fn solution<R: Real, S: Accumulate<Real = R>>(
    position: Vector<S>,
    velocity: Vector<S>,
    attitude: Quaternion<S>,
) -> EarthFixedSolution<R> {
    let position_e = position.map(S::pair);
    let v = velocity.map(S::pair);
    let plus_turning = |v: Pair<R>, r: Pair<R>| {
        let omega: Pair<R> = Pair::of(ROTATION_RATE);
        let (p, low) = two_product(omega.hi, r.hi);
        let (hi, rest) = two_sum(v.hi, p);
        Pair { hi, lo: rest + (low + (omega.lo * r.hi + omega.hi * r.lo) + v.lo) }
    };
    let velocity_e =
        Vector::new(plus_turning(v.x, position_e.y), plus_turning(v.y, -position_e.x), v.z);
    EarthFixedSolution { position_e, velocity_e, attitude: attitude.map(S::pair) }
}
