//! The trait of all mechanizations: how they are started, fed and read.
//!
//! ```
//! use schuler::sample::Increment;
//! use schuler::strapdown::limits::Rejected;
//! use schuler::strapdown::mechanization::Mechanization;
//!
//! /// Flies samples with any mechanization.
//! fn fly<M: Mechanization>(
//!     mechanization: &M,
//!     state: &mut M::State,
//!     samples: &[Increment<M::Real>],
//! ) -> Result<M::Output, Rejected> {
//!     for &sample in samples {
//!         mechanization.push(state, sample)?;
//!     }
//!     mechanization.finish(state);
//!     Ok(mechanization.output(state))
//! }
//! ```

use crate::math::compensated::Pair;
use crate::math::real::Real;
use crate::output::Output;
use crate::readout::Readout;
use crate::sample::Increment;
use crate::solution::Solution;
use crate::strapdown::block::newton::Edges;
use crate::strapdown::correction::{Correction, CorrectionError};
use crate::strapdown::limits::{Rejected, StartError};
use crate::strapdown::plausible::Damaged;

/// A mechanization: a configuration that carries a state from sample to sample.
pub trait Mechanization {
    /// The scalar it computes in.
    type Real: Real;
    /// The part of the state that belongs to the navigation frame: position, velocity, attitude and gravity.
    type Frame: Copy;
    /// The whole state.
    type State: Copy + Send;
    /// The form of its solution.
    type Output: Output<Self::Real>;
    /// The body's motion over one of its steps.
    type Body: Copy;

    /// Starts from an initial solution.
    ///
    /// # Errors
    ///
    /// [`StartError`] if the initial solution is out of range, or navigation cannot start at its place.
    fn start(&self, initial: &Solution<Self::Real>) -> Result<Self::State, StartError>;
    /// Takes a sample, without reading rows.
    ///
    /// # Errors
    ///
    /// [`Rejected`] if the sample is refused. The state is then unchanged.
    fn push(&self, state: &mut Self::State, sample: Increment<Self::Real>) -> Result<(), Rejected>;
    /// Takes a sample and reads the rows that it completes: the number of samples up to each row, and the
    /// solution there.
    ///
    /// # Errors
    ///
    /// [`Rejected`] if the sample is refused. The state is then unchanged.
    fn push_rows(
        &self,
        state: &mut Self::State,
        sample: Increment<Self::Real>,
        read: impl FnMut(u64, Self::Output),
    ) -> Result<(), Rejected>;
    /// Integrates the samples that wait for look-ahead, without reading rows.
    fn finish(&self, state: &mut Self::State);
    /// Completes the rows that wait for look-ahead, and reads them.
    fn finish_rows(&self, state: &mut Self::State, read: impl FnMut(u64, Self::Output));
    /// Takes a sample and shows every step that it completes: the number of samples at its end, the
    /// body's motion over it, and the frame after it. This is what an audit records.
    ///
    /// # Errors
    ///
    /// [`Rejected`] if the sample is refused. The state is then unchanged.
    fn push_blocks(
        &self,
        state: &mut Self::State,
        sample: Increment<Self::Real>,
        see: impl FnMut(u64, &Self::Body, &Self::Frame),
    ) -> Result<(), Rejected>;
    /// Completes the steps that wait for look-ahead, and shows them.
    fn finish_blocks(
        &self,
        state: &mut Self::State,
        see: impl FnMut(u64, &Self::Body, &Self::Frame),
    );
    /// Sets height (m) and vertical velocity (down, m/s), as an altimeter would.
    ///
    /// # Errors
    ///
    /// [`Rejected::Held`] if a number is out of range. The state is then unchanged.
    fn hold_vertical(
        &self,
        state: &mut Self::State,
        altitude: Self::Real,
        down: Self::Real,
    ) -> Result<(), Rejected>;
    /// Corrects the state at the end of the last block, the one that [`Mechanization::output`] shows; what
    /// waits for the next block is integrated from there. A correction of zero leaves every bit.
    ///
    /// # Errors
    ///
    /// Where it is not finite or too large, where local-level axes end, or where it leads too far up or
    /// down. The state is as it was then, bit for bit.
    fn correct(
        &self,
        state: &mut Self::State,
        correction: &Correction<Self::Real>,
    ) -> Result<(), CorrectionError>;
    /// Checks whether a restored state can be a state of this navigator. Call it for every state that was
    /// written back, before navigation continues.
    ///
    /// # Errors
    ///
    /// [`Damaged`] if it cannot.
    fn check(&self, state: &Self::State) -> Result<(), Damaged>;
    /// The part of a state that belongs to the frame.
    fn frame(state: &Self::State) -> &Self::Frame;
    /// The number of samples integrated.
    fn integrated(state: &Self::State) -> u64;
    /// The number of samples that first and last blocks were fitted to; `None` if there is no fit.
    fn edges(_: &Self::State) -> Option<Edges<Self::Real>> {
        None
    }
    /// The solution at the end of the last step.
    fn output(&self, state: &Self::State) -> Self::Output;
    /// The same as plain numbers: degrees, metres and m/s.
    fn readout(&self, state: &Self::State) -> Readout<Self::Real> {
        self.output(state).readout()
    }
}

/// A mechanization that takes samples of any length.
pub trait UnequalIntervals: Mechanization {
    /// Takes a sample with its own interval in seconds, above 0 s and at most 1 s, without reading rows.
    ///
    /// # Errors
    ///
    /// [`Rejected`] if the sample or its interval is refused. The state is then unchanged.
    fn push_over(
        &self,
        state: &mut Self::State,
        sample: Increment<Self::Real>,
        interval_s: Pair<Self::Real>,
    ) -> Result<(), Rejected>;
    /// The same, reading the rows that it completes.
    ///
    /// # Errors
    ///
    /// [`Rejected`] if the sample or its interval is refused. The state is then unchanged.
    fn push_rows_over(
        &self,
        state: &mut Self::State,
        sample: Increment<Self::Real>,
        interval_s: Pair<Self::Real>,
        read: impl FnMut(u64, Self::Output),
    ) -> Result<(), Rejected>;
    /// The same, showing every step that it completes.
    ///
    /// # Errors
    ///
    /// [`Rejected`] if the sample or its interval is refused. The state is then unchanged.
    fn push_blocks_over(
        &self,
        state: &mut Self::State,
        sample: Increment<Self::Real>,
        interval_s: Pair<Self::Real>,
        see: impl FnMut(u64, &Self::Body, &Self::Frame),
    ) -> Result<(), Rejected>;
}
