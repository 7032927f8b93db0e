//! Rows of a log as the channels of a path.
//!
//! ```
//! use schuler::earth::Geodetic;
//! use schuler::solution::Euler;
//! use schuler::trajectory::log::rows;
//!
//! // A yaw from 170° to −170° is a turn by 20°, and the quaternions follow one another.
//! let place = Geodetic { latitude: 0.7, longitude: 0.1, altitude: 0.0 };
//! let yaw = |degrees: f64| Euler { roll: 0.0, pitch: 0.0, yaw: degrees.to_radians() };
//! let mut quaternions = [[0.0; 4]; 2];
//! rows::attitudes(&[place; 2], &[yaw(170.0), yaw(-170.0)], &mut quaternions)?;
//! let product: f64 = quaternions[0].iter().zip(quaternions[1]).map(|(a, b)| a * b).sum();
//! assert!((product - 10_f64.to_radians().cos()).abs() < 1e-15);
//! # Ok::<(), schuler::trajectory::log::LogError>(())
//! ```

use super::LogError;
use crate::earth::Geodetic;
use crate::math::quaternion::Quaternion;
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::solution::{Euler, ned_to_earth_fixed};
use crate::trajectory::spline::place::channels;
use core::f64::consts::FRAC_PI_2;

/// n̂ and h of places, angles in rad.
///
/// # Errors
///
/// [`LogError`] if the lengths differ, or with the first row that is not finite.
pub fn positions(places: &[Geodetic<f64>], out: &mut [[f64; 4]]) -> Result<(), LogError> {
    if out.len() != places.len() {
        return Err(LogError::Count { needed: places.len() });
    }
    for ((index, place), out) in places.iter().enumerate().zip(out) {
        *out = channels(*place);
        if !out.iter().all(|x| x.is_finite()) {
            return Err(LogError::NotFinite { index });
        }
    }
    Ok(())
}

/// Attitudes at places as quaternions body → Earth-fixed axes: w, x, y, z, each with the sign that is nearer to the
/// one before, since q and −q are the same rotation.
///
/// # Errors
///
/// [`LogError`] if the lengths differ, or with the first row that is not finite.
pub fn attitudes(
    places: &[Geodetic<f64>],
    attitudes: &[Euler<f64>],
    out: &mut [[f64; 4]],
) -> Result<(), LogError> {
    let needed = places.len();
    if out.len() != needed || attitudes.len() != needed {
        return Err(LogError::Count { needed });
    }
    let mut last = Quaternion::ZERO;
    let rows = places.iter().zip(attitudes).zip(out).enumerate();
    for (index, ((place, attitude), out)) in rows {
        let half = |angle: f64| Real::sin_cos(0.5 * angle);
        let to_earth = ned_to_earth_fixed(half(place.longitude), half(place.latitude + FRAC_PI_2));
        let q = to_earth * attitude.quaternion();
        let q = if q.dot(last) < 0.0 { q * -1.0 } else { q };
        if !q.dot(q).is_finite() {
            return Err(LogError::NotFinite { index });
        }
        let Quaternion { w, v: Vector { x, y, z } } = q;
        *out = [w, x, y, z];
        last = q;
    }
    Ok(())
}
