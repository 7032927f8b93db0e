//! A mechanization with its state and the digest of all its states.
//!
//! ```
//! use schuler::flight::flight::Flight;
//! use schuler::prelude::*;
//!
//! let level = Euler { roll: 0.0, pitch: 0.0, yaw: 0.0 };
//! let start = Solution::new(Geodetic::default(), Vector::ZERO, level);
//! let mut flight = Flight::new(Navigator4::<f64>::from_rate_hz(100.0)?, &start)?;
//! let before = flight.digest();
//! for _ in 0..4 {
//!     flight.push(Increment::ZERO)?;
//! }
//! // A block is complete, and its state is in the digest.
//! assert!(flight.integrated() == 4 && flight.digest() != before);
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```

use super::catalogue::Entry;
use crate::digest::Digest;
use crate::math::compensated::Pair;
use crate::record::{Record, record};
use crate::sample::Increment;
use crate::solution::Solution;
use crate::strapdown::limits::{Rejected, StartError};
use crate::strapdown::mechanization::Mechanization;
use crate::strapdown::plausible::Damaged;

/// A mechanization in flight.
///
/// The digest takes in the frame whenever a sample completes a block, and once more at the end. So two flights
/// through the same samples have the same digest. The [`Record`] of a flight has its state and its digest. A
/// flight that was restored from a record must be [checked](Flight::check) before it is used.
#[derive(Clone, Copy)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Flight<M: Mechanization> {
    mechanization: M,
    state: M::State,
    digest: Digest,
}

impl<M: Entry> Flight<M> {
    /// For samples of an interval in seconds, with a series of at most this order.
    pub fn start(
        interval_s: Pair<M::Real>,
        order: usize,
        initial: &Solution<M::Real>,
    ) -> Result<Self, StartError> {
        Self::new(M::configured(interval_s, order)?, initial)
    }
}

impl<M: Mechanization<Frame: Record>> Flight<M> {
    /// From an initial solution.
    pub fn new(mechanization: M, initial: &Solution<M::Real>) -> Result<Self, StartError> {
        let state = mechanization.start(initial)?;
        Ok(Self { mechanization, state, digest: Digest::default() })
    }

    /// Takes a sample.
    pub fn push(&mut self, sample: Increment<M::Real>) -> Result<(), Rejected> {
        self.push_by(sample, &mut M::push)
    }

    /// Takes a sample by a function: [`Mechanization::push`] or one that reads rows.
    #[inline]
    pub fn push_by<E>(
        &mut self,
        sample: Increment<M::Real>,
        push: &mut impl FnMut(&M, &mut M::State, Increment<M::Real>) -> Result<(), E>,
    ) -> Result<(), E> {
        step(&self.mechanization, &mut self.state, &mut self.digest, sample, push)
    }

    /// Ends the stream: integrates the pending samples by a function that may read rows.
    pub fn finish_by(&mut self, finish: impl FnOnce(&M, &mut M::State)) {
        finish(&self.mechanization, &mut self.state);
        self.digest.add(M::frame(&self.state));
    }

    /// Sets height (m) and vertical velocity (down, m/s).
    pub fn hold_vertical(&mut self, altitude: M::Real, down: M::Real) -> Result<(), Rejected> {
        self.mechanization.hold_vertical(&mut self.state, altitude, down)
    }

    /// Checks whether a restored flight can be valid. Call it before anything else.
    pub fn check(&self) -> Result<(), Damaged> {
        self.mechanization.check(&self.state)?;
        if self.digest.is_plausible() { Ok(()) } else { Err(Damaged) }
    }

    /// Mechanization and state, for a flight without the digest.
    pub fn parts_mut(&mut self) -> (&M, &mut M::State) {
        (&self.mechanization, &mut self.state)
    }

    /// The mechanization.
    pub fn mechanization(&self) -> &M {
        &self.mechanization
    }

    /// State of the mechanization.
    pub fn state(&self) -> &M::State {
        &self.state
    }

    /// The number of samples integrated so far.
    pub fn integrated(&self) -> u64 {
        M::integrated(&self.state)
    }

    /// Digest of every state so far.
    pub fn digest(&self) -> u64 {
        self.digest.value()
    }

    /// Navigation at the end of the last block.
    pub fn output(&self) -> M::Output {
        self.mechanization.output(&self.state)
    }
}

/// Passes one sample through the navigator. It is never inlined, so that an image contains it once.
#[inline(never)]
fn step<M: Mechanization<Frame: Record>, E>(
    mechanization: &M,
    state: &mut M::State,
    digest: &mut Digest,
    sample: Increment<M::Real>,
    push: &mut impl FnMut(&M, &mut M::State, Increment<M::Real>) -> Result<(), E>,
) -> Result<(), E> {
    let before = M::integrated(state);
    push(mechanization, state, sample)?;
    if M::integrated(state) != before {
        digest.add(M::frame(state));
    }
    Ok(())
}

/// The configuration is not part of the record.
impl<M: Mechanization<State: Record>> Record for Flight<M> {
    record!(state; digest);
}
