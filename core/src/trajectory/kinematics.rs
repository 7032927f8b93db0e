//! Place and motion of a body in Earth-fixed axes, which are singular nowhere.
//!
//! ```
//! use schuler::trajectory::kinematics::Kinematics;
//!
//! // At rest at the north pole a sensor reads gravity, and the Earth's rate about the vertical.
//! let pole = Kinematics::at_rest([0.0, 0.0, 1.0].into(), 0.0);
//! let rates = pole.rates();
//! assert!((rates.specific_force_b.z - 9.832).abs() < 1e-3);
//! assert_eq!(rates.rate_ib_b.z, 7.292115e-5);
//! ```

use super::motion::{Jet, Motion};
use crate::earth::{self, ROTATION_RATE, Radii};
use crate::math::quaternion::Quaternion;
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::sample::Rates;
use crate::solution::{Euler, ned_to_earth_fixed};

/// A body at one instant, relative to the Earth and in its axes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Kinematics {
    /// n̂, the ellipsoid's outward normal.
    pub normal_e: Vector<f64>,
    /// Height above the ellipsoid, m.
    pub altitude: f64,
    /// ṙ, m/s.
    pub velocity_e: Vector<f64>,
    /// r̈, m/s².
    pub acceleration_e: Vector<f64>,
    /// Body → Earth-fixed axes, of unit length.
    pub attitude: Quaternion<f64>,
    /// ω_ebᵇ, rad/s.
    pub rate_eb_b: Vector<f64>,
    /// Its derivative α, rad/s².
    pub angular_acceleration_b: Vector<f64>,
}

/// Ω × a.
#[inline(always)]
pub(crate) fn earth_cross(a: Vector<f64>) -> Vector<f64> {
    Vector::new(-ROTATION_RATE * a.y, ROTATION_RATE * a.x, 0.0)
}

/// Rᵀx: what a vector in Earth-fixed axes is in the body's, for a quaternion of any length.
#[inline(always)]
pub(crate) fn to_body(attitude: Quaternion<f64>, x: Vector<f64>) -> Vector<f64> {
    // x + (2w(v × x) + v × (2v × x))/|s|², v reversed
    let v = -attitude.v;
    let t = v.cross(x) * 2.0;
    x + (t * attitude.w + v.cross(t)) * (1.0 / attitude.dot(attitude))
}

/// f and ω_ib in the body from the motion in Earth-fixed axes.
#[inline(always)]
pub(crate) fn specific_force_e(
    velocity_e: Vector<f64>,
    acceleration_e: Vector<f64>,
    gravity_e: Vector<f64>,
) -> Vector<f64> {
    // fᵉ = r̈ + 2Ω × ṙ + γn̂
    acceleration_e + earth_cross(velocity_e) * 2.0 + gravity_e
}

impl Kinematics {
    /// Standing on a normal, body axes along the Earth's.
    pub fn at_rest(normal_e: Vector<f64>, altitude: f64) -> Self {
        let zero = Vector::ZERO;
        Self {
            normal_e,
            altitude,
            velocity_e: zero,
            acceleration_e: zero,
            attitude: Quaternion::IDENTITY,
            rate_eb_b: zero,
            angular_acceleration_b: zero,
        }
    }

    /// What perfect sensors read.
    pub fn rates(&self) -> Rates<f64> {
        let gravity = earth::gravity(self.normal_e.z, self.altitude);
        let force = specific_force_e(self.velocity_e, self.acceleration_e, self.normal_e * gravity);
        let earth_rate = Vector::new(0.0, 0.0, ROTATION_RATE);
        Rates {
            rate_ib_b: self.rate_eb_b + to_body(self.attitude, earth_rate),
            specific_force_b: to_body(self.attitude, force),
        }
    }
}

/// Angular rate and acceleration in the turned axes, from the angles' first and second derivatives.
pub(super) fn euler_rates(
    euler: Euler<f64>,
    first: Vector<f64>,
    second: Vector<f64>,
) -> (Vector<f64>, Vector<f64>) {
    // ω = (γ̇ − ψ̇ sinθ, θ̇ cosγ + ψ̇ sinγ cosθ, −θ̇ sinγ + ψ̇ cosγ cosθ), and its derivative
    let (sr, cr) = Real::sin_cos(euler.roll);
    let (sp, cp) = Real::sin_cos(euler.pitch);
    let rate = Vector::new(
        first.x - first.z * sp,
        first.y * cr + first.z * sr * cp,
        first.z * cr * cp - first.y * sr,
    );
    let level = second.z * cp - first.z * first.y * sp;
    let change = Vector::new(
        second.x - second.z * sp - first.z * first.y * cp,
        second.y * cr + level * sr + first.x * rate.z,
        level * cr - second.y * sr - first.x * rate.y,
    );
    (rate, change)
}

impl From<&Motion<f64>> for Kinematics {
    fn from(motion: &Motion<f64>) -> Self {
        let Motion { roll, pitch, yaw, latitude, longitude, altitude } = *motion;
        let (s, c) = Real::sin_cos(latitude.value);
        let (sl, cl) = Real::sin_cos(longitude.value);
        let north = Vector::new(-s * cl, -s * sl, c);
        let east = Vector::new(-sl, cl, 0.0);
        let normal = Vector::new(c * cl, c * sl, s);
        let to_earth = |v: Vector<f64>| north * v.x + east * v.y - normal * v.z;
        let v = motion.velocity_ned();
        // r̈ⁿ = v̇ⁿ + ω_enⁿ × vⁿ
        let growth = motion.velocity_change(&Radii::at(s, c), s, c);
        let transport = motion.transport_rate(s, c);
        let euler = Euler { roll: roll.value, pitch: pitch.value, yaw: yaw.value };
        let of = |f: fn(Jet<f64>) -> f64| Vector::new(f(roll), f(pitch), f(yaw));
        let (rate_nb, change_nb) = euler_rates(euler, of(|jet| jet.first), of(|jet| jet.second));
        let body_to_ned = euler.quaternion();
        let transport_b = to_body(body_to_ned, transport);
        // ω̇_enⁿ: (λ̈ cosφ − λ̇ φ̇ sinφ, −φ̈, −λ̈ sinφ − λ̇ φ̇ cosφ)
        let turning = longitude.first * latitude.first;
        let transport_change = Vector::new(
            longitude.second * c - turning * s,
            -latitude.second,
            -(longitude.second * s) - turning * c,
        );
        // d/dt(C_nᵇ ω_enⁿ) = C_nᵇ ω̇_enⁿ − ω_nbᵇ × C_nᵇ ω_enⁿ
        let transport_change_b =
            to_body(body_to_ned, transport_change) - rate_nb.cross(transport_b);
        let half = |x: f64| Real::sin_cos(0.5 * x);
        let ned_to_earth = ned_to_earth_fixed(
            half(longitude.value),
            half(latitude.value + core::f64::consts::FRAC_PI_2),
        );
        Self {
            normal_e: normal,
            altitude: altitude.value,
            velocity_e: to_earth(v),
            acceleration_e: to_earth(growth + transport.cross(v)),
            attitude: ned_to_earth * body_to_ned,
            rate_eb_b: rate_nb + transport_b,
            angular_acceleration_b: change_nb + transport_change_b,
        }
    }
}
