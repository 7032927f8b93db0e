//! The navigation step in north, east and down at the vehicle, the frame of the paper.
//!
//! Within a block the axes n0 stand still in inertial space as they were at its start, and velocity is
//! relative to the Earth; at the end the frame turns to the new place. No number of the state is as large as the
//! Earth's radius, so this is the frame for single precision. Near a pole use the Earth-fixed frame.

mod correct;
mod plausible;
mod seed;
mod stored;
mod within;

pub use within::LocalLevelStep;

use super::block_time::BlockTime;
use super::displacement::{Net, displacement, turned_by};
use super::gravity_history::GravityHistory;
use super::meridian::{Meridian, curvature};
use super::two_float::{self, Attitude, Place};
use crate::earth::{self, EQUATORIAL_GRAVITY, Geodetic, ROTATION_RATE, SOMIGLIANA, height_factor};
use crate::math::compensated::{Accumulate, Pair, two_sum};
use crate::math::quaternion::Quaternion;
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::solution::Solution;
use crate::strapdown::block::body::BodyMotion;
use crate::strapdown::correction::Correction;
use crate::strapdown::frame::Frame;
use crate::strapdown::limits::Rejected;
use crate::strapdown::place::{check_local, fold_longitude};

/// State in local-level axes, summed by `S`.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LocalLevel<S: Accumulate> {
    position: Geodetic<S>,
    /// sinφ and cosφ, carried with the same increments as φ.
    sine: S,
    cosine: S,
    /// North, east, down, relative to the Earth, m/s.
    velocity: Vector<S>,
    /// Body → north, east, down.
    attitude: Quaternion<S>,
    /// 1/W − 1 at the latitude.
    curvature: S::Real,
    /// γ − γ_e here, m/s².
    gravity_excess: S::Real,
    /// Its remainder; 0 without two-float products.
    gravity_excess_low: S::Real,
    /// The remainder of Δλ + ωT; 0 without two-float products.
    longitude_rest: S::Real,
    /// Of plumb gravity, in the present axes.
    history: GravityHistory<S::Real>,
}

/// γ − γ_e at a latitude and altitude, without cancellation; `curvature` is 1/W − 1.
#[inline(always)]
fn gravity_excess<R: Real>(sine: R, altitude: R, curvature: R) -> R {
    // γ/γ_e = (1 + A)(1 + B), 1 + A = (1 + k s²)/W
    let s2 = sine * sine;
    let somigliana = R::of(SOMIGLIANA) * s2;
    let a = somigliana + (R::ONE + somigliana) * curvature;
    let b = height_factor(s2, altitude);
    R::of(EQUATORIAL_GRAVITY) * (a + (b + a * b))
}

impl<R: Real, S: Accumulate<Real = R>> LocalLevel<S> {
    #[inline(always)]
    fn meridian(&self) -> Meridian<R> {
        Meridian::at(
            self.sine.value(),
            self.cosine.value(),
            self.position.altitude.value(),
            self.curvature,
        )
    }

    /// γ − γ_e with its remainder, as far as it is known.
    #[inline(always)]
    fn excess(sine: S, altitude: S, curvature: R) -> Pair<R> {
        if S::TWO_FLOAT {
            two_float::gravity_excess(sine.pair(), altitude.pair())
        } else {
            Pair::new(gravity_excess(sine.value(), altitude.value(), curvature))
        }
    }

    /// δ: plumb gravity at the new place less that at the old one, in n0.
    #[inline(always)]
    fn plumb_change(&self, excess: Pair<R>, turn: Quaternion<R>) -> Vector<R> {
        // δ = (dγ₁ − dγ₀)ẑ + γ₁(C − I)ẑ
        let tilt = turn.turn_less_one(Vector::new(R::ZERO, R::ZERO, R::ONE));
        let mut delta = tilt * (R::of(EQUATORIAL_GRAVITY) + excess.hi);
        let grown = excess.hi - self.gravity_excess;
        delta.z = delta.z
            + if S::TWO_FLOAT { grown + (excess.lo - self.gravity_excess_low) } else { grown };
        delta
    }
}

