//! A correction of a local-level state.

use super::{LocalLevel, curvature};
use crate::math::compensated::Accumulate;
use crate::math::real::Real;
use crate::strapdown::correction::{Correction, local_level};
use crate::strapdown::frame::Frame;
use crate::strapdown::limits::Rejected;
use crate::strapdown::place::fold_longitude;

impl<R: Real, S: Accumulate<Real = R>> LocalLevel<S> {
    /// Adds a correction, and takes curvature and gravity anew.
    pub(super) fn corrected(&mut self, correction: &Correction<R>) -> Result<(), Rejected> {
        let meridian = self.meridian();
        let change = local_level(&meridian, self.velocity.value(), correction)?;
        let place = &change.place;
        self.position.latitude.add(place.latitude);
        self.position.longitude.add(place.longitude);
        fold_longitude(&mut self.position.longitude);
        self.position.altitude.add(-correction.position_ned.z);
        let (s, c) = (meridian.sine, meridian.cosine);
        self.sine.add(c * place.sine + s * place.cosine_less_one);
        self.cosine.add(c * place.cosine_less_one - s * place.sine);
        self.velocity.accumulate(change.velocity);
        let turned = change.attitude * self.attitude.value();
        self.attitude.accumulate(turned);
        self.attitude.keep_unit();
        self.curvature = curvature(self.sine.value());
        let excess = Self::excess(self.sine, self.position.altitude, self.curvature);
        self.gravity_excess = excess.hi;
        self.gravity_excess_low = excess.lo;
        self.check_place()
    }
}
