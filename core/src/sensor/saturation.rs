//! Saturation: no axis reads more than its limit.
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::noise::Streams;
//! use schuler::sensor::{ErrorTerm, Reading, Stimulus, Timing, saturation::Saturation};
//!
//! let timing = Timing::new(0.01_f64, 1000)?;
//! let axes = |x| Vector::new(x, x, x);
//! let term = Saturation::new(axes(1.0), timing)?;
//! let mut state = term.start(Streams::new(1, 0));
//! let truth = Vector::new(0.02_f64, 0.0, 0.0);
//! let stimulus = Stimulus { sensed: truth, velocity_b: Vector::new(0.0, 0.0, -0.098) };
//! let mut reading = Reading::new(truth);
//! term.apply(&mut state, &stimulus, &mut reading);
//! assert!(reading.saturated && (reading.increment.x - 0.01).abs() < 1e-16);
//! # Ok::<(), schuler::sensor::parameter::ParameterError>(())
//! ```

use super::parameter::{Parameter, ParameterError};
use super::{ErrorTerm, Reading, Stimulus, Timing};
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::noise::random::Random;
use crate::noise::{Deviate, Streams};

/// Limits of the mean rate over a sample. A larger reading is set to the limit, and marked.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Saturation<R> {
    limit: Vector<R>,
}

impl<R: Deviate> Saturation<R> {
    /// From the largest output of each axis, angle/s.
    ///
    /// # Errors
    ///
    /// [`ParameterError`] if a limit is not positive and finite.
    pub fn new(limit: Vector<R>, timing: Timing<R>) -> Result<Self, ParameterError> {
        let limit = Parameter::Saturation.positive(limit)?;
        let interval_s = timing.interval_s();
        let increment = limit.map(|rate| {
            let increment = rate * interval_s;
            // Converted back to a rate, it must not exceed the limit by rounding.
            let below = increment - increment * R::entry(6e-8, 1.2e-16);
            if increment / interval_s > rate { below } else { increment }
        });
        Ok(Self { limit: Parameter::Saturation.computed(increment)? })
    }
}

impl<R: Copy> Saturation<R> {
    /// The same term in numbers of another type, as `number` makes them from these.
    pub fn map<T>(&self, number: impl Fn(R) -> T) -> Saturation<T> {
        Saturation { limit: self.limit.map(number) }
    }
}

impl<R: Random> ErrorTerm<R> for Saturation<R> {
    type State = ();

    #[inline]
    fn start(&self, _: Streams) {}

    #[inline(always)]
    fn apply(&self, _: &mut (), _: &Stimulus<R>, reading: &mut Reading<R>) {
        let (read, limit, mark) = (reading.increment, self.limit, &mut reading.saturated);
        let increment = Vector {
            x: limited(read.x, limit.x, mark),
            y: limited(read.y, limit.y, mark),
            z: limited(read.z, limit.z, mark),
        };
        (reading.increment, reading.limit) = (increment, Some(self.limit));
    }
}

/// A reading within ± a limit, and a mark where it was not.
#[inline(always)]
fn limited<R: Real>(x: R, limit: R, saturated: &mut R::Mask) -> R {
    let (over, under) = (limit.less(x), x.less(-limit));
    *saturated = *saturated | over | under;
    R::select(over, limit, R::select(under, -limit, x))
}
