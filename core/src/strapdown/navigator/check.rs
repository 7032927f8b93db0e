//! Checks of a navigator's state that was restored from bytes.

use super::stream::Progress;
use super::{State, Strapdown};
use crate::math::real::Real;
use crate::sample::Increment;
use crate::strapdown::block::any_window::Numbers;
use crate::strapdown::block::window::Window;
use crate::strapdown::frame::Frame;
use crate::strapdown::gate::Gate;
use crate::strapdown::plausible::{Damaged, MOST_COUNTED};

impl<R: Real, F: Frame<Real = R>, W: Window> Strapdown<F, W> {
    /// Checks whether a state can be a state of this navigator: its samples fit the room and are within the
    /// limits, the number of pending samples is possible between two samples, and the frame's fields are
    /// consistent.
    ///
    /// # Errors
    ///
    /// [`Damaged`] if it cannot.
    pub fn check(&self, state: &State<F, W>) -> Result<(), Damaged> {
        let samples = state.samples.as_ref();
        check(&state.frame, samples, &state.progress, &self.gate, &Numbers::of::<W>())
    }
}

/// Whether these can be parts of a state.
pub(super) fn check<F: Frame>(
    frame: &F,
    samples: &[Increment<F::Real>],
    progress: &Progress<F::Real>,
    gate: &Gate<F::Real>,
    window: &Numbers,
) -> Result<(), Damaged> {
    let &Progress { filled, pending, integrated, seeded, .. } = progress;
    let sound = filled <= window.stored
        && filled.checked_sub(pending).is_some_and(|past| can_wait(progress, past, window))
        && integrated <= MOST_COUNTED
        && seeded <= window.shape.block
        // 0 also after a correction, until the next block.
        && (seeded == 0 || integrated != 0)
        && samples.iter().all(|sample| gate.admit(sample).is_ok())
        && frame.is_plausible();
    if sound { Ok(()) } else { Err(Damaged) }
}

/// Whether this number of samples can be stored and pending between two samples.
fn can_wait<R>(progress: &Progress<R>, past: usize, window: &Numbers) -> bool {
    let few = if past < window.shape.history {
        // The first block waits for its window.
        progress.filled < window.first
    } else {
        progress.pending < window.shape.block + window.shape.lookahead
    };
    few && past as u64 <= progress.integrated
}
