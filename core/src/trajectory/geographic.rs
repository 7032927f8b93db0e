//! What a navigator would print of a place and an attitude in Earth-fixed axes.

use super::kinematics::{Kinematics, to_body};
use super::motion::{Jet, Motion};
use crate::earth::{ECCENTRICITY_SQUARED, Geodetic, Radii};
use crate::math::compensated::Pair;
use crate::math::quaternion::Quaternion;
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::solution::{Euler, Solution, ned_to_earth_fixed};
use core::f64::consts::FRAC_PI_2;

/// ½π to twice the digits.
const HALF_PI: Pair<f64> = Pair { hi: FRAC_PI_2, lo: 6.123_233_995_736_766e-17 };

/// Latitude and longitude of a normal, to the digits of a double.
pub(super) fn angles(normal: Vector<f64>) -> (f64, f64) {
    let across = Real::sqrt(normal.x * normal.x + normal.y * normal.y);
    (Real::atan2(normal.z, across), Real::atan2(normal.y, normal.x))
}

/// v in north, east, down, from sine and cosine of latitude and longitude, and the climb.
fn velocity_ned(
    (s, c): (f64, f64),
    (sl, cl): (f64, f64),
    velocity_e: Vector<f64>,
    climb: f64,
) -> Vector<f64> {
    let outward = velocity_e.x * cl + velocity_e.y * sl;
    Vector::new(c * velocity_e.z - s * outward, velocity_e.y * cl - velocity_e.x * sl, -climb)
}

/// A state in Earth-fixed axes, as it comes from polynomials.
#[derive(Clone, Copy, Debug)]
pub(super) struct State {
    /// The normal, of any length.
    pub m: Vector<f64>,
    /// Height, m.
    pub altitude: f64,
    /// Its rate, m/s.
    pub climb: f64,
    /// Relative to the Earth, m/s.
    pub velocity_e: Vector<f64>,
    /// Body → Earth-fixed axes, of any length.
    pub attitude: Quaternion<f64>,
}

impl From<&Kinematics> for State {
    fn from(at: &Kinematics) -> Self {
        Self {
            m: at.normal_e,
            altitude: at.altitude,
            climb: at.velocity_e.dot(at.normal_e),
            velocity_e: at.velocity_e,
            attitude: at.attitude,
        }
    }
}

/// The printed state, to the digits of a double.
pub(super) fn solution(state: &State) -> Solution<f64> {
    let State { m, altitude, climb, velocity_e, attitude } = *state;
    let (latitude, longitude) = angles(m);
    let across = Real::sqrt(m.x * m.x + m.y * m.y);
    let length = Real::sqrt(across * across + m.z * m.z);
    let ring = (m.z / length, across / length);
    // At a pole the meridian is that of longitude 0.
    let meridian = if across > 0.0 { (m.y / across, m.x / across) } else { (0.0, 1.0) };
    let half = |x: f64| Real::sin_cos(0.5 * x);
    let unit = attitude * (1.0 / Real::sqrt(attitude.dot(attitude)));
    let to_earth = ned_to_earth_fixed(half(longitude), half(latitude + FRAC_PI_2));
    Solution {
        position: Geodetic { latitude, longitude, altitude }.map(Pair::new),
        velocity_ned: velocity_ned(ring, meridian, velocity_e, climb).map(Pair::new),
        attitude: (to_earth.conjugate() * unit).map(Pair::new),
    }
}

/// The same to about twice the digits.
pub(super) fn initial(state: &State) -> Solution<f64> {
    let State { altitude, climb, velocity_e, .. } = *state;
    let (latitude, longitude) = angles(state.m);
    let m = state.m.map(Pair::new);
    let across2 = m.x * m.x + m.y * m.y;
    let across = if across2.hi > 0.0 { across2.sqrt() } else { Pair::default() };
    let (s, c) = Pair::new(latitude).sin_cos();
    // The rest of an angle is the sine of what the double misses: σ cosφ − |n̂_xy| sinφ
    let length = (across2 + m.z * m.z).sqrt();
    let rest = (m.z * c - across * s) * length.reciprocal();
    let latitude = Pair::sum(latitude, rest.hi);
    let (sl, cl) = Pair::new(longitude).sin_cos();
    let rest =
        if across.hi > 0.0 { (m.y * cl - m.x * sl) * across.reciprocal() } else { Pair::default() };
    let longitude = Pair::sum(longitude, rest.hi);
    let q = state.attitude.map(Pair::new);
    let square = q.w * q.w + q.v.dot(q.v);
    let unit = q * square.sqrt().reciprocal();
    let half = Pair::new(0.5);
    let from_south = latitude + HALF_PI;
    let to_earth = ned_to_earth_fixed((longitude * half).sin_cos(), (from_south * half).sin_cos());
    let (ring, meridian) = ((s.hi, c.hi), (sl.hi, cl.hi));
    Solution {
        position: Geodetic { latitude, longitude, altitude: Pair::new(altitude) },
        velocity_ned: velocity_ned(ring, meridian, velocity_e, climb).map(Pair::new),
        attitude: to_earth.conjugate() * unit,
    }
}