impl<R: Real, S: Accumulate<Real = R>> Frame for LocalLevel<S> {
    type Real = R;
    type Output = Solution<R>;
    type Step = LocalLevelStep<R>;
    const TWO_FLOAT: bool = S::TWO_FLOAT;

    fn start(initial: &Solution<R>) -> Self {
        let (sine, cosine) = initial.position.latitude.sin_cos();
        let curvature = curvature(sine.hi);
        let altitude = S::from_pair(initial.position.altitude);
        let excess = Self::excess(S::from_pair(sine), altitude, curvature);
        let mut position = initial.position.map(S::from_pair);
        fold_longitude(&mut position.longitude);
        Self {
            position,
            sine: S::from_pair(sine),
            cosine: S::from_pair(cosine),
            velocity: initial.velocity_ned.map(S::from_pair),
            attitude: initial.attitude.map(S::from_pair),
            curvature,
            gravity_excess: excess.hi,
            gravity_excess_low: excess.lo,
            longitude_rest: R::ZERO,
            history: GravityHistory::NONE,
        }
    }

    fn seed(&mut self, time: &BlockTime<R>, body: &BodyMotion<R>) {
        self.seed_gravity(time, body);
    }

    fn stretch(&mut self, factor: R) {
        self.history.stretch(factor);
    }

    #[inline(always)]
    fn step(&mut self, time: &BlockTime<R>, body: &BodyMotion<R>) -> LocalLevelStep<R> {
        let t = time.time.hi;
        let q = self.attitude.value();
        let matrix = q.matrix(R::ONE);
        let velocity = self.velocity.value();
        let meridian = self.meridian();
        let omega = earth::rotation_ned(meridian.sine, meridian.cosine);

        // net = C s + T²(½G̃₀ + ⅙∇ + …)
        let mut fall = self.history.twofold();
        fall.z = fall.z + self.gravity_excess * R::HALF;
        let mut once = matrix * body.position + fall * time.square;
        once.z = once.z + time.half_gravity_square.hi + time.half_gravity_square.lo;
        // ∫net = C∫s + T³(⅙G̃₀ + ¹⁄₂₄∇)
        let mut fall = self.history.difference * R::of(1.0 / 24.0);
        fall.z = fall.z + (R::of(EQUATORIAL_GRAVITY) + self.gravity_excess) * R::of(1.0 / 6.0);
        let twice = matrix * body.position_integral + fall * (time.square * t);
        let low = self.velocity.low_product(time.time, R::ONE);
        let net = Net { once, twice };
        let moved = displacement(velocity, &net, omega, t, low, S::TWO_FLOAT);
        let change = meridian.moved(moved.relative);
        let start = Place {
            sine: self.sine.pair(),
            cosine: self.cosine.pair(),
            altitude: self.position.altitude.pair(),
        };
        let (moved_to, inertial_longitude) = if S::TWO_FLOAT {
            let precise = start.change(&change, moved.relative, moved.relative_low);
            let (sum, rest) =
                two_float::inertial_longitude(precise.longitude, time.turn, self.longitude_rest);
            self.longitude_rest = rest;
            (precise, sum)
        } else {
            (change.whole(), change.longitude + time.turn.hi)
        };
        let turn = meridian.frame_turn(&change, inertial_longitude);

        self.position.latitude.add_pair(moved_to.latitude);
        self.position.longitude.add_pair(moved_to.longitude);
        fold_longitude(&mut self.position.longitude);
        self.position.altitude.add_pair(moved_to.altitude);
        let (s, c) = (meridian.sine, meridian.cosine);
        self.sine.add(c * change.sine + s * change.cosine_less_one);
        self.cosine.add(c * change.cosine_less_one - s * change.sine);
        self.curvature = curvature(self.sine.value());
        let excess = Self::excess(self.sine, self.position.altitude, self.curvature);
        // Δw = C u + T(G̃₀ + ½δ − …) − Ω×d
        let delta = self.plumb_change(excess, turn);
        let (slope, curvature) = self.history.parabola(delta);
        let mut mean = self.history.advance(delta);
        let before = Pair { hi: self.gravity_excess, lo: self.gravity_excess_low };
        if !S::TWO_FLOAT {
            mean.z = mean.z + before.hi;
        }
        let drag = turned_by(omega, moved.inertial);
        let rest = mean * t - drag;
        let attitude = Attitude::of(self.attitude.pair());
        if S::TWO_FLOAT {
            let mut gained = attitude.rotated(body);
            gained.z = gained.z + time.gravity + before * time.time;
            self.velocity.accumulate_pair(gained);
            // The rounding of ω_ie in Ω.
            let omega_low = R::residual(ROTATION_RATE) / R::of(ROTATION_RATE);
            self.velocity.accumulate(rest - drag * omega_low);
        } else {
            let gained = matrix * body.velocity;
            let (fallen, low) = two_sum(gained.z, time.gravity.hi);
            self.velocity.x.add(gained.x + rest.x);
            self.velocity.y.add(gained.y + rest.y);
            self.velocity.z.add(fallen);
            self.velocity.z.add(rest.z + (low + time.gravity.lo));
        }
        self.gravity_excess = excess.hi;
        self.gravity_excess_low = excess.lo;

        // Into the axes at the end: v ← q* v, q_b ← q* ⊗ q_b ⊗ q_bb
        let back = turn.conjugate();
        let dv = back.turn_less_one(self.velocity.value());
        self.velocity.accumulate(dv);
        if S::TWO_FLOAT {
            let turn = start.frame_turn(turn, moved_to.latitude, inertial_longitude);
            // The effect of the rounding of the frame's rotation on its product with the velocity: 2 v × m.
            let low = turn.v.zip(back.v, |exact, back| (exact.hi + back) + exact.lo);
            let drift = self.velocity.value().cross(low);
            self.velocity.accumulate(drift + drift);
            let (body_turn, frame_turn) = attitude.turned(body, turn);
            self.attitude.accumulate_pair(body_turn);
            self.attitude.accumulate_pair(frame_turn);
        } else {
            let turned = q * body.rotation;
            self.attitude.accumulate(turned + back * (q + turned));
        }
        self.attitude.keep_unit();
        let history = &mut self.history;
        history.difference = history.difference + back.turn_less_one(history.difference);
        history.second_difference =
            history.second_difference + back.turn_less_one(history.second_difference);
        // To first order: without it, a level ∇³ would leave a vertical component, always with the same sign.
        let tilt = back.v.cross(history.third_difference);
        history.third_difference = history.third_difference + (tilt + tilt);
        LocalLevelStep { matrix, meridian, slope, curvature }
    }

