//! Plumb gravity before the first block, at the places where the vehicle must have been.

use super::LocalLevel;
use crate::earth::{self, EQUATORIAL_GRAVITY, ROTATION_RATE};
use crate::math::compensated::{Accumulate, Pair};
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::strapdown::block::body::BodyMotion;
use crate::strapdown::frame::beginning::Beginning;
use crate::strapdown::frame::block_time::BlockTime;
use crate::strapdown::frame::displacement::{Net, displacement};
use crate::strapdown::frame::gravity_history::GravityHistory;
use crate::strapdown::frame::meridian::curvature;

impl<R: Real, S: Accumulate<Real = R>> LocalLevel<S> {
    /// Sets up ∇ to ∇⁴ as if the block had been flown before, backwards.
    #[inline(never)]
    pub(super) fn seed_gravity(&mut self, time: &BlockTime<R>, body: &BodyMotion<R>) {
        // For k = 1, 2, 3, 4: t = −kT, net = ½t²(a + G̃₀) + ⅙t³(ȧ + ∇/T) + ¹⁄₂₄t⁴ä, then place and frame at t.
        let matrix = self.attitude.value().matrix(R::ONE);
        let force = Beginning::of(&matrix, body, time.time.hi);
        let mut acceleration = force.value;
        acceleration.z = acceleration.z + (R::of(EQUATORIAL_GRAVITY) + self.gravity_excess);
        let meridian = self.meridian();
        let omega = earth::rotation_ned(meridian.sine, meridian.cosine);
        self.history = GravityHistory::NONE;
        for _ in 0..2 {
            let jerk = force.rate + self.history.difference * (R::ONE / time.time.hi);
            let back = |t: R| {
                let net = Net::of_parabola(acceleration, jerk, force.rate_growth, t);
                let v = self.velocity.value();
                let moved = displacement(v, &net, omega, t, Vector::ZERO, false);
                let change = meridian.moved(moved.relative);
                let turn =
                    meridian.frame_turn(&change, change.longitude + R::of(ROTATION_RATE) * t);
                let risen = meridian.sine * change.cosine_less_one + meridian.cosine * change.sine;
                let sine = moved_by(self.sine, risen);
                let altitude = moved_by(self.position.altitude, change.altitude);
                let excess = Self::excess(sine, altitude, curvature(sine.value()));
                self.plumb_change(excess, turn)
            };
            // Relative to G̃₀.
            self.history =
                GravityHistory::of([1, 2, 3, 4].map(|k| back(-(R::count(k) * time.time.hi))));
        }
    }
}

/// A sum after an increment, to the digits with which gravity is computed.
#[inline(always)]
fn moved_by<S: Accumulate>(sum: S, by: S::Real) -> S {
    if S::TWO_FLOAT {
        let mut sum = sum;
        sum.add(by);
        sum
    } else {
        S::from_pair(Pair::new(sum.value() + by))
    }
}
