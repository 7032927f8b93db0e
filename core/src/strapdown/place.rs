//! Places at which navigation can continue, and longitudes beyond ±180°.

use crate::earth::{SEMI_MAJOR_AXIS, SEMI_MINOR_AXIS};
use crate::math::compensated::{Accumulate, Pair};
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::strapdown::limits::{FARTHEST, Rejected};

/// cosφ below which north and east are not well defined: 640 m from a pole.
const POLAR_COSINE: f64 = 1e-4;

/// Whether local-level navigation can continue at a place.
#[inline(always)]
pub(crate) fn check_local<R: Real>(cosine: R, altitude: R) -> Result<(), Rejected> {
    if !altitude.is_within(R::of(FARTHEST)) {
        Err(Rejected::Place)
    } else if R::any(cosine.less(R::of(POLAR_COSINE))) {
        Err(Rejected::Pole)
    } else {
        Ok(())
    }
}

/// Wraps a longitude of at most ±3π to ±180°, with twice the digits of 2π; within ±180° it is unchanged, to
/// the last bit.
#[inline(always)]
pub(crate) fn fold_longitude<S: Accumulate>(longitude: &mut S) {
    const TURN: f64 = core::f64::consts::TAU;
    let rest = S::Real::entry(-1.748_455_6e-7, 2.449_293_598_294_706_4e-16);
    let at = longitude.value();
    let outside = S::Real::of(0.5 * TURN).less(at.abs());
    if S::Real::any(outside) {
        let west = at.less(S::Real::ZERO);
        let back = |x: S::Real| S::Real::select(west, x, -x);
        let mut folded = *longitude;
        folded.add_pair(Pair { hi: back(S::Real::of(TURN)), lo: back(rest) });
        *longitude = S::select(outside, folded, *longitude);
    }
}

/// Whether Earth-fixed navigation can continue at a place: in the shell between the spheres
/// [`FARTHEST`] below the poles and above the equator.
#[inline(always)]
pub(crate) fn check_earth_fixed<R: Real>(position_e: Vector<R>) -> Result<(), Rejected> {
    const LEAST: f64 = SEMI_MINOR_AXIS - FARTHEST;
    const MOST: f64 = SEMI_MAJOR_AXIS + FARTHEST;
    const MEAN: f64 = 0.5 * (MOST * MOST + LEAST * LEAST);
    const HALF_RANGE: f64 = 0.5 * (MOST * MOST - LEAST * LEAST);
    let from_mean = position_e.dot(position_e) - R::of(MEAN);
    if from_mean.is_within(R::of(HALF_RANGE)) { Ok(()) } else { Err(Rejected::Place) }
}
