//! Which reversed axis, sign or latitude makes gyros and accelerometers at rest agree.
//!
//! ω·f/|f| = ω_ie sinφ at rest: a reversed axis changes the product, and a wrong latitude changes its
//! expected value.
//!
//! ```
//! use schuler::alignment::judge::{Contradiction, judge};
//! use schuler::alignment::place::Place;
//! use schuler::alignment::still::Still;
//! use schuler::alignment::units::Kind;
//! use schuler::earth::Geodetic;
//! use schuler::math::vector::Vector;
//! use schuler::sample::Increment;
//!
//! // At 45° north, level and heading north, with gyros whose third axis is reversed.
//! let place = Place::new(Geodetic { latitude: 0.7854, longitude: 0.1, altitude: 0.0 });
//! let mut still = Still::new(1.0_f64);
//! for _ in 0..30_000 {
//!     let angle_b = Vector::new(place.rate_north, 0.0, place.rate_up) * 0.01;
//!     let velocity_b = Vector::new(0.0, 0.0, -place.gravity) * 0.01;
//!     still.add(&Increment { angle_b, velocity_b }, 0.01);
//! }
//! let judgement = judge(&still.readings().unwrap(), Kind::Increments, &place);
//! let Some(Contradiction::Directions(signs)) = judgement.contradiction else { panic!() };
//! assert_eq!(signs.axis, [false, false, true]);
//! ```

use super::place::Place;
use crate::earth;
use crate::math::real::Scalar;
use crate::math::vector::Vector;

/// Possible explanations of directions that contradict each other.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Signs<R> {
    /// Specific force counted down instead of up, or the latitude of the other hemisphere.
    pub reversed: bool,
    /// Gyro or accelerometer of one axis reversed: x, y, z.
    pub axis: [bool; 3],
    /// Gyros in another order than accelerometers: x and y, y and z, z and x exchanged.
    pub exchanged: [bool; 3],
    /// Latitude and longitude exchanged.
    pub longitude: bool,
    /// A latitude in radians instead of degrees.
    pub radians: bool,
    /// The latitude that follows from ω and f, rad.
    pub latitude: R,
}

/// The explanations that reduce the error `off` to less than `fit` (rad/s); `None` if there is no such
/// explanation and no latitude follows from the directions.
pub(super) fn of<R: Scalar>(
    rate: Vector<R>,
    force: Vector<R>,
    place: &Place<R>,
    off: R,
    fit: R,
) -> Option<Signs<R>> {
    let norm = force.norm();
    if !norm.is_within(R::of(1e12)) || norm == R::ZERO {
        return None;
    }
    let square = rate.dot(rate);
    let across = |up: R| {
        let rest = square - up * up;
        if rest > R::ZERO { rest.sqrt() } else { R::ZERO }
    };
    let fits_at = |place: &Place<R>, up: R| {
        let left = place.least_bias(up, across(up));
        left < fit && left * R::of(3.0) < off
    };
    let fits = |up: R| fits_at(place, up);
    let up = rate.dot(force) / norm;
    let products = rate.zip(force, |w, f| w * f / norm).into_array();
    let Vector { x, y, z } = rate;
    let exchanged = [Vector::new(y, x, z), Vector::new(x, z, y), Vector::new(z, y, x)];
    let latitude = up.atan2(across(up));
    let at = |latitude: R| {
        let mut position = place.position;
        position.latitude = latitude;
        Place::new(position)
    };
    let stated = place.position;
    let quarter = R::of(core::f64::consts::FRAC_PI_2);
    let per_degree = R::of(180.0 / core::f64::consts::PI);
    let signs = Signs {
        reversed: fits(-up),
        axis: products.map(|product| fits(up - R::TWO * product)),
        exchanged: exchanged.map(|rate| fits(rate.dot(force) / norm)),
        longitude: stated.longitude.abs() <= quarter && fits_at(&at(stated.longitude), up),
        radians: stated.latitude.abs() * per_degree <= quarter
            && fits_at(&at(stated.latitude * per_degree), up),
        latitude,
    };
    let Signs { reversed, axis, exchanged, longitude, radians, .. } = signs;
    let rotation = R::of(earth::ROTATION_RATE);
    let is_earth = (square.sqrt() - rotation).abs() < fit;
    let any = reversed
        || longitude
        || radians
        || axis.into_iter().chain(exchanged).any(|explains| explains);
    (any || is_earth).then_some(signs)
}
