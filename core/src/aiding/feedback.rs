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
use super::states::Extra;
use super::surroundings::{Pose, Surroundings};
use super::transition::matrix_of;
use crate::math::compensated::Pair;
use crate::math::quaternion::{Matrix, Quaternion};
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::strapdown::correction::{Correction, turn};

/// A correction of the attitude, rad, beyond which the covariance is turned with it.
const TURNING: f64 = 1e-3;

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

/// The left Jacobian of a rotation: exp([(ψ + ε)×]) ≈ exp([Jε×])·exp([ψ×]).
fn jacobian<R: Real>(psi: Vector<R>) -> Matrix<R> {
    // J = I + (1 − cosθ)/θ²·[ψ×] + (θ − sinθ)/θ³·[ψ×]²
    let angle = psi.norm();
    let none = angle.less(R::of(1e-2));
    let divisor = R::select(none, R::ONE, angle);
    // As a pair: libm's functions of single precision compute in double.
    let (sine, cosine) = Pair::new(angle).sin_cos();
    let square = divisor * divisor;
    let first = R::select(none, R::HALF, (R::ONE - cosine.hi) / square);
    let second = R::select(none, R::ratio(1, 6), (divisor - sine.hi) / (square * divisor));
    matrix_of(|x| {
        let once = psi.cross(x);
        x + once * first + psi.cross(once) * second
    })
}

impl<R: Real, const N: usize, const P: usize, const E: usize> Filter<R, N, P, E> {
    /// Feeds estimated errors back: into the biases and the further states here, and as a correction that the
    /// mechanization is to take. `pose` is that of the state before the correction.
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
        let large = R::of(TURNING).less(psi.norm());
        if R::any(large) {
            let mut ud = self.ud;
            ud.map_states(0, &turning(model, errors));
            self.ud.replace(large, &ud);
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

/// How errors about the corrected state follow from those about the estimated errors.
#[inline(never)]
fn turning<R: Real, const N: usize>(model: &Model<R>, errors: &[R; N]) -> [[R; N]; N] {
    // ψ′ = Jε_ψ; a vector's error in the corrected axes: δv′ = ε_v + δv × ψ′
    let mut map = [[R::ZERO; N]; N];
    for (n, row) in map.iter_mut().enumerate() {
        if let Some(cell) = row.get_mut(n) {
            *cell = R::ONE;
        }
    }
    let jacobian = jacobian(vector(errors, 6));
    let mut put = |first: usize, block: Matrix<R>| {
        for (row, block) in map.iter_mut().skip(first).zip(block.rows) {
            for (cell, x) in row.iter_mut().skip(6).zip(block.into_array()) {
                *cell = x;
            }
        }
    };
    let crossed = |first: usize| {
        let along = vector(errors, first);
        matrix_of(|x| along.cross(jacobian * x))
    };
    put(0, crossed(0));
    put(3, crossed(3));
    put(6, jacobian);
    for (first, extra) in model.extras() {
        if let Extra::Resonator(_) = extra {
            put(first, crossed(first));
            put(first + 3, crossed(first + 3));
        }
    }
    map
}
