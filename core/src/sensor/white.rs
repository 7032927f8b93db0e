//! White noise on the rates: angle random walk, velocity random walk.
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::noise::Streams;
//! use schuler::sensor::{ErrorTerm, Reading, Stimulus, Timing, white::White};
//!
//! let timing = Timing::new(0.01_f64, 1000)?;
//! let axes = |x| Vector::new(x, x, x);
//! let term = White::new(axes(1e-4), timing)?;
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

/// White noise, whose integral is a random walk. Its Allan variance is N²/τ.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct White<R> {
    deviation: Vector<R>,
}

impl<R: Deviate> White<R> {
    /// From N of each axis, angle/√s.
    ///
    /// # Errors
    ///
    /// [`ParameterError`] if a density is negative or not finite.
    pub fn new(density: Vector<R>, timing: Timing<R>) -> Result<Self, ParameterError> {
        let density = Parameter::WhiteNoise.magnitude(density)?;
        let deviation = Parameter::WhiteNoise.computed(density * timing.interval_s().sqrt())?;
        Ok(Self { deviation })
    }
}

impl<R: Copy> White<R> {
    /// The same term in numbers of another type, as `number` makes them from these.
    pub fn map<T>(&self, number: impl Fn(R) -> T) -> White<T> {
        White { deviation: self.deviation.map(number) }
    }
}

impl<R: Random> ErrorTerm<R> for White<R> {
    type State = Axes<R>;

    #[inline]
    fn start(&self, streams: Streams) -> Axes<R> {
        Axes::open(streams)
    }

    #[inline(always)]
    fn apply(&self, streams: &mut Axes<R>, _: &Stimulus<R>, reading: &mut Reading<R>) {
        // N√Δt·z
        let noise = self.deviation.times(streams.normal());
        reading.increment = reading.increment + noise;
    }
}
