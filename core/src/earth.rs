//! The Earth: WGS-84 ellipsoid, rotation and normal gravity; geodetic and Earth-fixed positions.
//!
//! Earth-fixed axes: z along the axis of rotation, x through the meridian of Greenwich.
//! Source: NIMA TR8350.2 (WGS-84), equations 4-1 to 4-3; Groves, *Principles of GNSS, Inertial and
//! Multisensor Integrated Navigation Systems*, 2nd ed., §2.4.
//!
//! ```
//! use schuler::earth::{Geodetic, gravity};
//!
//! let at = Geodetic { latitude: 0.8_f64, longitude: 1.7, altitude: 3500.0 };
//! let back = Geodetic::from_earth_fixed(at.to_earth_fixed());
//! assert!((back.altitude - 3500.0).abs() < 1e-8);
//! assert!((gravity(0.0_f64, 0.0) - 9.7803253359).abs() < 1e-12);
//! ```

pub mod closed_form;
pub mod gradient;

use crate::math::real::Real;
use crate::math::vector::Vector;

/// Semi-major axis a, m.
pub const SEMI_MAJOR_AXIS: f64 = 6_378_137.0;
/// Flattening f.
pub const FLATTENING: f64 = 1.0 / 298.257223563;
/// Semi-minor axis b = a(1 − f), m.
pub const SEMI_MINOR_AXIS: f64 = SEMI_MAJOR_AXIS * (1.0 - FLATTENING);
/// First eccentricity squared, e² = f(2 − f).
pub const ECCENTRICITY_SQUARED: f64 = FLATTENING * (2.0 - FLATTENING);
/// Rate of rotation ω_ie, rad/s.
pub const ROTATION_RATE: f64 = 7.292115e-5;
/// Normal gravity at the equator γ_e, m/s².
pub const EQUATORIAL_GRAVITY: f64 = 9.7803253359;
/// Somigliana's constant k.
pub const SOMIGLIANA: f64 = 0.00193185265241;
/// Ratio of centrifugal to gravitational acceleration at the equator m.
pub const CENTRIFUGAL_RATIO: f64 = 0.00344978650684;

/// sin 84°: the true latitude beyond which meridians are not compared. It is the limit at which the universal
/// polar stereographic grid begins (NGA.SIG.0012, *The universal grids*).
///
/// Beyond it, the angle between the two meridians is an effect of the position error, not of attitude or
/// velocity, and at the pole it is undefined. So the computed north is then the true one, carried along the
/// shortest path from the true to the computed position. The truth alone decides which rule holds, so a drift
/// and its theoretical value always follow the same rule.
pub const POLAR_SINE: f64 = 0.994_521_895_368_273_3;

/// A point by its geodetic coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Geodetic<T> {
    /// Geodetic latitude φ, rad, north positive.
    pub latitude: T,
    /// Longitude λ, rad, east positive.
    pub longitude: T,
    /// Height above the ellipsoid h, m.
    pub altitude: T,
}

impl<T> Geodetic<T> {
    /// The same function of each coordinate.
    #[inline(always)]
    pub fn map<U>(self, mut f: impl FnMut(T) -> U) -> Geodetic<U> {
        Geodetic {
            latitude: f(self.latitude),
            longitude: f(self.longitude),
            altitude: f(self.altitude),
        }
    }
}

/// Principal radii of curvature at a latitude, and how fast they change along the meridian.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Radii<R> {
    /// Meridian radius R_M, m.
    pub meridian: R,
    /// Prime-vertical radius R_N, m.
    pub prime_vertical: R,
    /// dR_M/dφ, m/rad.
    pub meridian_slope: R,
    /// dR_N/dφ, m/rad.
    pub prime_vertical_slope: R,
}

impl<R: Real> Radii<R> {
    /// At the latitude of the given sine and cosine.
    #[inline(always)]
    pub fn at(sine: R, cosine: R) -> Self {
        // W² = 1 − e² sin²φ;  R_N = a/W;  R_M = a(1 − e²)/W³
        let e2 = R::of(ECCENTRICITY_SQUARED);
        let w2 = R::ONE - e2 * sine * sine;
        let prime_vertical = R::of(SEMI_MAJOR_AXIS) / w2.sqrt();
        let meridian = prime_vertical * R::of(1.0 - ECCENTRICITY_SQUARED) / w2;
        // dR_M/dφ = 3R_M e² sinφ cosφ/W²,  dR_N/dφ = R_N e² sinφ cosφ/W²
        let slope = e2 * sine * cosine / w2;
        Self {
            meridian,
            prime_vertical,
            meridian_slope: R::of(3.0) * meridian * slope,
            prime_vertical_slope: prime_vertical * slope,
        }
    }
}

