//! Checks of a navigator's state that was restored from bytes.

use super::{State, Strapdown};
use crate::math::real::Real;
use crate::strapdown::block::window::Window;
use crate::strapdown::frame::Frame;
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
        let sound = state.filled <= samples.len()
            && state.filled.checked_sub(state.pending).is_some_and(|past| can_wait(state, past))
            && state.integrated <= MOST_COUNTED
            && state.seeded <= W::BLOCK
            // 0 also after a correction, until the next block.
            && (state.seeded == 0 || state.integrated != 0)
            && samples.iter().all(|sample| self.gate.admit(sample).is_ok())
            && state.frame.is_plausible();
        if sound { Ok(()) } else { Err(Damaged) }
    }
}

/// Whether this number of samples can be stored and pending between two samples.
fn can_wait<F: Frame, W: Window>(state: &State<F, W>, past: usize) -> bool {
    let few = if past < W::HISTORY {
        // The first block waits for its window.
        state.filled < W::FIRST
    } else {
        state.pending < W::BLOCK + W::LOOKAHEAD
    };
    few && past as u64 <= state.integrated
}
