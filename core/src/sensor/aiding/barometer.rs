//! A barometer: heights with a bias that wanders with the weather.
//!
//! ```
//! use schuler::aiding::aided::instant::Instant;
//! use schuler::math::vector::Vector;
//! use schuler::sensor::aiding::barometer::Barometer;
//! use schuler::sensor::aiding::line::Line;
//! use schuler::sensor::aiding::truth::Truth;
//! use schuler::solution::{Euler, Solution};
//!
//! let barometer = Barometer::new(Line::every(0.1_f64), 0.3, 10.0, 600.0).checked()?;
//! let mut state = barometer.start(1, 0);
//! let solution = Solution::new(Default::default(), Vector::ZERO, Euler::default());
//! let truth = Truth::of(&solution, Vector::ZERO);
//! let mut heights = (0..10).map(|k| {
//!     let heard = barometer.measure(&mut state, &truth, Instant::of_sample(10 * k)).unwrap();
//!     heard.measured.position.altitude.hi
//! });
//! // The bias is the same over a second, but for 10√(2·1/600).
//! let first = heights.next().unwrap();
//! assert!(heights.all(|height| (height - first).abs() < 6.0));
//! # Ok::<(), schuler::sensor::parameter::ParameterError>(())
//! ```

use super::line::{Delivered, Line, LineState};
use super::truth::Truth;
use crate::aiding::aided::instant::Instant;
use crate::aiding::aided::measured::Measured;
use crate::math::compensated::Pair;
use crate::math::vector::Vector;
use crate::noise::{Deviate, Stream, Streams};
use crate::record::{Record, record};
use crate::sensor::gauss_markov::Process;
use crate::sensor::parameter::{Parameter, ParameterError};

/// A barometer.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Barometer<R> {
    /// When it measures, and when that arrives.
    pub line: Line<R>,
    /// From the inertial unit to its port, body axes, m.
    pub lever_b: Vector<R>,
    /// Standard deviation of its white noise, m.
    pub white_m: R,
    /// Rms of its bias, a Gauss-Markov process, m.
    pub bias_m: R,
    /// The bias's correlation time, s.
    pub correlation_s: R,
    /// What it claims its white noise to be, m.
    pub sigma_m: R,
}

/// The state of a barometer.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BarometerState<R> {
    /// Its epochs.
    pub line: LineState,
    /// The bias of the next measurement, m.
    pub bias_m: R,
    white: Stream,
    bias: Stream,
}

impl<R: Deviate> Barometer<R> {
    /// The branch of its random numbers.
    const BRANCH: u64 = 1;

    /// At the inertial unit, with the white noise that it claims.
    pub fn new(line: Line<R>, white_m: R, bias_m: R, correlation_s: R) -> Self {
        let (lever_b, sigma_m) = (Vector::ZERO, white_m);
        Self { line, lever_b, white_m, bias_m, correlation_s, sigma_m }
    }

    /// The same, checked.
    ///
    /// # Errors
    ///
    /// [`ParameterError`] for the first parameter that is out of range.
    pub fn checked(self) -> Result<Self, ParameterError> {
        self.line.checked()?;
        Parameter::LeverArm.signed(self.lever_b)?;
        Parameter::MeasurementNoise.size(self.white_m)?;
        Parameter::GaussMarkovRms.size(self.bias_m)?;
        Parameter::CorrelationTime.single(self.correlation_s)?;
        Parameter::ClaimedSigma.single(self.sigma_m)?;
        Ok(self)
    }

    /// The bias over the time from one measurement to the next.
    fn process(&self) -> Process<R> {
        Process::new(self.bias_m, self.correlation_s, self.line.interval_s)
    }

    /// Before the first measurement of a run.
    pub fn start(&self, seed: u64, run: u64) -> BarometerState<R> {
        let streams = Streams::new(seed, run).branch(Streams::AIDING).branch(Self::BRANCH);
        let mut bias = streams.branch(2).open();
        BarometerState {
            line: self.line.start(streams.branch(0)),
            bias_m: self.process().start(&mut bias),
            white: streams.branch(1).open(),
            bias,
        }
    }

    /// The next measurement, as of a [receiver](super::gnss::Gnss::measure).
    pub fn measure(
        &self,
        state: &mut BarometerState<R>,
        truth: &Truth<R>,
        at: Instant<R>,
    ) -> Option<Delivered<R>> {
        let next = self.line.next(&mut state.line);
        let error = state.bias_m + self.white_m * state.white.normal();
        self.process().advance(&mut state.bias_m, &mut state.bias);
        let (_, (arrives_s, again_s)) = next?;
        let below = (truth.body_to_ned * self.lever_b).z;
        let altitude = truth.position.altitude + Pair::new(error - below);
        let measured = Measured::height(at, altitude, self.sigma_m);
        Some(Delivered { measured, arrives_s, again_s })
    }
}

impl<R: Record> Record for BarometerState<R> {
    record!(line, bias_m, white, bias);
}
