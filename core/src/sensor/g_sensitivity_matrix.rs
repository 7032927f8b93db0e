//! g-sensitivity of gyros across axes: G·f with a full matrix G.
//!
//! ```
//! use schuler::math::quaternion::Matrix;
//! use schuler::math::vector::Vector;
//! use schuler::noise::Streams;
//! use schuler::sensor::{ErrorTerm, Reading, Stimulus, g_sensitivity_matrix::GSensitivityMatrix};
//!
//! // The gyro of the x axis feels specific force along z.
//! let none = Vector::ZERO;
//! let term = GSensitivityMatrix::new(Matrix { rows: [Vector::new(0.0, 0.0, 1e-4), none, none] })?;
//! let mut state = term.start(Streams::new(1, 0));
//! let truth = Vector::new(0.02_f64, 0.0, 0.0);
//! let stimulus = Stimulus { sensed: truth, velocity_b: Vector::new(0.0, 0.0, -0.098) };
//! let mut reading = Reading::new(truth);
//! term.apply(&mut state, &stimulus, &mut reading);
//! assert!((reading.increment.x - 0.02 + 9.8e-6).abs() < 1e-17);
//! # Ok::<(), schuler::sensor::parameter::ParameterError>(())
//! ```

use super::parameter::{Parameter, ParameterError};
use super::{ErrorTerm, Reading, Stimulus};
use crate::math::quaternion::Matrix;
use crate::noise::random::Random;
use crate::noise::{Deviate, Streams};

/// A rate error from specific force along any axis.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GSensitivityMatrix<R> {
    matrix: Matrix<R>,
}

impl<R: Deviate> GSensitivityMatrix<R> {
    /// From G, rad/s per m/s²: a row for each gyro, its parts along the body axes.
    ///
    /// # Errors
    ///
    /// [`ParameterError`] if an element is not finite.
    pub fn new(matrix: Matrix<R>) -> Result<Self, ParameterError> {
        Ok(Self { matrix: Parameter::GSensitivityMatrix.rows(matrix)? })
    }
}

impl<R: Copy> GSensitivityMatrix<R> {
    /// The same term in numbers of another type, as `number` makes them from these.
    pub fn map<T>(&self, number: impl Fn(R) -> T) -> GSensitivityMatrix<T> {
        GSensitivityMatrix { matrix: self.matrix.map(number) }
    }
}

impl<R: Random> ErrorTerm<R> for GSensitivityMatrix<R> {
    type State = ();

    #[inline]
    fn start(&self, _: Streams) {}

    #[inline(always)]
    fn apply(&self, _: &mut (), stimulus: &Stimulus<R>, reading: &mut Reading<R>) {
        // ∫G·f dt = G·Δv
        reading.increment = reading.increment + self.matrix * stimulus.velocity_b;
    }
}