    #[inline]
    fn within(
        &self,
        step: &LocalLevelStep<R>,
        time: &BlockTime<R>,
        body: &BodyMotion<R>,
        fraction: R,
    ) -> Solution<R> {
        self.state_within(step, time, body, fraction)
    }

    fn hold_vertical(&mut self, altitude: R, down: R) {
        self.position.altitude = S::from_pair(Pair::new(altitude));
        self.velocity.z = S::from_pair(Pair::new(down));
        let excess = Self::excess(self.sine, self.position.altitude, self.curvature);
        self.gravity_excess = excess.hi;
        self.gravity_excess_low = excess.lo;
    }

    fn correct(&mut self, correction: &Correction<R>) -> Result<(), Rejected> {
        self.corrected(correction)
    }

    #[inline(always)]
    fn check_place(&self) -> Result<(), Rejected> {
        check_local(self.cosine.value(), self.position.altitude.value())
    }

    #[inline]
    fn output(&self) -> Solution<R> {
        solution(self.position, self.velocity, self.attitude)
    }
}

#[inline]
fn solution<R: Real, S: Accumulate<Real = R>>(
    position: Geodetic<S>,
    velocity: Vector<S>,
    attitude: Quaternion<S>,
) -> Solution<R> {
    Solution {
        position: position.map(S::pair),
        velocity_ned: velocity.map(S::pair),
        attitude: attitude.map(S::pair),
    }
}
