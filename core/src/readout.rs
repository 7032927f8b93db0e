//! Navigation as plain numbers for display and logs, in degrees, metres and metres per second.

use crate::math::compensated::Pair;
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::solution::{Euler, Solution};

/// A [`Solution`] in the units that people read. Each number is rounded once to the digits of `R`.
///
/// In `f32` a longitude beyond 128° has steps of 1.5e-5°, or 1.7 m. The state has more digits than that. To see
/// them in `f64`, call [`Output::wide`](crate::output::Output::wide) before `readout`.
///
/// ```
/// use schuler::prelude::*;
///
/// let shown = Solution::new(
///     Geodetic { latitude: core::f64::consts::FRAC_PI_4, longitude: 0.5, altitude: 120.0 },
///     Vector::new(10.0, 0.0, -0.5),
///     Euler { roll: 0.0, pitch: 0.0, yaw: 0.5 },
/// )
/// .readout();
/// assert_eq!(shown.latitude_deg, 45.0);
/// assert_eq!(
///     shown.to_string(),
///     "45.0000000° 28.6478898° 120.000 m, \
///      10.0000 0.0000 -0.5000 m/s, 0.0000° 0.0000° 28.6479°"
/// );
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Readout<R> {
    /// Geodetic latitude, north positive, °.
    pub latitude_deg: R,
    /// Longitude, east positive, °.
    pub longitude_deg: R,
    /// Height above the ellipsoid, m.
    pub altitude_m: R,
    /// Velocity north, east and down relative to the Earth, m/s.
    pub velocity_ned_m_s: Vector<R>,
    /// Roll about forward, °.
    pub roll_deg: R,
    /// Pitch about right, °.
    pub pitch_deg: R,
    /// Yaw about down, from north, °.
    pub yaw_deg: R,
}

impl<R: Real> From<&Solution<R>> for Readout<R> {
    fn from(solution: &Solution<R>) -> Self {
        let degree = Pair::of(180.0) * Pair::of(core::f64::consts::PI).reciprocal();
        let degrees = |x: Pair<R>| whole(x * degree);
        let Euler { roll, pitch, yaw } = solution.euler();
        let [roll_deg, pitch_deg, yaw_deg] = [roll, pitch, yaw].map(|x| degrees(Pair::new(x)));
        Self {
            latitude_deg: degrees(solution.position.latitude),
            longitude_deg: degrees(solution.position.longitude),
            altitude_m: whole(solution.position.altitude),
            velocity_ned_m_s: solution.velocity_ned.map(whole),
            roll_deg,
            pitch_deg,
            yaw_deg,
        }
    }
}

/// Rounded once.
fn whole<R: Real>(x: Pair<R>) -> R {
    x.hi + x.lo
}

impl<R: core::fmt::Display> core::fmt::Display for Readout<R> {
    /// Latitude, longitude, height; north, east, down; roll, pitch, yaw. The last digits are a centimetre,
    /// 0.1 mm/s and 10⁻⁴ °, unless the format has a precision, which then applies to all numbers.
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let digits = |usual| f.precision().unwrap_or(usual);
        let (place, height, fine) = (digits(7), digits(3), digits(4));
        let Vector { x, y, z } = &self.velocity_ned_m_s;
        write!(f, "{:.place$}° {:.place$}° ", self.latitude_deg, self.longitude_deg)?;
        write!(f, "{:.height$} m, {x:.fine$} {y:.fine$} {z:.fine$} m/s, ", self.altitude_m)?;
        write!(f, "{:.fine$}° {:.fine$}° {:.fine$}°", self.roll_deg, self.pitch_deg, self.yaw_deg)
    }
}
