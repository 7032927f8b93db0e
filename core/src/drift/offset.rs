//! The inverse of the comparison: a solution that is off by a given drift.

use super::compare::{Drift, drift};
use crate::earth::Radii;
use crate::math::compensated::Pair;
use crate::math::quaternion::Quaternion;
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::solution::Solution;

impl Drift {
    /// The solution whose drift from `truth` this is; the position by Newton's method, which settles
    /// to the rounding floor for errors up to hundreds of kilometres, away from the poles.
    pub fn added_to(&self, truth: &Solution<f64>) -> Solution<f64> {
        let mut computed = *truth;
        for (sum, add) in
            computed.velocity_ned.each_mut().into_iter().zip(self.velocity_ned.into_array())
        {
            *sum = *sum + Pair::new(add);
        }
        computed.attitude = rotation(self.attitude_ned) * truth.attitude;
        let (s, c) = Real::sin_cos(truth.position.latitude.hi);
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
        computed
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
