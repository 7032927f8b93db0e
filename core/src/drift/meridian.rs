//! From errors along the true axes to drift, in which truth and computed solution have their own axes.
//!
//! This is the only place where the tangent of the latitude occurs. Source: the ψ- and the φ-angle error
//! models and the turn δθ between their axes, Benson, IEEE Trans. AES-11(4), 1975.
//!
//! ```
//! use schuler::drift::linear::ErrorState;
//! use schuler::drift::meridian::MeridianShift;
//! use schuler::math::vector::Vector;
//! use schuler::trajectory::{Jet, Motion};
//!
//! let still = Motion {
//!     latitude: Jet { value: 0.8_f64, ..Jet::default() },
//!     altitude: Jet { value: 100.0, ..Jet::default() },
//!     ..Motion::default()
//! };
//! // A position error of 1 km to the east turns the computed north, so it shows as a heading error, too.
//! let error = ErrorState { position: Vector::new(0.0, 1000.0, 0.0), ..ErrorState::default() };
//! let drift = MeridianShift::new(&still).drift(&error);
//! assert!((drift.attitude_ned.z - 1000.0 / 6.39e6 * 0.8_f64.tan()).abs() < 1e-6);
//! ```

use super::compare::{Drift, POLAR_SINE};
use super::linear::ErrorState;
use crate::earth::Radii;
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::trajectory::Motion;

/// The rotation of the computed north, east and down with the computed position, and its effect on
/// velocity and attitude: δθ = (δλ cosφ, −δφ, −δλ sinφ).
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MeridianShift<R> {
    /// Of the truth, m/s.
    velocity_ned: Vector<R>,
    /// 1/(R_M + h), 1/m.
    per_north: R,
    /// 1/(R_N + h), 1/m.
    per_east: R,
    /// tanφ/(R_N + h), 1/m; 0 where meridians are not compared.
    convergence: R,
    /// −1 beyond the pole, where the printed north has the opposite direction; else 1.
    facing: R,
}

impl<R: Real> MeridianShift<R> {
    /// At an instant of a motion. As in [`compare::drift`](super::compare::drift), meridians are not
    /// compared beyond [`POLAR_SINE`]: to first order, the north that is carried along does not turn.
    pub fn new(motion: &Motion<R>) -> Self {
        let (s, c) = motion.latitude.value.sin_cos();
        let radii = Radii::at(s, c);
        let east_radius = radii.prime_vertical + motion.altitude.value;
        let polar = R::of(POLAR_SINE).less(s.abs());
        let divisor = R::select(polar, R::ONE, east_radius * c);
        Self {
            velocity_ned: motion.velocity_ned(),
            per_north: R::ONE / (radii.meridian + motion.altitude.value),
            per_east: R::ONE / east_radius,
            convergence: R::select(polar, R::ZERO, s / divisor),
            facing: R::select(c.less(R::ZERO), -R::ONE, R::ONE),
        }
    }

    /// δθ of a position error.
    fn shift(&self, position: Vector<R>) -> Vector<R> {
        Vector::new(
            position.y * self.per_east,
            -(position.x * self.per_north),
            -(position.y * self.convergence),
        )
    }

    /// To the axes of the printed position, and back.
    fn face(&self, x: Vector<R>) -> Vector<R> {
        Vector::new(x.x * self.facing, x.y * self.facing, x.z)
    }

    /// The drift that corresponds to an error.
    pub fn drift(&self, x: &ErrorState<R>) -> Drift<R> {
        // C_eⁿ(computed) = (I − [δθ×])C_eⁿ(true):  v_computedⁿ − vⁿ = δv − δθ × v,  φ = ψ − δθ
        let shift = self.shift(x.position);
        Drift {
            position_ned: self.face(x.position),
            velocity_ned: self.face(x.velocity - shift.cross(self.velocity_ned)),
            attitude_ned: self.face(x.attitude - shift),
        }
    }

    /// The error that corresponds to a drift.
    pub fn error(&self, drift: &Drift<R>) -> ErrorState<R> {
        let position = self.face(drift.position_ned);
        let shift = self.shift(position);
        ErrorState {
            position,
            velocity: self.face(drift.velocity_ned) + shift.cross(self.velocity_ned),
            attitude: self.face(drift.attitude_ned) + shift,
        }
    }
}
