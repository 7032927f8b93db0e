//! Latency: the motion is read a while after it took place.
//!
//! A delay of n + φ samples, 0 ≤ φ < 1, reads (1 − φ)Xₙ + φXₙ₊₁ of the increments before the present one: exact
//! for whole samples, and for a rate that is constant over each. The errors of the other terms are those of the
//! present motion. At the start the rate has been that of the first sample for long.
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::noise::Streams;
//! use schuler::sensor::{ErrorTerm, Reading, Stimulus, Timing, latency::Latency};
//!
//! let axes = |x| Vector::new(x, x, x);
//! let term = Latency::new(axes(0.025), Timing::new(0.01_f64, 1000)?)?;
//! let mut state = term.start(Streams::new(1, 0));
//! let mut read = |x| {
//!     let stimulus = Stimulus { sensed: axes(x), velocity_b: Vector::ZERO };
//!     let mut reading = Reading::new(axes(x));
//!     term.apply(&mut state, &stimulus, &mut reading);
//!     reading.increment.x
//! };
//! // Half of the sample before the last, half of the one before that.
//! let read: Vec<f64> = [0.0, 1.0, 0.0, 0.0, 0.0].into_iter().map(read).collect();
//! assert!(read.iter().zip([0.0, 0.0, 0.0, 0.5, 0.5]).all(|(a, b)| (a - b).abs() < 1e-12));
//! # Ok::<(), schuler::sensor::parameter::ParameterError>(())
//! ```

use super::parameter::{Fault, Parameter, ParameterError};
use super::{ErrorTerm, Reading, Stimulus, Timing};
use crate::math::vector::Vector;
use crate::noise::random::Random;
use crate::noise::{Deviate, Streams};
use crate::record::{Record, record};

/// The longest delay, samples.
pub const LONGEST: u32 = 8;
/// Increments that are kept: those of the longest delay, and the present one.
const KEPT: usize = 9;

/// A delay of the true motion.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Latency<R> {
    /// n of each axis.
    whole: [usize; 3],
    /// φ.
    rest: Vector<R>,
}

/// The last increments of the motion.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LatencyState<R> {
    /// The newest first, angle.
    pub past: [Vector<R>; KEPT],
    /// 0 before the first sample, then 1.
    pub started: u32,
}

impl<R: Deviate> Latency<R> {
    /// From the delay of each axis, s.
    ///
    /// # Errors
    ///
    /// [`ParameterError`] if a delay is negative, not finite, or longer than [`LONGEST`] samples.
    pub fn new(delay_s: Vector<R>, timing: Timing<R>) -> Result<Self, ParameterError> {
        let delay_s = Parameter::Latency.magnitude(delay_s)?;
        let samples = Parameter::Latency.computed(delay_s.map(|s| s / timing.interval_s()))?;
        let (mut whole, mut rest) = ([0_usize; 3], Vector::ZERO);
        for (((whole, rest), samples), axis) in
            whole.iter_mut().zip(rest.each_mut()).zip(samples.into_array()).zip(0..)
        {
            if samples > R::count(LONGEST) {
                let fault = Fault::OutOfRange;
                return Err(ParameterError {
                    parameter: Parameter::Latency,
                    axis: Some(axis),
                    fault,
                });
            }
            *rest = samples;
            // As many as there are whole ones: the last of them leaves less than one.
            while *rest >= R::ONE {
                (*whole, *rest) = (whole.saturating_add(1), *rest - R::ONE);
            }
        }
        Ok(Self { whole, rest })
    }
}

impl<R: Copy> Latency<R> {
    /// The same term in numbers of another type, as `number` makes them from these.
    pub fn map<T>(&self, number: impl Fn(R) -> T) -> Latency<T> {
        Latency { whole: self.whole, rest: self.rest.map(number) }
    }
}

impl<R: Random> ErrorTerm<R> for Latency<R> {
    type State = LatencyState<R>;

    #[inline]
    fn start(&self, _: Streams) -> LatencyState<R> {
        LatencyState { past: [Vector::ZERO; KEPT], started: 0 }
    }

    #[inline(always)]
    fn apply(&self, state: &mut Self::State, stimulus: &Stimulus<R>, reading: &mut Reading<R>) {
        let LatencyState { past, started } = state;
        if *started == 0 {
            (*past, *started) = ([stimulus.sensed; KEPT], 1);
        } else {
            past.rotate_right(1);
            if let Some(newest) = past.first_mut() {
                *newest = stimulus.sensed;
            }
        }
        // What is read less the present motion, as any error.
        let at = |n: usize| past.get(n).copied().unwrap_or(stimulus.sensed);
        let [x, y, z] = self.whole.map(|n| (at(n), at(n.saturating_add(1))));
        let earlier = Vector::new(x.0.x, y.0.y, z.0.z);
        let earliest = Vector::new(x.1.x, y.1.y, z.1.z);
        let delayed = earlier + self.rest.times(earliest - earlier);
        reading.increment = reading.increment + (delayed - stimulus.sensed);
    }
}

impl<R: Record> Record for LatencyState<R> {
    record!(past, started);
}
