//! The estimated errors as a correction of the running state, and into the estimates.
//!
//! ```
//! use schuler::aiding::feedback::correction;
//! use schuler::aiding::surroundings::{Pose, Surroundings};
//! use schuler::earth::Geodetic;
//! use schuler::math::quaternion::Quaternion;
//! use schuler::math::vector::Vector;
//!
//! let here = Surroundings::at(&Geodetic { latitude: 0.8_f64, longitude: 0.1, altitude: 0.0 });
//! let pose = Pose { body_to_ned: Quaternion::IDENTITY.matrix(1.0), velocity_ned: Vector::ZERO };
//! // The computed velocity is too large: it is lowered.
//! let errors = [0.0, 0.0, 0.0, 0.1, 0.0, 0.0, 0.0, 0.0, 0.0];
//! assert_eq!(correction(&errors, &pose, &here).velocity_ned.x, -0.1);
//! ```

use super::filter::Filter;
use super::model::{FIRST_EXTRA, GYRO_BIAS, Model};
use super::surroundings::{Pose, Surroundings};
use crate::math::compensated::Pair;
use crate::math::quaternion::{Matrix, Quaternion};
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::strapdown::correction::{Correction, turn};

/// Three errors from a state on.
fn vector<R: Real>(errors: &[R], first: usize) -> Vector<R> {
    let at = |n: usize| errors.get(first + n).copied().unwrap_or(R::ZERO);
    Vector::new(at(0), at(1), at(2))
}

/// Rotates a vector by a rotation that is stored less one.
fn turned<R: Real>(less_one: Quaternion<R>, x: Vector<R>) -> Vector<R> {
    x + less_one.turn_less_one(x)
}

/// The correction that takes the errors off a solution with this pose.
pub fn correction<R: Real>(errors: &[R], pose: &Pose<R>, here: &Surroundings<R>) -> Correction<R> {
    // C⁺ = Ĉ exp(−[ψ×]),  r⁺ = r̂ − C⁺δr,  v⁺ = v̂ − C⁺δv for the inertial velocity, v − ω_ie × r for that
    // relative to the Earth
    let psi = vector(errors, 6);
    let back = turn::rotation(-psi);
    let to_ned = |x: Vector<R>| pose.body_to_ned * turned(back, x);
    let position_ned = -to_ned(vector(errors, 0));
    let gained = -to_ned(vector(errors, 3)) - here.earth_rate_ned.cross(position_ned);
    // Local axes turn with the place, by δθ: velocity and attitude are those against the new ones.
    let local = here.turn(position_ned);
    Correction {
        position_ned,
        velocity_ned: gained - local.cross(pose.velocity_ned + gained),
        attitude_ned: -(pose.body_to_ned * psi) - local,
    }
}

impl<R: Real, const N: usize, const P: usize, const E: usize> Filter<R, N, P, E> {
    /// Feeds estimated errors back: into the biases and the further states here, and as a correction that the
    /// mechanization is to take. `pose` is that of the state before the correction.
    ///
    /// The covariance stays as it is. That errors about the corrected state are turned by half the correction is of the
    /// second order, as what Φ leaves out of ψ × u; to take the one without the other would tell a tilt from a
    /// bias of the accelerometers, which nothing at rest does.
    pub fn feed(
        &mut self,
        model: &Model<R>,
        errors: &[R; N],
        pose: &Pose<R>,
        here: &Surroundings<R>,
    ) -> Correction<R> {
        let biases = errors.get(GYRO_BIAS..).unwrap_or(&[]);
        let (gyro, force) = (vector(biases, 0), vector(biases, 3));
        let add = |to: Pair<R>, x: R| to + Pair::new(x);
        self.gyro_bias = self.gyro_bias.zip(gyro, add);
        self.accelerometer_bias = self.accelerometer_bias.zip(force, add);
        let psi = vector(errors, 6);
        let corrected = corrected(pose, psi);
        for (first, extra) in model.extras() {
            let (at, end) = (first - FIRST_EXTRA, first + extra.states());
            let estimate = self.extras.get_mut(at..end - FIRST_EXTRA);
            if let (Some(estimate), Some(errors)) = (estimate, errors.get(first..end)) {
                extra.feed(estimate, errors, &corrected);
            }
        }
        correction(errors, pose, here)
    }
}

/// The pose after a correction of the attitude.
fn corrected<R: Real>(pose: &Pose<R>, psi: Vector<R>) -> Pose<R> {
    // A row of C exp(−[ψ×]) is exp([ψ×]) times the row of C.
    let forth = turn::rotation(psi);
    Pose {
        body_to_ned: Matrix { rows: pose.body_to_ned.rows.map(|row| turned(forth, row)) },
        ..*pose
    }
}