/// Angles and their derivatives; not a number where they are not defined.
pub(super) fn motion(at: &Kinematics, climb: f64, climb_change: f64) -> Motion<f64> {
    let printed = solution(&State { climb, ..State::from(at) });
    let (latitude, longitude) = (printed.position.latitude.hi, printed.position.longitude.hi);
    let ((s, c), meridian) = (Real::sin_cos(latitude), Real::sin_cos(longitude));
    let radii = Radii::at(s, c);
    let (north_radius, axis_distance) =
        (radii.meridian + at.altitude, (radii.prime_vertical + at.altitude) * c);
    let v = printed.velocity_ned.map(|c| c.hi);
    // φ̇ = v_N/(R_M + h),  λ̇ = v_E/((R_N + h)cosφ)
    let (latitude_rate, longitude_rate) = (v.x / north_radius, v.y / axis_distance);
    let transport = Vector::new(longitude_rate * c, -latitude_rate, -(longitude_rate * s));
    // v̇ⁿ = r̈ⁿ − ω_enⁿ × vⁿ, and the product rule the other way round
    let accelerated = velocity_ned((s, c), meridian, at.acceleration_e, 0.0);
    let change = accelerated - transport.cross(v);
    let slope = ECCENTRICITY_SQUARED * s * c / (1.0 - ECCENTRICITY_SQUARED * s * s);
    let north_growth = 3.0 * radii.meridian * slope * latitude_rate + climb;
    let east_growth = radii.prime_vertical * slope * latitude_rate + climb;
    let axis_growth = east_growth * c - (radii.prime_vertical + at.altitude) * s * latitude_rate;
    let attitude = printed.attitude.map(|c| c.hi);
    let Euler { roll, pitch, yaw } = Euler::from_quaternion(attitude);
    // γ̇ = p + (q sinγ + r cosγ)tanθ,  θ̇ = q cosγ − r sinγ,  ψ̇ = (q sinγ + r cosγ)/cosθ
    let rate = at.rate_eb_b - to_body(attitude, transport);
    let (sr, cr) = Real::sin_cos(roll);
    let (sp, cp) = Real::sin_cos(pitch);
    let yaw_rate = (rate.y * sr + rate.z * cr) / cp;
    let jet = |value: f64, first: f64, second: f64| Jet { value, first, second };
    Motion {
        roll: jet(roll, rate.x + yaw_rate * sp, 0.0),
        pitch: jet(pitch, rate.y * cr - rate.z * sr, 0.0),
        yaw: jet(yaw, yaw_rate, 0.0),
        latitude: jet(
            latitude,
            latitude_rate,
            (change.x - north_growth * latitude_rate) / north_radius,
        ),
        longitude: jet(
            longitude,
            longitude_rate,
            (change.y - axis_growth * longitude_rate) / axis_distance,
        ),
        altitude: jet(at.altitude, climb, climb_change),
    }
}

/// ḧ of a place in motion: r̈·n̂ and what the turning of the normal adds.
pub(super) fn climb_change(at: &Kinematics) -> f64 {
    // ḣ = v·n̂:  ḧ = r̈·n̂ + v·n̂',  v·n̂' = v_N²/(R_M + h) + v_E²/(R_N + h)
    let (latitude, longitude) = angles(at.normal_e);
    let ((s, c), meridian) = (Real::sin_cos(latitude), Real::sin_cos(longitude));
    let radii = Radii::at(s, c);
    let v = velocity_ned((s, c), meridian, at.velocity_e, 0.0);
    at.acceleration_e.dot(at.normal_e)
        + v.x * v.x / (radii.meridian + at.altitude)
        + v.y * v.y / (radii.prime_vertical + at.altitude)
}
