//! The increments of a local-level state from a correction. Only increments are computed, so that single
//! precision loses nothing.

use super::{Correction, turn};
use crate::math::quaternion::Quaternion;
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::strapdown::frame::meridian::{Meridian, PlaceChange};
use crate::strapdown::limits::Rejected;

/// The least distance of the place from the Earth's axis, in units of the correction's length. It bounds the
/// error of the truncated series of the longitude.
const LEAST_DISTANCE: f64 = 64.0;

/// The increments of a local-level state from a correction.
pub(crate) struct LocalLevelChange<R> {
    /// Of the place.
    pub place: PlaceChange<R>,
    /// Of the velocity, m/s.
    pub velocity: Vector<R>,
    /// Of the attitude: a factor from the left, less one.
    pub attitude: Quaternion<R>,
}

/// From a place and the velocity there.
#[inline(never)]
pub(crate) fn local_level<R: Real>(
    meridian: &Meridian<R>,
    velocity: Vector<R>,
    correction: &Correction<R>,
) -> Result<LocalLevelChange<R>, Rejected> {
    let Vector { x: north, y: east, z: lost } = correction.position_ned;
    let distance = meridian.axis_distance();
    let along = (north * north + east * east).sqrt() * R::of(LEAST_DISTANCE);
    if R::any(distance.less(along)) {
        return Err(Rejected::Pole);
    }
    // The chord's third component, whose height is lost: each pass leaves some (|D|/R)² of what is missing.
    let mut down = lost;
    for _ in 0..2 {
        let place = meridian.moved(Vector::new(north, east, down));
        down = down + (lost + place.altitude);
    }
    let place = meridian.moved(Vector::new(north, east, down));

    let (s, c) = (meridian.sine, meridian.cosine);
    let s1 = s + (c * place.sine + s * place.cosine_less_one);
    let c1 = c + (c * place.cosine_less_one - s * place.sine);
    // tan ½Δλ = D_E/(x + √(x² + D_E²)),  x = (R_N + h)c − D_N s − D_D c
    let x = distance - north * s - down * c;
    let half_longitude = east / (x + (x * x + east * east).sqrt());
    let to_meridian = turn::to_meridian(half_longitude, (s, c), (s1, c1));
    let wanted = velocity + correction.velocity_ned;
    Ok(LocalLevelChange {
        place,
        velocity: correction.velocity_ned + to_meridian.turn_less_one(wanted),
        attitude: turn::after(to_meridian, turn::rotation(correction.attitude_ned)),
    })
}
