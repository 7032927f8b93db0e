//! The inverse of the comparison: a solution with a given drift.
//!
//! ```
//! use schuler::drift::compare::{Drift, drift};
//! use schuler::earth::Geodetic;
//! use schuler::math::vector::Vector;
//! use schuler::solution::{Euler, Solution};
//!
//! let at = Geodetic { latitude: 0.8_f64, longitude: 0.1, altitude: 100.0 };
//! let truth = Solution::new(at, Vector::ZERO, Euler::default());
//! let wanted = Drift { position_ned: Vector::new(100.0, -50.0, 3.0), ..Drift::default() };
//! let back = drift(&wanted.added_to(&truth), &truth);
//! assert!((back.position_ned - wanted.position_ned).norm() < 1e-8);
//! ```

use super::compare::{Drift, POLAR_SINE, convergence, drift};
use crate::earth::{Geodetic, Radii};
use crate::math::compensated::Pair;
use crate::math::quaternion::Quaternion;
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::solution::Solution;

impl Drift {
    /// The solution whose drift from `truth` this is, for errors up to hundreds of kilometres. The
    /// position is found by Newton's method to the rounding floor, beyond [`POLAR_SINE`] to a nanometre.
    pub fn added_to(&self, truth: &Solution<f64>) -> Solution<f64> {
        let mut computed = *truth;
        let (s, c) = Real::sin_cos(truth.position.latitude.hi);
        let polar = s.abs() > POLAR_SINE;
        if polar {
            computed.position = beside_the_pole(self.position_ned, truth);
        } else {
            let radii = Radii::at(s, c);
            let altitude = truth.position.altitude.hi;
            let mut missing = self.position_ned;
            for _ in 0..6 {
                // Δφ = north/(R_M + h),  Δλ = east/((R_N + h)cosφ),  Δh = −down
                let position = &mut computed.position;
                let north = missing.x / (radii.meridian + altitude);
                let east = missing.y / ((radii.prime_vertical + altitude) * c);
                position.latitude = position.latitude + Pair::new(north);
                position.longitude = position.longitude + Pair::new(east);
                position.altitude = position.altitude + Pair::new(-missing.z);
                missing = self.position_ned - drift(&computed, truth).position_ned;
            }
        }
        computed.velocity_ned = truth.velocity_ned.zip(self.velocity_ned, |v, d| v + Pair::new(d));
        computed.attitude = rotation(self.attitude_ned) * truth.attitude;
        if polar {
            // From the transported north to the meridian there.
            let half = Pair::new(-0.5 * convergence(&computed, truth));
            let zero = Pair::default();
            let (sine, cosine) = half.sin_cos();
            let turn = Quaternion::new(cosine, Vector::new(zero, zero, sine));
            let Vector { x, y, z } = computed.velocity_ned;
            let (twice, rest) = (sine + sine, cosine * cosine - sine * sine);
            let turned = twice * cosine;
            computed.velocity_ned = Vector::new(rest * x - turned * y, rest * y + turned * x, z);
            computed.attitude = turn * computed.attitude;
        }
        computed
    }
}

/// The place at a given chord and height from another, where meridians are not compared.
fn beside_the_pole(off_ned: Vector<f64>, truth: &Solution<f64>) -> Geodetic<Pair<f64>> {
    let start = truth.to_earth_fixed().position_e;
    let (sl, cl) = truth.position.longitude.sin_cos();
    let (s, c) = truth.position.latitude.sin_cos();
    let (north, east) = (Pair::new(off_ned.x), Pair::new(off_ned.y));
    let altitude = truth.position.altitude + Pair::new(-off_ned.z);
    let mut up = Pair::new(-off_ned.z);
    let mut place = Geodetic::default();
    // The verticals differ by the horizontal error over the Earth's radius; each pass leaves half the
    // square of that.
    for _ in 0..6 {
        // r = r₀ + north·N̂ + east·Ê + up·Û
        let outward = up * c - north * s;
        let at = start
            + Vector::new(outward * cl - east * sl, outward * sl + east * cl, up * s + north * c);
        place = Geodetic::from_earth_fixed(at.map(|x| x.hi + x.lo));
        up = up + altitude + Pair::new(-place.altitude);
    }
    Geodetic {
        latitude: Pair::new(place.latitude),
        longitude: Pair::new(place.longitude),
        altitude,
    }
}

/// The quaternion of a rotation vector, rad, to about twice the digits where it is small.
fn rotation(vector: Vector<f64>) -> Quaternion<Pair<f64>> {
    let half = 0.5 * vector.norm();
    let (sine, cosine) = Pair::new(half).sin_cos();
    let factor =
        if half > 0.0 { sine * Pair::new(2.0 * half).reciprocal() } else { Pair::new(0.5) };
    Quaternion::new(cosine, vector.map(|c| factor * Pair::new(c)))
}
