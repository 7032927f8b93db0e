//! Bandwidth: the output follows the input, and the noise, as a first-order lag.
//!
//! y′ = (x − y)/T, T = 1/(2πf) for the frequency f at which the response is −3 dB. The rate is taken as constant
//! over a sample; with X and Y its increments, h = Δt/T and u = 1 − e^{−h}, that gives exactly
//!
//! ∫y dt = X + (u/h)(Y₀ − X),  Y₁ = Y₀ + u(X − Y₀).
//!
//! The sum of the outputs lags that of the inputs by T(y − y₀) alone: nothing is lost in the long run. White noise
//! keeps its density below f; a sample's variance becomes (1 − u/h)² + (u/h)²u/(2 − u) of what it was. At
//! the start the rate has been that of the first sample for long.
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::noise::Streams;
//! use schuler::sensor::{ErrorTerm, Reading, Stimulus, Timing, bandwidth::Bandwidth};
//!
//! let axes = |x| Vector::new(x, x, x);
//! let term = Bandwidth::new(axes(20.0), Timing::new(0.01_f64, 1000)?)?;
//! let mut state = term.start(Streams::new(1, 0));
//! let mut read = |x| {
//!     let stimulus = Stimulus { sensed: axes(x), velocity_b: Vector::ZERO };
//!     let mut reading = Reading::new(axes(x));
//!     term.apply(&mut state, &stimulus, &mut reading);
//!     reading.increment.x
//! };
//! // A step is followed by e^{−t/T}, T = 8 ms.
//! assert_eq!(read(0.0), 0.0);
//! assert!((read(1.0) - 0.4307).abs() < 1e-4 && (read(1.0) - 0.8380).abs() < 1e-4);
//! # Ok::<(), schuler::sensor::parameter::ParameterError>(())
//! ```

use super::parameter::{Parameter, ParameterError};
use super::{ErrorTerm, Reading, Stimulus, Timing};
use crate::math::vector::Vector;
use crate::noise::random::Random;
use crate::noise::{Deviate, Streams};
use crate::record::{Record, record};

/// A first-order lag of the output.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bandwidth<R> {
    /// u.
    approach: Vector<R>,
    /// u/h.
    share: Vector<R>,
}

/// The lag from sample to sample.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BandwidthState<R> {
    /// y at the end of the last sample, times the interval: angle.
    pub follower: Vector<R>,
    /// 0 before the first sample, then 1.
    pub started: u32,
}

impl<R: Deviate> Bandwidth<R> {
    /// From the −3 dB frequency of each axis, Hz.
    ///
    /// # Errors
    ///
    /// [`ParameterError`] if a frequency is not positive and finite.
    pub fn new(frequency_hz: Vector<R>, timing: Timing<R>) -> Result<Self, ParameterError> {
        let frequency_hz = Parameter::Bandwidth.positive(frequency_hz)?;
        let turn = R::of(core::f64::consts::TAU) * timing.interval_s();
        let ratio = Parameter::Bandwidth.computed(frequency_hz * turn)?;
        let approach = ratio.map(|h| -(-h).exp_m1());
        let share = Parameter::Bandwidth.computed(approach.zip(ratio, |u, h| u / h))?;
        Ok(Self { approach, share })
    }
}

impl<R: Copy> Bandwidth<R> {
    /// The same term in numbers of another type, as `number` makes them from these.
    pub fn map<T>(&self, number: impl Fn(R) -> T) -> Bandwidth<T> {
        Bandwidth { approach: self.approach.map(&number), share: self.share.map(number) }
    }
}

impl<R: Random> ErrorTerm<R> for Bandwidth<R> {
    type State = BandwidthState<R>;

    #[inline]
    fn start(&self, _: Streams) -> BandwidthState<R> {
        BandwidthState { follower: Vector::ZERO, started: 0 }
    }

    #[inline(always)]
    fn apply(&self, state: &mut Self::State, _: &Stimulus<R>, reading: &mut Reading<R>) {
        let input = reading.increment;
        if state.started == 0 {
            *state = BandwidthState { follower: input, started: 1 };
        }
        let behind = state.follower - input;
        reading.increment = input + self.share.times(behind);
        state.follower = state.follower - self.approach.times(behind);
    }
}

impl<R: Record> Record for BandwidthState<R> {
    record!(follower, started);
}
