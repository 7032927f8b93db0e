//! The solution inside a block, from the step across it.

use super::{LocalLevel, solution};
use crate::earth::{self, EQUATORIAL_GRAVITY, Geodetic};
use crate::math::compensated::Accumulate;
use crate::math::quaternion::Matrix;
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::solution::Solution;
use crate::strapdown::block::body::BodyMotion;
use crate::strapdown::frame::block_time::BlockTime;
use crate::strapdown::frame::displacement::{Net, displacement, turned_by};
use crate::strapdown::frame::meridian::{Meridian, PlaceChange};
use crate::strapdown::place::fold_longitude;

/// What rows inside a block need.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LocalLevelStep<R> {
    pub(super) matrix: Matrix<R>,
    pub(super) meridian: Meridian<R>,
    /// (δ + ∇)/2 and (δ − ∇)/2 of plumb gravity over the block.
    pub(super) slope: Vector<R>,
    pub(super) curvature: Vector<R>,
}

/// Adds a change of place.
#[inline(always)]
fn add_place<S: Accumulate>(position: &mut Geodetic<S>, change: &PlaceChange<S::Real>) {
    position.latitude.add(change.latitude);
    position.longitude.add(change.longitude);
    fold_longitude(&mut position.longitude);
    position.altitude.add(change.altitude);
}

impl<R: Real, S: Accumulate<Real = R>> LocalLevel<S> {
    /// The state at a fraction τ of the block; `self` is the state before it.
    #[inline(always)]
    pub(super) fn state_within(
        &self,
        step: &LocalLevelStep<R>,
        time: &BlockTime<R>,
        body: &BodyMotion<R>,
        fraction: R,
    ) -> Solution<R> {
        let (tau, tau2) = (fraction, fraction * fraction);
        let (b, c) = (step.slope, step.curvature);
        let g0 = R::of(EQUATORIAL_GRAVITY) + self.gravity_excess;
        let meridian = &step.meridian;
        let omega = earth::rotation_ned(meridian.sine, meridian.cosine);
        // net(τ) = C s + T²(τ²G̃₀/2 + τ³b/6 + τ⁴c/12)
        let mut fall = b * (tau * R::of(1.0 / 6.0)) + c * (tau2 * R::of(1.0 / 12.0));
        fall.z = fall.z + g0 * R::HALF;
        let once = step.matrix * body.position + fall * (time.square * tau2);
        let velocity = self.velocity.value();
        let t = time.time.hi * tau;
        // A row does not affect later steps, so ∫net for constant force is enough.
        let net = Net { once, twice: once * (t * R::of(1.0 / 3.0)) };
        let low = self.velocity.low_product(time.time, tau);
        let moved = displacement(velocity, &net, omega, t, low, false);
        let change = meridian.moved(moved.relative);
        let turn = meridian.frame_turn(&change, change.longitude + time.turn.hi * tau);
        let mut position = self.position;
        add_place(&mut position, &change);

        // v = v₀ + C u + T(τG̃₀ + τ²b/2 + τ³c/3) − Ω×d(τ), turned by q*
        let mut gained = b * (tau2 * R::HALF) + c * (tau2 * tau * R::of(1.0 / 3.0));
        gained.z = gained.z + g0 * tau;
        let rest = gained * time.time.hi - turned_by(omega, moved.inertial);
        let gained = step.matrix * body.velocity + rest;
        let back = turn.conjugate();
        let (mut v, mut attitude) = (self.velocity, self.attitude);
        v.accumulate(gained + back.turn_less_one(v.value() + gained));
        let q = attitude.value();
        let turned = q * body.rotation;
        attitude.accumulate(turned + back * (q + turned));
        solution(position, v, attitude)
    }
}
