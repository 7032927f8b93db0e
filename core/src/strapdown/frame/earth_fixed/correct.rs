//! A correction of an Earth-fixed state.

use super::{EarthFixed, gravitation};
use crate::earth::ROTATION_RATE;
use crate::math::compensated::Accumulate;
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::strapdown::correction::{Correction, earth_fixed};
use crate::strapdown::frame::Frame;
use crate::strapdown::frame::gravitation::Latitude;
use crate::strapdown::limits::Rejected;

impl<R: Real, S: Accumulate<Real = R>> EarthFixed<S> {
    /// Adds a correction, and takes gravitation anew.
    pub(super) fn corrected(&mut self, correction: &Correction<R>) -> Result<(), Rejected> {
        let omega = Vector::new(R::ZERO, R::ZERO, R::of(ROTATION_RATE));
        let velocity_e = self.velocity.value() - omega.cross(self.position.value());
        let position_e = self.position.pair();
        let change = earth_fixed(&self.latitude, position_e, velocity_e, correction);
        self.position.accumulate_pair(change.position);
        let carried = omega.cross(change.position.map(|x| x.hi));
        self.velocity.accumulate(change.velocity + carried);
        let turned = change.attitude * self.attitude.value();
        self.attitude.accumulate(turned);
        self.attitude.keep_unit();
        self.latitude = change.latitude;
        let mut latitude = Latitude { change: R::ZERO, ..change.latitude };
        let gravitation = gravitation::<R, S>(&mut latitude, self.position.pair());
        self.gravitation = gravitation.map(|c| c.hi);
        self.gravitation_low = gravitation.map(|c| c.lo);
        self.check_place()
    }
}