/// Normal gravity γ at a latitude (its sine) and altitude, m/s², down along the ellipsoid's normal.
///
/// Exact on the ellipsoid; above it a series of second order in height, without the component to the north.
/// Its difference from the [closed form](closed_form), in µg (9.80665e-6 m/s²):
///
/// | altitude | down, 0° | down, 45° | down, 90° | north, 45° |
/// |---|---|---|---|---|
/// | 1 km | -0.010 | -0.005 | 0.000 | -0.830 |
/// | 10 km | -0.071 | -0.042 | -0.021 | -8.296 |
/// | 20 km | -0.128 | -0.128 | -0.147 | -16.57 |
/// | 50 km | -1.127 | -1.573 | -2.068 | -41.29 |
/// | 100 km | -10.96 | -13.31 | -15.77 | -82.10 |
/// | 300 km | -350.9 | -374.7 | -398.9 | -240.7 |
/// | 1000 km | -12437 | -12689 | -12943 | -741.8 |
///
/// The Earth's real field differs from normal gravity by tens of µg at the ground. Truth and navigation
/// use the same series, so a simulation does not show this error of a real flight.
#[inline(always)]
pub fn gravity<R: Real>(sine: R, altitude: R) -> R {
    // γ = γ_e(1 + k sin²φ)/√(1 − e² sin²φ) · [1 − (2/a)(1 + f + m − 2f sin²φ)h + 3h²/a²]
    let s2 = sine * sine;
    let w2 = R::ONE - R::of(ECCENTRICITY_SQUARED) * s2;
    R::of(EQUATORIAL_GRAVITY) * (R::ONE + R::of(SOMIGLIANA) * s2) / w2.sqrt()
        * (R::ONE + height_factor(s2, altitude))
}

/// The bracket of γ's dependence on height, less one.
#[inline(always)]
pub(crate) fn height_factor<R: Real>(sine_squared: R, altitude: R) -> R {
    // −(2/a)(1 + f + m − 2f sin²φ)h + 3h²/a²
    const A: f64 = SEMI_MAJOR_AXIS;
    altitude
        * (R::of(-2.0 / A * (1.0 + FLATTENING + CENTRIFUGAL_RATIO))
            + R::of(4.0 * FLATTENING / A) * sine_squared
            + R::of(3.0 / (A * A)) * altitude)
}

/// Earth's rate in north, east, down at a latitude, rad/s.
#[inline(always)]
pub fn rotation_ned<R: Real>(sine: R, cosine: R) -> Vector<R> {
    // ω_ieⁿ = ω_ie(cosφ, 0, −sinφ)
    let rate = R::of(ROTATION_RATE);
    Vector::new(rate * cosine, R::ZERO, -(rate * sine))
}

impl<R: Real> Geodetic<R> {
    /// The Earth-fixed position, m.
    pub fn to_earth_fixed(self) -> Vector<R> {
        let (s, c) = self.latitude.sin_cos();
        let (sl, cl) = self.longitude.sin_cos();
        let n = Radii::at(s, c).prime_vertical;
        let axis_distance = (n + self.altitude) * c;
        Vector::new(
            axis_distance * cl,
            axis_distance * sl,
            (n * R::of(1.0 - ECCENTRICITY_SQUARED) + self.altitude) * s,
        )
    }

    /// From an Earth-fixed position at least 300 km from the Earth's centre.
    pub fn from_earth_fixed(position_e: Vector<R>) -> Self {
        let Vector { x, y, z } = position_e;
        let e2 = R::of(ECCENTRICITY_SQUARED);
        let p = (x * x + y * y).sqrt();
        let mut latitude = z.atan2(p * (R::ONE - e2));
        let mut altitude = R::ZERO;
        // Newton's correction of the latitude; the height is stationary in it.
        for _ in 0..3 {
            let (s, c) = latitude.sin_cos();
            let radii = Radii::at(s, c);
            let n = radii.prime_vertical;
            // h = p cosφ + z sinφ − a√(1 − e² sin²φ)
            let w2 = R::ONE - e2 * s * s;
            altitude = p * c + z * s - n * w2;
            // Δφ = (z cosφ − p sinφ + e² N sinφ cosφ)/(R_M + h)
            latitude = latitude + (c * z - s * p + e2 * n * s * c) / (radii.meridian + altitude);
        }
        // At a pole rounding may exceed 90°.
        let most = R::of(core::f64::consts::FRAC_PI_2);
        latitude = R::select(most.less(latitude), most, latitude);
        latitude = R::select(latitude.less(-most), -most, latitude);
        Self { latitude, longitude: y.atan2(x), altitude }
    }
}
