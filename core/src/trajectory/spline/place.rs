//! Places as the four channels of a path, n̂ and h, and how fast a piece moves.
//!
//! n̂ = (cosφ cosλ, cosφ sinλ, sinφ) has no antimeridian and no pole.
//! Source: Gade, A non-singular horizontal position representation, *Journal of Navigation* 63 (2010) 395–417.
//!
//! ```
//! use schuler::earth::Geodetic;
//! use schuler::trajectory::spline::place::channels;
//!
//! let at = Geodetic { latitude: 0.5, longitude: 0.0, altitude: 30.0 };
//! assert_eq!(channels(at), [0.5_f64.cos(), 0.0, 0.5_f64.sin(), 30.0]);
//! ```

use super::TERMS;
use crate::earth::Geodetic;
use crate::math::compensated::Pair;
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::trajectory::piecewise::piece::{Half, Piece};
use crate::trajectory::piecewise::place::Place;

/// The largest speed, m/s, that a path may have or imply.
pub const LARGEST_SPEED: f64 = 1e5;
/// The largest acceleration, m/s², that a path may have.
pub const LARGEST_ACCELERATION: f64 = 1e5;

/// n̂ and h of a place, angles in rad.
pub fn channels(at: Geodetic<f64>) -> [f64; 4] {
    let (s, c) = Real::sin_cos(at.latitude);
    let (sl, cl) = Real::sin_cos(at.longitude);
    [c * cl, c * sl, s, at.altitude]
}

/// The straight distance between two places, m.
pub fn distance(from: Geodetic<f64>, to: Geodetic<f64>) -> f64 {
    (to.to_earth_fixed() - from.to_earth_fixed()).norm()
}

/// What a piece reaches.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Pace {
    /// Speed over the Earth, m/s.
    pub speed_m_s: f64,
    /// Acceleration over the Earth, m/s².
    pub acceleration_m_s2: f64,
}

impl Pace {
    /// Whether either is larger than a path may have, or not a number, as where a path leads through the Earth's
    /// centre.
    pub fn is_too_large(&self) -> bool {
        !(self.speed_m_s.is_within(LARGEST_SPEED)
            && self.acceleration_m_s2.is_within(LARGEST_ACCELERATION))
    }

    /// Of a piece, the largest of its ends and its middle.
    pub fn largest(piece: &Piece<TERMS>) -> Self {
        let times = [piece.start_s, piece.middle_s, piece.end_s];
        times.iter().fold(Self::default(), |most, &time_s| {
            let here = Self::at(piece, time_s);
            // Not a number stays.
            let more = |a: f64, b: f64| if a > b { a } else { b };
            Self {
                speed_m_s: more(most.speed_m_s, here.speed_m_s),
                acceleration_m_s2: more(most.acceleration_m_s2, here.acceleration_m_s2),
            }
        })
    }

    /// Of a piece at a time, s.
    pub fn at(piece: &Piece<TERMS>, time_s: f64) -> Self {
        let [x, y, z, h] = piece.series::<3>(Half::Position, Pair::new(time_s));
        let position = Place::new(Vector::new(x, y, z), h).position;
        Self {
            speed_m_s: position.map(|r| r.coefficient(1)).norm(),
            acceleration_m_s2: 2.0 * position.map(|r| r.coefficient(2)).norm(),
        }
    }
}
