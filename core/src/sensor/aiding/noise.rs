//! Noise of a vector that is measured from time to time: white, and a Gauss-Markov process beside it.
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::noise::Streams;
//! use schuler::sensor::aiding::noise::VectorNoise;
//!
//! let noise = VectorNoise::white(Vector::new(1.0_f64, 1.0, 2.0));
//! let mut state = noise.start(1.0, Streams::new(1, 0));
//! assert!(noise.next(1.0, &mut state).norm() < 20.0);
//! ```

use crate::math::vector::Vector;
use crate::noise::random::{Axes, Random};
use crate::noise::{Deviate, Streams};
use crate::record::{Record, record};
use crate::sensor::gauss_markov::Process;
use crate::sensor::parameter::{Parameter, ParameterError};

/// Noise of a vector.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct VectorNoise<R> {
    /// Standard deviation of the white part per axis.
    pub white: Vector<R>,
    /// Rms of the correlated part per axis.
    pub correlated: Vector<R>,
    /// Its correlation time, s.
    pub correlation_s: R,
}

/// The correlated part, and random numbers.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct VectorNoiseState<R: Random> {
    /// The correlated part at the last measurement.
    pub correlated: Vector<R>,
    white_streams: Axes<R>,
    correlated_streams: Axes<R>,
}

impl<R: Deviate> VectorNoise<R> {
    /// White noise alone.
    pub fn white(white: Vector<R>) -> Self {
        Self { white, correlated: Vector::ZERO, correlation_s: R::ONE }
    }

    /// The same, checked.
    ///
    /// # Errors
    ///
    /// [`ParameterError`] if a size is negative or not finite, or the correlation time is not positive.
    pub fn checked(self) -> Result<Self, ParameterError> {
        Parameter::MeasurementNoise.magnitude(self.white)?;
        Parameter::GaussMarkovRms.magnitude(self.correlated)?;
        Parameter::CorrelationTime.single(self.correlation_s)?;
        Ok(self)
    }

    /// The process of each axis over an interval, s.
    fn processes(&self, interval_s: R) -> [Process<R>; 3] {
        self.correlated.into_array().map(|rms| Process::new(rms, self.correlation_s, interval_s))
    }

    /// Before the first measurement; `interval_s` is the time from one to the next.
    pub fn start(&self, interval_s: R, streams: Streams) -> VectorNoiseState<R> {
        let mut state = VectorNoiseState {
            correlated: Vector::ZERO,
            white_streams: Axes::open(streams.branch(0)),
            correlated_streams: Axes::open(streams.branch(1)),
        };
        let VectorNoiseState { correlated, correlated_streams, .. } = &mut state;
        let axes = correlated.each_mut().into_iter().zip(correlated_streams.each_mut());
        for ((value, stream), process) in axes.zip(self.processes(interval_s)) {
            *value = process.start(stream);
        }
        state
    }

    /// The noise of the next measurement.
    pub fn next(&self, interval_s: R, state: &mut VectorNoiseState<R>) -> Vector<R> {
        let VectorNoiseState { correlated, white_streams, correlated_streams } = state;
        let noise = *correlated + self.white.times(white_streams.normal());
        let axes = correlated.each_mut().into_iter().zip(correlated_streams.each_mut());
        for ((value, stream), process) in axes.zip(self.processes(interval_s)) {
            process.advance(value, stream);
        }
        noise
    }
}

impl<R: Random> Record for VectorNoiseState<R> {
    record!(correlated, white_streams, correlated_streams);
}
