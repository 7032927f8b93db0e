//! A running state corrected, at the end of its last block.

use super::stream::Progress;
use super::{State, Strapdown};
use crate::math::real::Real;
use crate::strapdown::block::intervals::Intervals;
use crate::strapdown::block::window::Window;
use crate::strapdown::correction::{Correction, CorrectionError};
use crate::strapdown::frame::Frame;

impl<R: Real, F: Frame<Real = R>, W: Window> Strapdown<F, W> {
    /// Corrects position, velocity and attitude at the point of [`State::output`]. Pending samples are integrated
    /// from there. A correction of zero changes no bit.
    ///
    /// # Errors
    ///
    /// As of [`Mechanization::correct`](crate::strapdown::mechanization::Mechanization::correct), with the
    /// state as it was.
    pub fn correct(
        &self,
        state: &mut State<F, W>,
        correction: &Correction<R>,
    ) -> Result<(), CorrectionError> {
        apply(correction, &mut state.frame, &mut state.progress, &mut state.intervals)
    }
}

/// Corrects the parts of a state.
pub(super) fn apply<R: Real, F: Frame<Real = R>>(
    correction: &Correction<R>,
    frame: &mut F,
    progress: &mut Progress<R>,
    intervals: &mut impl Intervals<R>,
) -> Result<(), CorrectionError> {
    correction.apply(frame, F::correct)?;
    if correction.moves() {
        // The gravity history belongs to another path: the next block sets it up again.
        progress.seeded = 0;
        intervals.forget_history();
    }
    Ok(())
}
