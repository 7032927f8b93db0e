//! Something that knows when the vehicle stands still: a brake, a berth, a driver.
//!
//! What the samples of an inertial unit say of that is in [`standstill`](crate::aiding::standstill).
//!
//! ```
//! use schuler::aiding::aided::instant::Instant;
//! use schuler::math::vector::Vector;
//! use schuler::sensor::aiding::line::Line;
//! use schuler::sensor::aiding::still::Still;
//! use schuler::sensor::aiding::truth::Truth;
//! use schuler::solution::{Euler, Solution};
//!
//! let still = Still::new(Line::every(1.0_f64), 0.01).checked()?;
//! let mut state = still.start(1, 0);
//! let mut heard = |speed| {
//!     let velocity = Vector::new(speed, 0.0, 0.0);
//!     let solution = Solution::new(Default::default(), velocity, Euler::default());
//!     let truth = Truth::of(&solution, Vector::ZERO);
//!     still.measure(&mut state, &truth, Instant::of_sample(1)).is_some()
//! };
//! assert!(heard(0.0) && !heard(3.0));
//! # Ok::<(), schuler::sensor::parameter::ParameterError>(())
//! ```

use super::line::{Delivered, Line, LineState};
use super::truth::Truth;
use crate::aiding::aided::instant::Instant;
use crate::aiding::aided::measured::Measured;
use crate::noise::{Deviate, Streams};
use crate::record::{Record, record};
use crate::sensor::parameter::{Parameter, ParameterError};

/// The slowest motion that is seen, m/s.
const SLOWEST: f64 = 1e-3;

/// Says that the vehicle stands still.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Still<R> {
    /// When it looks, and when that arrives.
    pub line: Line<R>,
    /// The fastest motion that it takes for none, m/s.
    pub limit: R,
    /// What it claims, m/s per axis.
    pub sigma: R,
}

/// Its state.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct StillState {
    /// Its epochs.
    pub line: LineState,
}

impl<R: Deviate> Still<R> {
    /// The branch of its random numbers.
    const BRANCH: u64 = 3;

    /// Sees anything above 1 mm/s.
    pub fn new(line: Line<R>, sigma: R) -> Self {
        Self { line, limit: R::of(SLOWEST), sigma }
    }

    /// The same, checked.
    ///
    /// # Errors
    ///
    /// [`ParameterError`] for the first parameter that is out of range.
    pub fn checked(self) -> Result<Self, ParameterError> {
        self.line.checked()?;
        Parameter::SpeedLimit.size(self.limit)?;
        Parameter::ClaimedSigma.single(self.sigma)?;
        Ok(self)
    }

    /// Before the first measurement of a run.
    pub fn start(&self, seed: u64, run: u64) -> StillState {
        let streams = Streams::new(seed, run).branch(Streams::AIDING).branch(Self::BRANCH);
        StillState { line: self.line.start(streams.branch(0)) }
    }

    /// The next measurement, as of a [receiver](super::gnss::Gnss::measure); nothing while the vehicle moves.
    pub fn measure(
        &self,
        state: &mut StillState,
        truth: &Truth<R>,
        at: Instant<R>,
    ) -> Option<Delivered<R>> {
        let (_, (arrives_s, again_s)) = self.line.next(&mut state.line)?;
        if truth.velocity_ned.norm() > self.limit {
            return None;
        }
        let measured = Measured::zero_velocity(at, self.sigma);
        Some(Delivered { measured, arrives_s, again_s })
    }
}

impl Record for StillState {
    record!(line);
}
