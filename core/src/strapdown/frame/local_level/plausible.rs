//! Checks of a local-level state that was restored from bytes.

use super::{LocalLevel, curvature, gravity_excess};
use crate::earth::Geodetic;
use crate::math::compensated::Accumulate;
use crate::math::real::Real;
use crate::strapdown::limits::FARTHEST;
use crate::strapdown::place::check_local;
use crate::strapdown::plausible::{
    MOST_GRAVITY_CHANGE, MOST_SPEED, Plausible, agree, is_attitude, sum_within, sums_within,
};
use core::f64::consts::{FRAC_PI_2, TAU};

impl<R: Real, S: Accumulate<Real = R>> Plausible for LocalLevel<S> {
    fn is_plausible(&self) -> bool {
        let Geodetic { latitude, longitude, altitude } = self.position;
        let (s, c) = (self.sine.value(), self.cosine.value());
        let high = altitude.value();
        let change = R::of(MOST_GRAVITY_CHANGE);
        let one = R::of(1.5);
        let in_range = sum_within(latitude, R::of(FRAC_PI_2))
            & sum_within(longitude, R::of(TAU))
            & sum_within(altitude, R::of(FARTHEST))
            & sum_within(self.sine, one)
            & sum_within(self.cosine, one)
            & sums_within(self.velocity, R::of(MOST_SPEED))
            & sums_within(self.attitude.v, one)
            & sum_within(self.attitude.w, one)
            & self.longitude_rest.is_within(R::of(1e-3))
            & self.history.is_within(change);
        if !in_range || check_local(c, high).is_err() || !is_attitude(self.attitude.value()) {
            return false;
        }
        // As a pair: libm's functions of single precision compute in double.
        let (sine, cosine) = latitude.pair().sin_cos();
        let carried = R::entry(1e-2, 1e-6);
        agree(s, sine.hi, carried)
            & agree(c, cosine.hi, carried)
            & agree(self.curvature, curvature(s), R::entry(1e-4, 1e-8))
            & agree(
                self.gravity_excess,
                gravity_excess(s, high, self.curvature),
                R::entry(1e-3, 1e-6),
            )
    }
}
