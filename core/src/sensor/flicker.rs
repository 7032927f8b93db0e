//! Flicker: bias instability, noise of density 1/f.
//!
//! A sum of Gauss-Markov processes, one per decade of correlation time from the sample interval to
//! the run's length: T_i = 10ⁱ Δt, σ_i² = B² ln(T_{i+1}/T_i)/π.
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::noise::Streams;
//! use schuler::sensor::{ErrorTerm, Reading, Stimulus, Timing, flicker::Flicker};
//!
//! let timing = Timing::new(0.01_f64, 1000)?;
//! let axes = |x| Vector::new(x, x, x);
//! let term = Flicker::new(axes(1e-3), timing)?;
//! let mut state = term.start(Streams::new(1, 0));
//! let truth = Vector::new(0.02_f64, 0.0, 0.0);
//! let stimulus = Stimulus { sensed: truth, velocity_b: Vector::new(0.0, 0.0, -0.098) };
//! let mut reading = Reading::new(truth);
//! term.apply(&mut state, &stimulus, &mut reading);
//! assert!((reading.increment - truth).norm() < 1e-3);
//! # Ok::<(), schuler::sensor::parameter::ParameterError>(())
//! ```

use super::gauss_markov::Process;
use super::parameter::{Parameter, ParameterError};
use super::{ErrorTerm, Reading, Stimulus, Timing};
use crate::math::vector::Vector;
use crate::noise::random::{Axes, Random};
use crate::noise::{Deviate, Streams};
use crate::record::{Record, record};

/// The number of decades of a 64-bit count of samples.
const DECADES: usize = 20;

/// σ_i/B = √(ln 10/π).
const POLE: f64 = 0.856_116_580_191_873;

/// Bias instability. Its Allan variance is (2 ln2/π)B²; the deviation is within 4 % of that from ten
/// samples to a twentieth of the run.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Flicker<R> {
    instability: Vector<R>,
    poles: [Option<Process<R>>; DECADES],
}

/// The parts of the bias and their random numbers.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FlickerState<R: Random> {
    /// Each pole's share of the bias at the end of the last sample, in units of B.
    parts: [Vector<R>; DECADES],
    streams: Axes<R>,
}

/// The poles of a run: their correlation times, s, in rising order, and the rms of each over B.
pub fn poles<R: Deviate>(timing: Timing<R>) -> impl Iterator<Item = (R, R)> {
    let longest = timing.samples();
    let mut next = Some((1u64, timing.interval_s()));
    core::iter::from_fn(move || {
        let (samples, correlation_s) = next.filter(|&(samples, _)| samples <= longest)?;
        next = samples.checked_mul(10).map(|n| (n, correlation_s * R::of(10.0)));
        Some((correlation_s, R::of(POLE)))
    })
}

impl<R: Deviate> Flicker<R> {
    /// From B of each axis, angle/s.
    ///
    /// # Errors
    ///
    /// [`ParameterError`] if a number is negative or not finite.
    pub fn new(instability: Vector<R>, timing: Timing<R>) -> Result<Self, ParameterError> {
        let instability = Parameter::BiasInstability.magnitude(instability)?;
        let mut table = [None; DECADES];
        for (entry, (correlation_s, rms)) in table.iter_mut().zip(poles(timing)) {
            let process = Process::new(rms, correlation_s, timing.interval_s());
            Parameter::BiasInstability.computed(instability * process.extent())?;
            *entry = Some(process);
        }
        Ok(Self { instability, poles: table })
    }
}

impl<R: Copy> Flicker<R> {
    /// The same term in numbers of another type, as `number` makes them from these.
    pub fn map<T>(&self, number: impl Fn(R) -> T) -> Flicker<T> {
        Flicker {
            instability: self.instability.map(&number),
            poles: self.poles.map(|process| process.map(|process| process.map(&number))),
        }
    }
}

impl<R: Random> ErrorTerm<R> for Flicker<R> {
    type State = FlickerState<R>;

    #[inline]
    fn start(&self, streams: Streams) -> FlickerState<R> {
        let mut streams = Axes::open(streams);
        let mut parts = [Vector::ZERO; DECADES];
        for (part, process) in parts.iter_mut().zip(self.poles.iter().flatten()) {
            for (value, stream) in part.each_mut().into_iter().zip(streams.each_mut()) {
                *value = process.start(stream);
            }
        }
        FlickerState { parts, streams }
    }

    #[inline(always)]
    fn apply(&self, state: &mut Self::State, _: &Stimulus<R>, reading: &mut Reading<R>) {
        let mut sum = Vector::ZERO;
        for (part, process) in state.parts.iter_mut().zip(self.poles.iter().flatten()) {
            let [x, y, z] = state.streams.each_mut();
            let integral = Vector {
                x: process.advance(&mut part.x, x),
                y: process.advance(&mut part.y, y),
                z: process.advance(&mut part.z, z),
            };
            sum = sum + integral;
        }
        reading.increment = reading.increment + self.instability.times(sum);
    }
}

impl<R: Random> Record for FlickerState<R> {
    record!(parts, streams);
}
