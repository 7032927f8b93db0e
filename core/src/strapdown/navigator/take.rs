//! Samples in: they are stored, and whenever a window is full, a block is integrated.

use super::rows::Read;
use super::{State, Strapdown};
use crate::math::real::Real;
use crate::sample::Increment;
use crate::strapdown::block::intervals::Intervals as _;
use crate::strapdown::block::window::Window;
use crate::strapdown::frame::Frame;
use crate::strapdown::limits::Rejected;

impl<R: Real, F: Frame<Real = R>, W: Window> Strapdown<F, W> {
    #[inline(always)]
    pub(super) fn take(
        &self,
        state: &mut State<F, W>,
        sample: Increment<R>,
        excess: R,
        read: &mut impl Read<F>,
    ) -> Result<(), Rejected> {
        // If a block ended at a place where navigation cannot continue, every following sample is refused.
        if state.pending <= W::LOOKAHEAD {
            state.frame.check_place()?;
        }
        self.store(state, sample, excess);
        let past = state.filled - state.pending;
        if past < W::HISTORY && state.filled < W::FIRST {
            return Ok(());
        }
        if !W::UNEQUAL {
            self.integrate_by(state, past, read);
        } else if past < W::HISTORY || state.pending >= W::BLOCK + W::LOOKAHEAD {
            self.integrate_any(state, past, read);
        }
        Ok(())
    }

    /// One copy of the code for all readers.
    #[inline(never)]
    fn integrate_any(&self, state: &mut State<F, W>, past: usize, read: &mut dyn Read<F>) {
        self.integrate_by(state, past, read);
    }

    /// Integrates the blocks that are complete; the first one needs no history.
    #[inline(always)]
    fn integrate_by<Q: Read<F> + ?Sized>(
        &self,
        state: &mut State<F, W>,
        past: usize,
        read: &mut Q,
    ) {
        if past < W::HISTORY {
            self.edge_block(state, past, W::BLOCK, W::FIRST, read);
        }
        while state.pending >= W::BLOCK + W::LOOKAHEAD {
            if W::UNEQUAL {
                self.any_block(state, read);
            } else {
                self.whole_block(state, read);
            }
        }
    }

    pub(super) fn end(&self, state: &mut State<F, W>, read: &mut impl Read<F>) {
        if W::UNEQUAL {
            self.last_blocks::<dyn Read<F>>(state, read);
        } else {
            self.last_blocks(state, read);
        }
    }

    /// Stores a sample, dropping the oldest ones a block at a time.
    #[inline(always)]
    #[expect(
        clippy::indexing_slicing,
        reason = "the loop ends at the length, and a copy in one call takes longer"
    )]
    fn store(&self, state: &mut State<F, W>, sample: Increment<R>, excess: R) {
        let samples = state.samples.as_mut();
        let kept = state.intervals.excess_mut();
        if state.filled >= samples.len() {
            // After an early `finish`, more than a block's length may still be pending.
            let drop = W::BLOCK.min(state.filled - state.pending);
            for from in drop..samples.len() {
                samples[from - drop] = samples[from];
            }
            if drop <= kept.len() {
                kept.copy_within(drop.., 0);
            }
            state.filled = samples.len() - drop;
        }
        if let Some(slot) = samples.get_mut(state.filled) {
            *slot = sample;
            if let Some(slot) = kept.get_mut(state.filled) {
                *slot = excess;
            }
            state.filled += 1;
            state.pending += 1;
        }
    }

    #[inline(always)]
    pub(super) fn whole_block<Q: Read<F> + ?Sized>(&self, state: &mut State<F, W>, read: &mut Q) {
        let end = state.filled - state.pending + W::BLOCK + W::LOOKAHEAD;
        let seen = state.samples.as_ref().get(..end).unwrap_or(&[]);
        let begin = self.begin(state, end);
        if W::LOOKAHEAD == 0 && W::HISTORY > 0 {
            if let Some((body, series, used)) =
                W::integrate_behind::<R>(seen, self.block.half, self.order, F::TWO_FLOAT)
            {
                state.edges.last = used;
                self.step::<false, _>(state, (&self.block, &[]), W::BLOCK, &body, &series, read);
            } else {
                self.edge_block(state, W::HISTORY, W::BLOCK, W::SAMPLES, read);
            }
        } else if let Some((body, series)) = W::integrate::<R>(
            seen.get(begin..).unwrap_or(&[]),
            self.block.half,
            self.order,
            F::TWO_FLOAT,
        ) {
            self.step::<false, _>(state, (&self.block, &[]), W::BLOCK, &body, &series, read);
        }
    }
}
