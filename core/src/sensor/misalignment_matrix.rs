//! Misalignment of each sensor on its own: M·x with a full matrix M.
//!
//! Where a triad is not orthogonal, no rotation brings it onto the body axes; each row of M is what one sensor
//! feels of the three axes besides its own.
//!
//! ```
//! use schuler::math::quaternion::Matrix;
//! use schuler::math::vector::Vector;
//! use schuler::noise::Streams;
//! use schuler::sensor::{ErrorTerm, Reading, Stimulus, misalignment_matrix::MisalignmentMatrix};
//!
//! // The sensor of the y axis leans 1 mrad towards x.
//! let none = Vector::ZERO;
//! let term = MisalignmentMatrix::new(Matrix { rows: [none, Vector::new(1e-3, 0.0, 0.0), none] })?;
//! let mut state = term.start(Streams::new(1, 0));
//! let truth = Vector::new(0.02_f64, 0.0, 0.0);
//! let stimulus = Stimulus { sensed: truth, velocity_b: Vector::new(0.0, 0.0, -0.098) };
//! let mut reading = Reading::new(truth);
//! term.apply(&mut state, &stimulus, &mut reading);
//! assert!((reading.increment.y - 2e-5).abs() < 1e-17);
//! # Ok::<(), schuler::sensor::parameter::ParameterError>(())
//! ```

use super::parameter::{Parameter, ParameterError};
use super::{ErrorTerm, Reading, Stimulus};
use crate::math::quaternion::Matrix;
use crate::noise::random::Random;
use crate::noise::{Deviate, Streams};

/// A misalignment of each axis, to first order.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MisalignmentMatrix<R> {
    matrix: Matrix<R>,
}

impl<R: Deviate> MisalignmentMatrix<R> {
    /// From M, rad: a row for each sensor, its parts along the body axes. An element of the diagonal acts as a
    /// scale factor.
    ///
    /// # Errors
    ///
    /// [`ParameterError`] if an element is not finite.
    pub fn new(matrix: Matrix<R>) -> Result<Self, ParameterError> {
        Ok(Self { matrix: Parameter::MisalignmentMatrix.rows(matrix)? })
    }
}

impl<R: Copy> MisalignmentMatrix<R> {
    /// The same term in numbers of another type, as `number` makes them from these.
    pub fn map<T>(&self, number: impl Fn(R) -> T) -> MisalignmentMatrix<T> {
        MisalignmentMatrix { matrix: self.matrix.map(number) }
    }
}

impl<R: Random> ErrorTerm<R> for MisalignmentMatrix<R> {
    type State = ();

    #[inline]
    fn start(&self, _: Streams) {}

    #[inline(always)]
    fn apply(&self, _: &mut (), stimulus: &Stimulus<R>, reading: &mut Reading<R>) {
        // M·x
        reading.increment = reading.increment + self.matrix * stimulus.sensed;
    }
}
