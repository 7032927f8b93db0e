//! An odometer: the speed along the vehicle, with an error of scale, noise and the steps of its counter.
//!
//! ```
//! use schuler::sensor::aiding::line::Line;
//! use schuler::sensor::aiding::odometer::Odometer;
//!
//! let odometer = Odometer { scale: 0.01, ..Odometer::new(Line::every(0.1_f64), 0.05) };
//! assert!(odometer.checked().is_ok());
//! assert!(Odometer { quantum: f64::NAN, ..odometer }.checked().is_err());
//! ```

use super::line::{Delivered, Line, LineState};
use super::truth::Truth;
use crate::aiding::aided::instant::Instant;
use crate::aiding::aided::measured::Measured;
use crate::math::vector::Vector;
use crate::noise::{Deviate, Stream, Streams};
use crate::record::{Record, record};
use crate::sensor::parameter::{Parameter, ParameterError};

/// An odometer.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Odometer<R> {
    /// When it measures, and when that arrives.
    pub line: Line<R>,
    /// From the inertial unit to where the wheels do not slip sideways, body axes, m.
    pub lever_b: Vector<R>,
    /// Standard deviation of its white noise, m/s.
    pub white: R,
    /// Its error of scale; 1e-3 reads 0.1 % too much.
    pub scale: R,
    /// The rms over runs of a further error of scale, which is constant during a run.
    pub scale_rms: R,
    /// The step of its reading, m/s; 0 for none.
    pub quantum: R,
    /// What it claims to be good for, m/s.
    pub sigma: R,
}

/// The state of an odometer.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct OdometerState<R> {
    /// Its epochs.
    pub line: LineState,
    /// The error of scale in this run.
    pub scale: R,
    white: Stream,
}

impl<R: Deviate> Odometer<R> {
    /// The branch of its random numbers.
    const BRANCH: u64 = 2;

    /// At the inertial unit, with the white noise that it claims.
    pub fn new(line: Line<R>, white: R) -> Self {
        Self {
            line,
            lever_b: Vector::ZERO,
            white,
            scale: R::ZERO,
            scale_rms: R::ZERO,
            quantum: R::ZERO,
            sigma: white,
        }
    }

    /// The same, checked.
    ///
    /// # Errors
    ///
    /// [`ParameterError`] for the first parameter that is out of range.
    pub fn checked(self) -> Result<Self, ParameterError> {
        self.line.checked()?;
        Parameter::LeverArm.signed(self.lever_b)?;
        Parameter::MeasurementNoise.size(self.white)?;
        Parameter::ScaleFactor.number(self.scale)?;
        Parameter::ScaleFactor.size(self.scale_rms)?;
        Parameter::Quantization.size(self.quantum)?;
        Parameter::ClaimedSigma.single(self.sigma)?;
        Ok(self)
    }

    /// Before the first measurement of a run.
    pub fn start(&self, seed: u64, run: u64) -> OdometerState<R> {
        let streams = Streams::new(seed, run).branch(Streams::AIDING).branch(Self::BRANCH);
        let drawn: R = streams.branch(2).open().normal();
        OdometerState {
            line: self.line.start(streams.branch(0)),
            scale: self.scale + self.scale_rms * drawn,
            white: streams.branch(1).open(),
        }
    }

    /// The next measurement, as of a [receiver](super::gnss::Gnss::measure).
    pub fn measure(
        &self,
        state: &mut OdometerState<R>,
        truth: &Truth<R>,
        at: Instant<R>,
    ) -> Option<Delivered<R>> {
        let next = self.line.next(&mut state.line);
        let noise = self.white * state.white.normal();
        let (_, (arrives_s, again_s)) = next?;
        let mut speed = truth.velocity_b_at(self.lever_b).x * (R::ONE + state.scale) + noise;
        if self.quantum > R::ZERO {
            speed = (speed / self.quantum).round() * self.quantum;
        }
        let measured = Measured::speed(at, speed, self.sigma);
        Some(Delivered { measured, arrives_s, again_s })
    }
}

impl<R: Record> Record for OdometerState<R> {
    record!(line, scale, white);
}
