//! What every mechanization has in common: how it is started and fed, and why it refuses.

use crate::math::compensated::Pair;
use crate::math::real::Real;
use crate::readout::Readout;
use crate::sample::Increment;
use crate::solution::Output;
use crate::solution::Solution;
use crate::strapdown::block::newton::Edges;
use crate::strapdown::correction::{Correction, CorrectionError};
use crate::strapdown::limits::{Rejected, StartError};
use crate::strapdown::plausible::Damaged;

/// A mechanization: a configuration that carries a state from sample to sample.
pub trait Mechanization {
    /// The scalar it computes in.
    type Real: Real;
    /// The frame's share of the state: what navigation stands at.
    type Frame: Copy;
    /// What goes on from sample to sample.
    type State: Copy;
    /// What it prints.
    type Output: Output<Self::Real>;
    /// The body's motion over one of its steps.
    type Body: Copy;

    /// Starts from an initial solution.
    fn start(&self, initial: &Solution<Self::Real>) -> Result<Self::State, StartError>;
    /// Takes a sample; no row is read.
    fn push(&self, state: &mut Self::State, sample: Increment<Self::Real>) -> Result<(), Rejected>;
    /// Takes a sample and reads the rows that it completes: the number of samples up to each, and the
    /// navigation there.
    fn push_rows(
        &self,
        state: &mut Self::State,
        sample: Increment<Self::Real>,
        read: impl FnMut(u64, Self::Output),
    ) -> Result<(), Rejected>;
    /// Integrates what waits for samples; no row is read.
    fn finish(&self, state: &mut Self::State);
    /// Completes the rows that wait for samples, and reads them.
    fn finish_rows(&self, state: &mut Self::State, read: impl FnMut(u64, Self::Output));
    /// Takes a sample and shows every step that it completes: the number of samples at its end, the
    /// body's motion over it, and the frame after it. What an audit records.
    fn push_blocks(
        &self,
        state: &mut Self::State,
        sample: Increment<Self::Real>,
        see: impl FnMut(u64, &Self::Body, &Self::Frame),
    ) -> Result<(), Rejected>;
    /// Completes the steps that wait for samples, and shows them.
    fn finish_blocks(
        &self,
        state: &mut Self::State,
        see: impl FnMut(u64, &Self::Body, &Self::Frame),
    );
    /// Sets height (m) and vertical velocity (down, m/s), as an altimeter would.
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
    /// Whether a state can be one that navigation left: asked of every state that was written back, before
    /// it goes on.
    fn check(&self, state: &Self::State) -> Result<(), Damaged>;
    /// The frame's share of a state.
    fn frame(state: &Self::State) -> &Self::Frame;
    /// How many samples it has integrated.
    fn integrated(state: &Self::State) -> u64;
    /// Samples that the blocks at the edges were fitted through; `None` where no fit is made.
    fn edges(_: &Self::State) -> Option<Edges<Self::Real>> {
        None
    }
    /// The navigation that the state stands at.
    fn output(&self, state: &Self::State) -> Self::Output;
    /// The same as plain numbers: degrees, metres and m/s.
    fn readout(&self, state: &Self::State) -> Readout<Self::Real> {
        self.output(state).readout()
    }
}

/// A mechanization that takes samples of any length.
pub trait UnequalIntervals: Mechanization {
    /// Takes a sample of its own interval in seconds, above 0 s and at most 1 s; no row is read.
    fn push_over(
        &self,
        state: &mut Self::State,
        sample: Increment<Self::Real>,
        interval_s: Pair<Self::Real>,
    ) -> Result<(), Rejected>;
    /// The same, reading the rows that it completes.
    fn push_rows_over(
        &self,
        state: &mut Self::State,
        sample: Increment<Self::Real>,
        interval_s: Pair<Self::Real>,
        read: impl FnMut(u64, Self::Output),
    ) -> Result<(), Rejected>;
    /// The same, showing every step that it completes.
    fn push_blocks_over(
        &self,
        state: &mut Self::State,
        sample: Increment<Self::Real>,
        interval_s: Pair<Self::Real>,
        see: impl FnMut(u64, &Self::Body, &Self::Frame),
    ) -> Result<(), Rejected>;
}
