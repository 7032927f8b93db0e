//! Turn-on bias: drawn once for each run.
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::noise::Streams;
//! use schuler::sensor::{ErrorTerm, Reading, Stimulus, Timing, turn_on::TurnOn};
//!
//! let timing = Timing::new(0.01_f64, 1000)?;
//! let axes = |x| Vector::new(x, x, x);
//! let term = TurnOn::new(axes(1e-3), timing)?;
//! let mut state = term.start(Streams::new(1, 0));
//! let truth = Vector::new(0.02_f64, 0.0, 0.0);
//! let stimulus = Stimulus { sensed: truth, velocity_b: Vector::new(0.0, 0.0, -0.098) };
//! let mut reading = Reading::new(truth);
//! term.apply(&mut state, &stimulus, &mut reading);
//! assert!((reading.increment - truth).norm() < 1e-4);
//! # Ok::<(), schuler::sensor::parameter::ParameterError>(())
//! ```

use super::parameter::{Parameter, ParameterError};
use super::{ErrorTerm, Reading, Stimulus, Timing};
use crate::math::vector::Vector;
use crate::noise::random::{Axes, Random};
use crate::noise::{Deviate, Streams};

/// A bias that is constant during a run and normally distributed over the runs.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TurnOn<R> {
    rms_increment: Vector<R>,
}

impl<R: Deviate> TurnOn<R> {
    /// From the rms of each axis, angle/s.
    ///
    /// # Errors
    ///
    /// [`ParameterError`] if an rms is negative or not finite.
    pub fn new(rms: Vector<R>, timing: Timing<R>) -> Result<Self, ParameterError> {
        let rms = Parameter::TurnOnRms.magnitude(rms)?;
        let rms_increment = Parameter::TurnOnRms.computed(rms * timing.interval_s())?;
        Ok(Self { rms_increment })
    }
}

impl<R: Copy> TurnOn<R> {
    /// The same term in numbers of another type, as `number` makes them from these.
    pub fn map<T>(&self, number: impl Fn(R) -> T) -> TurnOn<T> {
        TurnOn { rms_increment: self.rms_increment.map(number) }
    }
}

impl<R: Random> ErrorTerm<R> for TurnOn<R> {
    /// What the bias of this run adds to every sample.
    type State = Vector<R>;

    #[inline]
    fn start(&self, streams: Streams) -> Vector<R> {
        // ∫b dt = σΔt·z
        self.rms_increment.times(Axes::open(streams).normal())
    }

    #[inline(always)]
    fn apply(&self, bias: &mut Vector<R>, _: &Stimulus<R>, reading: &mut Reading<R>) {
        reading.increment = reading.increment + *bias;
    }
}
