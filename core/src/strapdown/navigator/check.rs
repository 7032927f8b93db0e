//! Whether a navigator's state that came back from bytes can be right.

use super::{State, Strapdown};
use crate::math::real::Real;
use crate::strapdown::block::window::Window;
use crate::strapdown::frame::Frame;
use crate::strapdown::plausible::{Damaged, MOST_COUNTED};

impl<R: Real, F: Frame<Real = R>, W: Window> Strapdown<F, W> {
    /// Whether a state can be one that this navigator left: its samples in the room for them and within the
    /// limits, as many pending as can be between two samples, its frame's fields in accord.
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

/// Whether so many samples can be kept and pending between two samples.
fn can_wait<F: Frame, W: Window>(state: &State<F, W>, past: usize) -> bool {
    let few = if past < W::HISTORY {
        // The first block waits for its window.
        state.filled < W::FIRST
    } else {
        state.pending < W::BLOCK + W::LOOKAHEAD
    };
    few && past as u64 <= state.integrated
}
