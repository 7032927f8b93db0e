//! Whether neighbours among way-points can be joined.
//!
//! ```
//! use schuler::earth::Geodetic;
//! use schuler::trajectory::waypoints::{fault::WaypointError, place::check_places};
//!
//! let at = Geodetic { latitude: 0.5, longitude: 0.0, altitude: 30.0 };
//! assert_eq!(check_places(&[at, at]), Err(WaypointError::Coincident { index: 1 }));
//! ```

use super::fault::WaypointError;
use crate::earth::Geodetic;
use crate::math::real::Real;
use crate::trajectory::spline::path::Path;
use crate::trajectory::spline::place::{
    LARGEST_ACCELERATION, LARGEST_SPEED, Pace, channels, distance,
};

/// Neighbours nearer than this, m, are the same place.
pub const LEAST_DISTANCE: f64 = 1e-3;
/// Cosine of the largest angle between neighbours, 179°.
const OPPOSITE: f64 = -0.999_847_7;

/// Checks that places are finite, and that neighbours are neither the same place nor opposite ones.
///
/// # Errors
///
/// [`WaypointError`] with the index of the first point at fault.
pub fn check_places(points: &[Geodetic<f64>]) -> Result<(), WaypointError> {
    if points.len() < 2 {
        return Err(WaypointError::TooFew);
    }
    for (index, at) in points.iter().enumerate() {
        if ![at.latitude, at.longitude, at.altitude].iter().all(|x| x.is_finite()) {
            return Err(WaypointError::NotFinite { index });
        }
    }
    for (two, index) in points.windows(2).zip(1..) {
        let [from, to] = two else { continue };
        let ([ax, ay, az, _], [bx, by, bz, _]) = (channels(*from), channels(*to));
        if ax * bx + ay * by + az * bz < OPPOSITE {
            return Err(WaypointError::Antipodal { index });
        }
        if distance(*from, *to) < LEAST_DISTANCE {
            return Err(WaypointError::Coincident { index });
        }
    }
    Ok(())
}

/// Checks the mean speed of each leg, straight from point to point; times must increase.
///
/// # Errors
///
/// [`WaypointError`] with the index of the point at the end of the leg.
pub fn check_speeds(points: &[Geodetic<f64>], times_s: &[f64]) -> Result<(), WaypointError> {
    let legs = points.windows(2).zip(times_s.windows(2));
    for ((places, times), index) in legs.zip(1..) {
        let ([from, to], [start, end]) = (places, times) else { continue };
        if !(start.is_finite() && end.is_finite()) {
            return Err(WaypointError::NotFinite { index });
        }
        if end <= start {
            return Err(WaypointError::NotIncreasing { index });
        }
        let speed_m_s = distance(*from, *to) / (end - start);
        if speed_m_s > LARGEST_SPEED {
            return Err(WaypointError::TooFast { index, speed_m_s });
        }
    }
    Ok(())
}

/// Checks speed and acceleration of a path at its joints and in the middle of its pieces.
///
/// # Errors
///
/// [`WaypointError`] with the index of the point at the end of the piece.
pub(super) fn check_path(path: &Path<'_>) -> Result<(), WaypointError> {
    for (piece, index) in (0..path.pieces()).filter_map(|k| path.piece(k)).zip(1..) {
        let Pace { speed_m_s, acceleration_m_s2 } = Pace::largest(&piece);
        if !speed_m_s.is_within(LARGEST_SPEED) {
            return Err(WaypointError::TooFast { index, speed_m_s });
        }
        if !acceleration_m_s2.is_within(LARGEST_ACCELERATION) {
            return Err(WaypointError::TooSharp { index, acceleration_m_s2 });
        }
    }
    Ok(())
}
