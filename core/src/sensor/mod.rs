//! Sensor errors, as terms that are composed.
//!
//! output = quantize(saturate(lag(x(t − D) + (S + M)·x + G·f + Σ biases + noise))), with x and f integrated
//! over a sample. The quantized output stays within the limits, too. Each term has a file, and is in its
//! exact discrete form. `()` is the perfect sensor, `(A, B)` is first A, then B, and `Option<T>` is decided
//! at run time; an absent term takes no time and no random numbers. "Angle" in a unit stands for the quantity
//! that the increments count: rad for a gyro, m/s for an accelerometer.
//!
//! ```
//! use schuler::sensor::Timing;
//!
//! let timing = Timing::new(0.01_f64, 180_000)?;
//! assert_eq!((timing.interval_s(), timing.samples()), (0.01, 180_000));
//! # Ok::<(), schuler::sensor::parameter::ParameterError>(())
//! ```

#[cfg(feature = "aiding")]
pub mod aiding;
pub mod bandwidth;
pub mod constant;
pub mod emulator;
pub mod flicker;
pub mod g_sensitivity;
pub mod g_sensitivity_matrix;
pub mod gauss_markov;
pub mod latency;
pub mod misalignment;
pub mod misalignment_matrix;
pub mod parameter;
pub mod quantization;
pub mod random_walk;
mod record;
pub mod saturation;
pub mod scale_factor;
pub mod temperature;
pub mod temperature_bias;
pub mod temperature_scale;
pub mod triad;
pub mod turn_on;
pub mod white;

use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::noise::random::Random;
use crate::noise::{Deviate, Streams};
use crate::record::Record;
use parameter::{Fault, Parameter, ParameterError};

/// The sampling of a sensor.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Timing<R> {
    interval_s: R,
    samples: u64,
}

impl<R: Deviate> Timing<R> {
    /// A sample every `interval_s` seconds, and the number of samples in a run, at least one. The run's length
    /// matters only to flicker: it sets the slowest pole.
    ///
    /// # Errors
    ///
    /// [`ParameterError`] if the interval is not positive and finite, or there are no samples.
    pub fn new(interval_s: R, samples: u64) -> Result<Self, ParameterError> {
        let interval_s = Parameter::Interval.single(interval_s)?;
        if samples == 0 {
            return Err(Parameter::Samples.fault(Fault::NotPositive));
        }
        Ok(Self { interval_s, samples })
    }
}

impl<R: Copy> Timing<R> {
    /// The same timing in numbers of another type, as `number` makes them from these.
    pub fn map<T>(self, number: impl Fn(R) -> T) -> Timing<T> {
        Timing { interval_s: number(self.interval_s), samples: self.samples }
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

/// The true input to a triad of sensors during a sample.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Stimulus<R> {
    /// The measured quantity x: Δθ for gyros (rad), Δv for accelerometers (m/s), in the body frame.
    pub sensed: Vector<R>,
    /// Integral of the specific force, ∫fᵇ dt, m/s.
    pub velocity_b: Vector<R>,
}

/// The output of a triad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading<R: Real> {
    /// The increment: it starts as the truth, and each term changes it.
    pub increment: Vector<R>,
    /// Whether an axis exceeded its limit.
    pub saturated: R::Mask,
    /// The largest increment that each axis can deliver, if there is a limit.
    pub limit: Option<Vector<R>>,
}

impl<R: Real> Reading<R> {
    /// The reading of a perfect triad without limits.
    #[inline(always)]
    pub fn new(increment: Vector<R>) -> Self {
        Self { increment, saturated: R::ZERO.less(R::ZERO), limit: None }
    }
}

#[cfg(feature = "defmt")]
impl<R: Real<Mask: defmt::Format> + defmt::Format> defmt::Format for Reading<R> {
    fn format(&self, f: defmt::Formatter) {
        let Self { increment, saturated, limit } = self;
        defmt::write!(
            f,
            "Reading {{ increment: {}, saturated: {}, limit: {} }}",
            increment,
            saturated,
            limit
        );
    }
}

/// An error term of a triad of sensors of one kind.
pub trait ErrorTerm<R: Random> {
    /// Its state from sample to sample.
    type State: Clone + Record;

    /// The state before the first sample of a run.
    fn start(&self, streams: Streams) -> Self::State;

    /// Adds the error of the next sample to a reading (limits and quantization are applied to it).
    fn apply(&self, state: &mut Self::State, stimulus: &Stimulus<R>, reading: &mut Reading<R>);
}

impl<R: Random> ErrorTerm<R> for () {
    type State = ();

    #[inline(always)]
    fn start(&self, _: Streams) {}

    #[inline(always)]
    fn apply(&self, _: &mut (), _: &Stimulus<R>, _: &mut Reading<R>) {}
}

impl<R: Random, A: ErrorTerm<R>, B: ErrorTerm<R>> ErrorTerm<R> for (A, B) {
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

impl<R: Random, T: ErrorTerm<R>> ErrorTerm<R> for Option<T> {
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
