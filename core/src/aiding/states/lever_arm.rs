//! The lever arm from the inertial unit to the sensor that measures, where it is not known well enough.

use crate::aiding::transition::{cross_matrix, matrix_of};
use crate::math::quaternion::Matrix;
use crate::math::real::Real;
use crate::math::vector::Vector;

/// A lever arm in body axes: three constants.
///
/// ```
/// use schuler::aiding::states::lever_arm::LeverArm;
///
/// // The error of a position is that of the lever arm itself.
/// assert_eq!(LeverArm::<f64>::of_position().rows[1].y, 1.0);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LeverArm<R> {
    /// Its standard deviation per axis, m.
    pub sigma: R,
}

impl<R: Real> LeverArm<R> {
    /// Its components.
    pub const STATES: usize = 3;

    /// Its columns in a measured position, in body axes.
    pub fn of_position() -> Matrix<R> {
        matrix_of(|arm| arm)
    }

    /// Its columns in a measured velocity, in body axes: [ω_eb×].
    pub fn of_velocity(rate_eb_b: Vector<R>) -> Matrix<R> {
        cross_matrix(rate_eb_b)
    }
}
