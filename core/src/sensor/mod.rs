//! What sensors get wrong, as terms that are composed.
//!
//! output = quantize(saturate((I + S + M)·x + G·f + Σ biases + noise)), with x and f integrated over
//! a sample; quantized too, it stays within the limits. A term per file, each in its exact discrete form. `()` is the perfect sensor, `(A, B)`
//! first A then B, `Option<T>` is decided at run time; an absent term takes no time and no random
//! numbers. "Angle" in a unit stands for what the increments count: rad for a gyro, m/s for an
//! accelerometer.

pub mod constant;
pub mod emulator;
pub mod flicker;
pub mod g_sensitivity;
pub mod gauss_markov;
pub mod misalignment;
pub mod parameter;
pub mod quantization;
pub mod random_walk;
mod record;
pub mod saturation;
pub mod scale_factor;
pub mod triad;
pub mod turn_on;
pub mod white;

use crate::math::vector::Vector;
use crate::noise::{Deviate, Streams};
use crate::record::Record;
use parameter::{Fault, Parameter, ParameterError};

/// When a sensor is read.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Timing<R> {
    interval_s: R,
    samples: u64,
}

impl<R: Deviate> Timing<R> {
    /// A sample every `interval_s` seconds, and how many a run has: at least one. The run's length
    /// only matters to flicker, whose slowest pole it sets.
    pub fn new(interval_s: R, samples: u64) -> Result<Self, ParameterError> {
        let interval_s = Parameter::Interval.single(interval_s)?;
        if samples == 0 {
            return Err(Parameter::Samples.fault(Fault::NotPositive));
        }
        Ok(Self { interval_s, samples })
    }

    /// Seconds from sample to sample.
    pub fn interval_s(self) -> R {
        self.interval_s
    }

    /// Samples in a run.
    pub fn samples(self) -> u64 {
        self.samples
    }
}

/// What a triad of sensors is exposed to during a sample.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Stimulus<R> {
    /// What it measures, x: Δθ of a gyro (rad), Δv of an accelerometer (m/s), in the body frame.
    pub sensed: Vector<R>,
    /// Integral of the specific force, ∫fᵇ dt, m/s.
    pub velocity_b: Vector<R>,
}

/// What a triad makes of it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Reading<R> {
    /// The increment: begins as the truth, and passes through the terms.
    pub increment: Vector<R>,
    /// Whether an axis was beyond its limit.
    pub saturated: bool,
    /// The largest increment that each axis can put out, where there is a limit.
    pub limit: Option<Vector<R>>,
}

impl<R> Reading<R> {
    /// Of what a perfect triad without limits reads.
    pub fn new(increment: Vector<R>) -> Self {
        Self { increment, saturated: false, limit: None }
    }
}

/// A way in which a triad of like sensors errs.
pub trait ErrorTerm<R: Deviate> {
    /// What it remembers from sample to sample.
    type State: Clone + Record;

    /// The state before the first sample of a run.
    fn start(&self, streams: Streams) -> Self::State;

    /// Adds the error of the next sample to a reading (limits and steps are applied to it).
    fn apply(&self, state: &mut Self::State, stimulus: &Stimulus<R>, reading: &mut Reading<R>);
}

impl<R: Deviate> ErrorTerm<R> for () {
    type State = ();

    #[inline(always)]
    fn start(&self, _: Streams) {}

    #[inline(always)]
    fn apply(&self, _: &mut (), _: &Stimulus<R>, _: &mut Reading<R>) {}
}

impl<R: Deviate, A: ErrorTerm<R>, B: ErrorTerm<R>> ErrorTerm<R> for (A, B) {
    type State = (A::State, B::State);

    #[inline]
    fn start(&self, streams: Streams) -> Self::State {
        (self.0.start(streams.branch(0)), self.1.start(streams.branch(1)))
    }

    #[inline(always)]
    fn apply(&self, state: &mut Self::State, stimulus: &Stimulus<R>, reading: &mut Reading<R>) {
        self.0.apply(&mut state.0, stimulus, reading);
        self.1.apply(&mut state.1, stimulus, reading);
    }
}

impl<R: Deviate, T: ErrorTerm<R>> ErrorTerm<R> for Option<T> {
    type State = Option<T::State>;

    #[inline]
    fn start(&self, streams: Streams) -> Self::State {
        self.as_ref().map(|term| term.start(streams))
    }

    #[inline(always)]
    fn apply(&self, state: &mut Self::State, stimulus: &Stimulus<R>, reading: &mut Reading<R>) {
        if let (Some(term), Some(state)) = (self, state) {
            term.apply(state, stimulus, reading);
        }
    }
}
