//! Attitude and position at one instant, with their derivatives.
//!
//! ```
//! use schuler::trajectory::{Jet, Motion};
//!
//! let still = Motion { altitude: Jet { value: 100.0_f64, ..Jet::default() }, ..Motion::default() };
//! // At rest level on the equator a sensor reads gravity upwards, and the Earth's rate.
//! let rates = still.rates();
//! assert!((rates.specific_force_b.z + 9.78).abs() < 1e-3);
//! assert_eq!(rates.rate_ib_b.x, 7.292115e-5);
//! ```

use crate::earth::{self, Geodetic, Radii};
use crate::math::compensated::Pair;
use crate::math::real::{Real, Scalar};
use crate::math::vector::Vector;
use crate::record::{Record, record};
use crate::sample::Rates;
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

    /// v̇ⁿ: how fast the components north, east, down of the velocity change, m/s²; from the radii, sine and cosine
    /// of the latitude.
    #[inline(always)]
    pub(super) fn velocity_change(&self, radii: &Radii<R>, sine: R, cosine: R) -> Vector<R> {
        let Motion { latitude, longitude, altitude, .. } = *self;
        let north_radius = radii.meridian + altitude.value;
        let east_radius = radii.prime_vertical + altitude.value;
        // By the product rule, of v_N = (R_M + h)φ̇,  v_E = (R_N + h)cosφ·λ̇,  v_D = −ḣ
        let north_growth = radii.meridian_slope * latitude.first + altitude.first;
        let east_growth = radii.prime_vertical_slope * latitude.first + altitude.first;
        Vector::new(
            north_growth * latitude.first + north_radius * latitude.second,
            (east_growth * cosine - east_radius * sine * latitude.first) * longitude.first
                + east_radius * cosine * longitude.second,
            -altitude.second,
        )
    }

    /// What perfect sensors read: angular rate and specific force in body axes.
    #[inline(always)]
    pub fn rates(&self) -> Rates<R> {
        let Motion { roll, pitch, yaw, latitude, longitude, altitude } = *self;
        let (s, c) = latitude.value.sin_cos();
        let radii = Radii::at(s, c);
        let north_radius = radii.meridian + altitude.value;
        let east_radius = radii.prime_vertical + altitude.value;
        // v_N = (R_M + h)φ̇,  v_E = (R_N + h)cosφ·λ̇,  v_D = −ḣ
        let v = Vector::new(
            north_radius * latitude.first,
            east_radius * c * longitude.first,
            -altitude.first,
        );
        let acceleration = self.velocity_change(&radii, s, c);
        let earth_rate = earth::rotation_ned(s, c);
        let transport_rate = self.transport_rate(s, c);
        // fⁿ = v̇ⁿ + (2ω_ieⁿ + ω_enⁿ) × vⁿ − gⁿ
        let coriolis = (earth_rate + earth_rate + transport_rate).cross(v);
        let mut specific_force = acceleration + coriolis;
        specific_force.z = specific_force.z - earth::gravity(s, altitude.value);

        let roll_turn = roll.value.sin_cos();
        let pitch_turn = pitch.value.sin_cos();
        let to_body = [roll_turn, pitch_turn, yaw.value.sin_cos()];
        let ((sin_roll, cos_roll), (sin_pitch, cos_pitch)) = (roll_turn, pitch_turn);
        // ω_nbᵇ = (γ̇ − ψ̇ sinθ, θ̇ cosγ + ψ̇ sinγ cosθ, −θ̇ sinγ + ψ̇ cosγ cosθ)
        let rate_nb = Vector::new(
            roll.first - yaw.first * sin_pitch,
            pitch.first * cos_roll + yaw.first * sin_roll * cos_pitch,
            yaw.first * cos_roll * cos_pitch - pitch.first * sin_roll,
        );
        Rates {
            rate_ib_b: rate_nb + turned(to_body, earth_rate + transport_rate),
            specific_force_b: turned(to_body, specific_force),
        }
    }
}

/// A vector's components in body axes, from those north, east, down; from sine and cosine of roll, pitch, yaw.
#[inline(always)]
fn turned<R: Real>([roll, pitch, yaw]: [(R, R); 3], n: Vector<R>) -> Vector<R> {
    // C_nᵇ = Rx(γ)·Ry(θ)·Rz(ψ)
    let ((sin_roll, cos_roll), (sin_pitch, cos_pitch), (sin_yaw, cos_yaw)) = (roll, pitch, yaw);
    let (x, y) = (cos_yaw * n.x + sin_yaw * n.y, cos_yaw * n.y - sin_yaw * n.x);
    let (x, z) = (cos_pitch * x - sin_pitch * n.z, sin_pitch * x + cos_pitch * n.z);
    Vector::new(x, cos_roll * y + sin_roll * z, cos_roll * z - sin_roll * y)
}

impl<R: Scalar> Motion<R> {
    /// In double precision, exactly.
    pub fn widen(&self) -> Motion<f64> {
        let wide = |jet: Jet<R>| Jet {
            value: jet.value.widen(),
            first: jet.first.widen(),
            second: jet.second.widen(),
        };
        Motion {
            roll: wide(self.roll),
            pitch: wide(self.pitch),
            yaw: wide(self.yaw),
            latitude: wide(self.latitude),
            longitude: wide(self.longitude),
            altitude: wide(self.altitude),
        }
    }

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
