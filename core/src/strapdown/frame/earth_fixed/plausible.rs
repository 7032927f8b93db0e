//! Checks of an Earth-fixed state that was restored from bytes.

use super::EarthFixed;
use crate::earth::SEMI_MAJOR_AXIS;
use crate::math::compensated::Accumulate;
use crate::math::real::Real;
use crate::strapdown::limits::FARTHEST;
use crate::strapdown::place::check_earth_fixed;
use crate::strapdown::plausible::{
    MOST_GRAVITY_CHANGE, MOST_SPEED, Plausible, is_attitude, sum_within, sums_within,
};

impl<R: Real, S: Accumulate<Real = R>> Plausible for EarthFixed<S> {
    fn is_plausible(&self) -> bool {
        let position = self.position.value();
        let change = R::of(MOST_GRAVITY_CHANGE);
        let one = R::of(1.5);
        let in_range = sums_within(self.position, R::of(SEMI_MAJOR_AXIS + FARTHEST))
            & sums_within(self.velocity, R::of(MOST_SPEED))
            & sums_within(self.attitude.v, one)
            & sum_within(self.attitude.w, one)
            & self.history.is_within(change);
        in_range
            && check_earth_fixed(position).is_ok()
            && is_attitude(self.attitude.value())
            && self
                .latitude
                .belongs_to(position)
                .is_some_and(|gravitation| (gravitation - self.gravitation).is_within(R::of(1e-2)))
    }
}
