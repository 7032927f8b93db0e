//! The truth: motion as an analytic function of time.
//!
//! ```
//! use schuler::trajectory::{Jet, Motion};
//!
//! // 0.01 rad/s of latitude is about 64 km/s to the north.
//! let motion = Motion {
//!     latitude: Jet { value: 0.0_f64, first: 0.01, second: 0.0 },
//!     ..Motion::default()
//! };
//! assert!((motion.velocity_ned().x - 63354.0).abs() < 1.0);
//! ```

pub mod harmonic;

use crate::earth::{Geodetic, Radii};
use crate::math::compensated::Pair;
use crate::math::real::{Real, Scalar};
use crate::math::vector::Vector;
use crate::record::{Record, record};
use crate::solution::{Euler, Solution};

/// A function of time at one instant, with its first two derivatives.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Jet<R> {
    /// The value.
    pub value: R,
    /// Its first derivative, per second.
    pub first: R,
    /// Its second derivative, per second².
    pub second: R,
}

/// Attitude and position at one instant. Angles in rad, altitude in m.
///
/// A latitude may run past ±90°: the motion continues over the pole, north pointing away from it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Motion<R> {
    /// Roll γ.
    pub roll: Jet<R>,
    /// Pitch θ.
    pub pitch: Jet<R>,
    /// Yaw ψ.
    pub yaw: Jet<R>,
    /// Geodetic latitude φ.
    pub latitude: Jet<R>,
    /// Longitude λ.
    pub longitude: Jet<R>,
    /// Height above the ellipsoid h.
    pub altitude: Jet<R>,
}

impl<R: Record> Record for Jet<R> {
    record!(value, first, second;);
}

impl<R: Record> Record for Motion<R> {
    record!(roll, pitch, yaw, latitude, longitude, altitude);
}

/// Bounds of a motion, from which quadrature and windows are planned.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bound<R> {
    /// An angular frequency Λ, rad/s, such that the k-th derivative of every component of ω_ibᵇ and
    /// fᵇ stays within Λᵏ times that component's own range, or its size in a steady climb. 0 where
    /// nothing changes.
    pub bandwidth: R,
    /// |ω_ibᵇ| at most, rad/s.
    pub angular_rate: R,
}

/// A motion that can be evaluated at any time.
pub trait Trajectory<R: Real> {
    /// The motion at a time in seconds with its remainder; whole turns may be removed from an angle.
    fn at_instant(&self, time_s: Pair<R>) -> Motion<R>;
    /// The motion at a time in seconds.
    fn at(&self, time_s: R) -> Motion<R> {
        self.at_instant(Pair::new(time_s))
    }
    /// Its bounds, over all time.
    fn bound(&self) -> Bound<R>;
}

impl<R: Real> Motion<R> {
    /// Angular rate of the north-east-down axes relative to the Earth, in these axes, rad/s; from sine and
    /// cosine of the latitude.
    #[inline(always)]
    pub fn transport_rate(&self, sine: R, cosine: R) -> Vector<R> {
        // ω_enⁿ = (λ̇ cosφ, −φ̇, −λ̇ sinφ)
        let (latitude_rate, longitude_rate) = (self.latitude.first, self.longitude.first);
        Vector::new(longitude_rate * cosine, -latitude_rate, -(longitude_rate * sine))
    }

    /// Velocity relative to the Earth: north, east, down, m/s.
    pub fn velocity_ned(&self) -> Vector<R> {
        let (s, c) = self.latitude.value.sin_cos();
        let radii = Radii::at(s, c);
        let h = self.altitude.value;
        // v_N = (R_M + h)φ̇,  v_E = (R_N + h)cosφ·λ̇,  v_D = −ḣ
        Vector::new(
            (radii.meridian + h) * self.latitude.first,
            (radii.prime_vertical + h) * c * self.longitude.first,
            -self.altitude.first,
        )
    }
}

impl<R: Scalar> Motion<R> {
    /// The state that a perfect navigator would print, with the latitude within ±90°.
    pub fn solution(&self) -> Solution<R> {
        let (position, velocity_ned, attitude) = self.folded();
        Solution {
            position: position.map(Pair::new),
            velocity_ned: velocity_ned.map(Pair::new),
            attitude: attitude.quaternion().map(Pair::new),
        }
    }

    /// The same as a start, with the attitude to about twice the digits.
    pub fn initial(&self) -> Solution<R> {
        let (position, velocity_ned, attitude) = self.folded();
        Solution::new(position, velocity_ned, attitude)
    }

    /// With latitude within ±90°, longitude and angles within ±180°.
    fn folded(&self) -> (Geodetic<R>, Vector<R>, Euler<R>) {
        let pi = R::of(core::f64::consts::PI);
        let mut velocity_ned = self.velocity_ned();
        let mut position = Geodetic {
            latitude: wrap(self.latitude.value),
            longitude: self.longitude.value,
            altitude: self.altitude.value,
        };
        let mut yaw = self.yaw.value;
        if position.latitude.abs() > R::of(core::f64::consts::FRAC_PI_2) {
            // Beyond the pole the printed meridian is the opposite one, and north is reversed.
            let pole = if position.latitude > R::ZERO { pi } else { -pi };
            position.latitude = pole - position.latitude;
            position.longitude = position.longitude + pi;
            velocity_ned = Vector::new(-velocity_ned.x, -velocity_ned.y, velocity_ned.z);
            yaw = yaw + pi;
        }
        position.longitude = wrap(position.longitude);
        let attitude =
            Euler { roll: wrap(self.roll.value), pitch: wrap(self.pitch.value), yaw: wrap(yaw) };
        (position, velocity_ned, attitude)
    }
}

/// An angle wrapped to [−π, π]; unchanged if it is there already.
pub fn wrap<R: Scalar>(angle: R) -> R {
    let turn = R::of(core::f64::consts::TAU);
    if angle.abs() > R::of(core::f64::consts::PI) {
        angle - turn * (angle / turn).round()
    } else {
        angle
    }
}
