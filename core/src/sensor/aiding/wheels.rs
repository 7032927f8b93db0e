//! Wheels: they neither slip sideways nor leave the ground. No number is measured.
//!
//! ```
//! use schuler::aiding::aided::instant::Instant;
//! use schuler::sensor::aiding::line::Line;
//! use schuler::sensor::aiding::wheels::Wheels;
//!
//! let wheels = Wheels::new(Line::every(0.5_f64), 0.1).checked()?;
//! let mut state = wheels.start(1, 0);
//! let said = wheels.measure(&mut state, Instant::of_sample(50)).unwrap();
//! assert_eq!((said.measured.degrees(), said.arrives_s), (2, 0.5));
//! # Ok::<(), schuler::sensor::parameter::ParameterError>(())
//! ```

use super::line::{Delivered, Line, LineState};
use crate::aiding::aided::instant::Instant;
use crate::aiding::aided::measured::Measured;
use crate::noise::{Deviate, Streams};
use crate::record::{Record, record};
use crate::sensor::parameter::{Parameter, ParameterError};

/// Says that the vehicle moves neither to its right nor downwards.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Wheels<R> {
    /// When it is said, and when that arrives.
    pub line: Line<R>,
    /// To within what, m/s per axis.
    pub sigma: R,
}

/// Its state.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct WheelsState {
    /// Its epochs.
    pub line: LineState,
}

impl<R: Deviate> Wheels<R> {
    /// The branch of its random numbers.
    const BRANCH: u64 = 4;

    /// To within a standard deviation, m/s.
    pub const fn new(line: Line<R>, sigma: R) -> Self {
        Self { line, sigma }
    }

    /// The same, checked.
    ///
    /// # Errors
    ///
    /// [`ParameterError`] for the first parameter that is out of range.
    pub fn checked(self) -> Result<Self, ParameterError> {
        self.line.checked()?;
        Parameter::ClaimedSigma.single(self.sigma)?;
        Ok(self)
    }

    /// Before the first measurement of a run.
    pub fn start(&self, seed: u64, run: u64) -> WheelsState {
        let streams = Streams::new(seed, run).branch(Streams::AIDING).branch(Self::BRANCH);
        WheelsState { line: self.line.start(streams.branch(0)) }
    }

    /// The next one; `at` is its time in samples of the inertial unit.
    pub fn measure(&self, state: &mut WheelsState, at: Instant<R>) -> Option<Delivered<R>> {
        let (_, (arrives_s, again_s)) = self.line.next(&mut state.line)?;
        Some(Delivered { measured: Measured::non_holonomic(at, self.sigma), arrives_s, again_s })
    }
}

impl Record for WheelsState {
    record!(line);
}
