//! Constant bias: the same in every run.
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::noise::Streams;
//! use schuler::sensor::{ErrorTerm, Reading, Stimulus, Timing, constant::Constant};
//!
//! let timing = Timing::new(0.01_f64, 1000)?;
//! let axes = |x| Vector::new(x, x, x);
//! let term = Constant::new(axes(1e-3), timing)?;
//! let mut state = term.start(Streams::new(1, 0));
//! let truth = Vector::new(0.02_f64, 0.0, 0.0);
//! let stimulus = Stimulus { sensed: truth, velocity_b: Vector::new(0.0, 0.0, -0.098) };
//! let mut reading = Reading::new(truth);
//! term.apply(&mut state, &stimulus, &mut reading);
//! assert!((reading.increment - truth - axes(1e-5)).norm() < 1e-17);
//! # Ok::<(), schuler::sensor::parameter::ParameterError>(())
//! ```

use super::parameter::{Parameter, ParameterError};
use super::{ErrorTerm, Reading, Stimulus, Timing};
use crate::math::vector::Vector;
use crate::noise::random::Random;
use crate::noise::{Deviate, Streams};

/// A bias that never changes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Constant<R> {
    increment: Vector<R>,
}

impl<R: Deviate> Constant<R> {
    /// From the bias of each axis, angle/s.
    ///
    /// # Errors
    ///
    /// [`ParameterError`] if a bias is not finite.
    pub fn new(bias: Vector<R>, timing: Timing<R>) -> Result<Self, ParameterError> {
        let bias = Parameter::Constant.signed(bias)?;
        // ∫b dt = bΔt
        let increment = Parameter::Constant.computed(bias * timing.interval_s())?;
        Ok(Self { increment })
    }
}

impl<R: Copy> Constant<R> {
    /// The same term in numbers of another type, as `number` makes them from these.
    pub fn map<T>(&self, number: impl Fn(R) -> T) -> Constant<T> {
        Constant { increment: self.increment.map(number) }
    }
}

impl<R: Random> ErrorTerm<R> for Constant<R> {
    type State = ();

    #[inline]
    fn start(&self, _: Streams) {}

    #[inline(always)]
    fn apply(&self, _: &mut (), _: &Stimulus<R>, reading: &mut Reading<R>) {
        reading.increment = reading.increment + self.increment;
    }
}
