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
use crate::earth::{Geodetic, SEMI_MAJOR_AXIS};
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::trajectory::piecewise::piece::Piece;

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

/// What a piece reaches: for a check, on a sphere.
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
        let u = time_s - piece.middle_s;
        // Value and two derivatives by Horner's rule.
        let mut jets = [[0.0; 3]; 4];
        for row in piece.coefficients.iter().rev() {
            for (jet, c) in jets.iter_mut().zip(row) {
                let [value, first, second] = *jet;
                *jet = [value * u + c, first * u + value, second * u + 2.0 * first];
            }
        }
        let [x, y, z, [h, climb, lift]] = jets;
        let part = |k: usize| {
            let of = |jet: [f64; 3]| jet.get(k).copied().unwrap_or(0.0);
            Vector::new(of(x), of(y), of(z))
        };
        let (m, first, second) = (part(0), part(1), part(2));
        // n̂ = m/|m|;  n̂' = (m' − n̂(n̂·m'))/|m|, and the same share of m″, less 2(n̂·m')n̂'/|m|
        let scale = 1.0 / m.norm();
        let normal = m * scale;
        let across = |v: Vector<f64>| (v - normal * normal.dot(v)) * scale;
        let turn = across(first);
        let bend = across(second) - turn * (2.0 * scale * normal.dot(first));
        let radius = SEMI_MAJOR_AXIS + h;
        let level = turn * radius;
        let speed = Real::sqrt(level.dot(level) + climb * climb);
        let along = bend * radius + turn * (2.0 * climb);
        let up = lift - radius * turn.dot(turn);
        let acceleration = Real::sqrt(along.dot(along) + up * up);
        Self { speed_m_s: speed, acceleration_m_s2: acceleration }
    }
}
