//! Plumb gravity before the first block, from where the vehicle must have been.

use super::super::block_time::BlockTime;
use super::super::body::BodyMotion;
use super::super::displacement::displacement;
use super::super::frame::Beginning;
use super::super::meridian::curvature;
use super::{LocalLevel, gravity_excess};
use crate::earth::{self, EQUATORIAL_GRAVITY, ROTATION_RATE};
use crate::math::compensated::Accumulate;
use crate::math::real::Real;
use crate::math::vector::Vector;

impl<R: Real, S: Accumulate<Real = R>> LocalLevel<S> {
    /// Sets up ∇, ∇² and ∇³ as if the block had been flown before, backwards.
    #[inline(never)]
    pub(super) fn seed_gravity(&mut self, time: &BlockTime<R>, body: &BodyMotion<R>) {
        // For k = 1, 2, 3: t = −kT, net = ½t²(a + G̃₀) + ⅙t³(ȧ + ∇/T), then place and frame at t.
        let matrix = self.attitude.value().matrix(R::ONE);
        let force = Beginning::of(matrix * body.velocity, matrix * body.position, time.time.hi);
        let mut acceleration = force.value;
        acceleration.z = acceleration.z + (R::of(EQUATORIAL_GRAVITY) + self.gravity_excess);
        let meridian = self.meridian();
        let omega = earth::rotation_ned(meridian.sine, meridian.cosine);
        self.difference = Vector::ZERO;
        for _ in 0..2 {
            let jerk = force.rate + self.difference * (R::ONE / time.time.hi);
            let back = |t: R| {
                let net = (acceleration * R::HALF + jerk * (t * R::of(1.0 / 6.0))) * (t * t);
                let v = self.velocity.value();
                let moved = displacement(v, net, omega, t, Vector::ZERO, false);
                let change = meridian.moved(moved.relative);
                let turn =
                    meridian.frame_turn(&change, change.longitude + R::of(ROTATION_RATE) * t);
                let sine = meridian.sine
                    + (meridian.sine * change.cosine_less_one + meridian.cosine * change.sine);
                let altitude = self.position.altitude.value() + change.altitude;
                self.plumb_change(gravity_excess(sine, altitude, curvature(sine)), turn)
            };
            // From G̃₀, which is the zero here.
            let (g1, g2) = (back(-time.time.hi), back(-(R::TWO * time.time.hi)));
            let g3 = back(-(R::of(3.0) * time.time.hi));
            let (nabla, before) = (-g1, (g1 - g2) - (g2 - g3));
            self.difference = nabla;
            self.second_difference = nabla - (g1 - g2);
            self.third_difference = self.second_difference - before;
        }
    }
}
