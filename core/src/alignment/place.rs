//! What gravity and the Earth's rate are where a unit stands still.
//!
//! ```
//! use schuler::alignment::place::Place;
//! use schuler::earth::Geodetic;
//!
//! let pole = core::f64::consts::FRAC_PI_2;
//! let place = Place::new(Geodetic { latitude: pole, longitude: 0.0, altitude: 0.0 });
//! assert!((place.gravity - 9.8321849).abs() < 1e-6);
//! assert!(place.rate_north.abs() < 1e-19);
//! ```

use crate::earth::{self, Geodetic};
use crate::math::real::Scalar;

/// The known quantities at the place of a unit at rest.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Place<R> {
    /// Where.
    pub position: Geodetic<R>,
    /// Normal gravity γ, m/s².
    pub gravity: R,
    /// Earth's rate along the upward vertical, ω_ie sinφ, rad/s.
    pub rate_up: R,
    /// Earth's rate across it, ω_ie cosφ, rad/s.
    pub rate_north: R,
}

impl<R: Scalar> Place<R> {
    /// At a position.
    pub fn new(position: Geodetic<R>) -> Self {
        let (sine, cosine) = position.latitude.sin_cos();
        let rotation = earth::rotation_ned(sine, cosine);
        Self {
            position,
            gravity: earth::gravity(sine, position.altitude),
            rate_up: -rotation.z,
            rate_north: rotation.x,
        }
    }

    /// The smallest gyro error that explains a rate along and across the vertical, rad/s.
    pub fn least_bias(&self, up: R, across: R) -> R {
        let (up, across) = (up - self.rate_up, across - self.rate_north);
        (up * up + across * across).sqrt()
    }
}
