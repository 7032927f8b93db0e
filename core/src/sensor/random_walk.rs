//! Random walk of the bias: rate random walk, acceleration random walk.
//!
//! The step of the bias and its integral over a sample are correlated, and are drawn jointly.
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::noise::Streams;
//! use schuler::sensor::{ErrorTerm, Reading, Stimulus, Timing, random_walk::RandomWalk};
//!
//! let timing = Timing::new(0.01_f64, 1000)?;
//! let axes = |x| Vector::new(x, x, x);
//! let term = RandomWalk::new(axes(1e-4), timing)?;
//! let mut state = term.start(Streams::new(1, 0));
//! let truth = Vector::new(0.02_f64, 0.0, 0.0);
//! let stimulus = Stimulus { sensed: truth, velocity_b: Vector::new(0.0, 0.0, -0.098) };
//! let mut reading = Reading::new(truth);
//! term.apply(&mut state, &stimulus, &mut reading);
//! assert!((reading.increment - truth).norm() < 1e-5);
//! # Ok::<(), schuler::sensor::parameter::ParameterError>(())
//! ```

use super::parameter::{Parameter, ParameterError};
use super::{ErrorTerm, Reading, Stimulus, Timing};
use crate::math::vector::Vector;
use crate::noise::random::{Axes, Random};
use crate::noise::{Deviate, Streams};
use crate::record::{Record, record};

/// A bias that starts at zero and integrates white noise. Its Allan variance is K²τ/3.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RandomWalk<R> {
    interval_s: R,
    step: Vector<R>,
    coupled: Vector<R>,
    independent: Vector<R>,
}

/// The bias and its random numbers.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RandomWalkState<R: Random> {
    /// The bias at the end of the last sample, angle/s.
    pub bias: Vector<R>,
    streams: Axes<R>,
}

impl<R: Deviate> RandomWalk<R> {
    /// From K of each axis, angle/s/√s.
    ///
    /// # Errors
    ///
    /// [`ParameterError`] if a density is negative or not finite.
    pub fn new(density: Vector<R>, timing: Timing<R>) -> Result<Self, ParameterError> {
        let density = Parameter::RandomWalk.magnitude(density)?;
        let interval_s = timing.interval_s();
        let step = Parameter::RandomWalk.computed(density * interval_s.sqrt())?;
        let coupled = Parameter::RandomWalk.computed(step * (interval_s * R::HALF))?;
        let independent = step * (interval_s * R::of(0.28867513459481287));
        Ok(Self { interval_s, step, coupled, independent })
    }
}

impl<R: Copy> RandomWalk<R> {
    /// The same term in numbers of another type, as `number` makes them from these.
    pub fn map<T>(&self, number: impl Fn(R) -> T) -> RandomWalk<T> {
        RandomWalk {
            interval_s: number(self.interval_s),
            step: self.step.map(&number),
            coupled: self.coupled.map(&number),
            independent: self.independent.map(&number),
        }
    }
}

impl<R: Random> ErrorTerm<R> for RandomWalk<R> {
    type State = RandomWalkState<R>;

    #[inline]
    fn start(&self, streams: Streams) -> RandomWalkState<R> {
        RandomWalkState { bias: Vector::ZERO, streams: Axes::open(streams) }
    }

    #[inline(always)]
    fn apply(&self, state: &mut Self::State, _: &Stimulus<R>, reading: &mut Reading<R>) {
        let (first, second) = (state.streams.normal(), state.streams.normal());
        // ∫b = b₀Δt + K√Δt·Δt(½z₁ + z₂/√12),  b₁ = b₀ + K√Δt·z₁
        let integral = state.bias * self.interval_s
            + self.coupled.times(first)
            + self.independent.times(second);
        reading.increment = reading.increment + integral;
        state.bias = state.bias + self.step.times(first);
    }
}

impl<R: Random> Record for RandomWalkState<R> {
    record!(bias, streams);
}
