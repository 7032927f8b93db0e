//! Samples in: they are stored, and whenever a window is full, a block is integrated.

use super::rows::Read;
use super::stream::{Place, Room, Stream, store};
use super::{State, Strapdown};
use crate::math::real::Real;
use crate::sample::Increment;
use crate::strapdown::block::any_window::Known;
use crate::strapdown::block::intervals::Intervals as _;
use crate::strapdown::block::window::Window;
use crate::strapdown::frame::Frame;
use crate::strapdown::limits::Rejected;

impl<R: Real, F: Frame<Real = R>, W: Window> Strapdown<F, W> {
    /// Takes an admitted sample. Without `EDGES` the stream is beyond its first block.
    #[inline(always)]
    pub(super) fn take<const EDGES: bool>(
        &self,
        state: &mut State<F, W>,
        sample: Increment<R>,
        excess: R,
        read: &mut impl Read<F>,
    ) -> Result<(), Rejected> {
        if W::UNEQUAL {
            return self.take_any(state, sample, excess, read);
        }
        // If a block ended at a place where navigation cannot continue, every following sample is refused.
        if state.progress.pending <= W::LOOKAHEAD {
            state.frame.check_place()?;
        }
        store(state.samples.as_mut(), &mut state.progress, W::BLOCK, sample, drop_first);
        let past = state.progress.past();
        if EDGES && past < W::HISTORY {
            if state.progress.filled < W::FIRST {
                return Ok(());
            }
            // The first block needs no history.
            self.stream(state, &mut { R::ZERO }).edge_block(past, W::BLOCK, W::FIRST, read);
        }
        while state.progress.pending >= W::BLOCK + W::LOOKAHEAD {
            self.whole_block::<EDGES, _>(state, read);
        }
        Ok(())
    }

    fn take_any(
        &self,
        state: &mut State<F, W>,
        sample: Increment<R>,
        excess: R,
        read: &mut dyn Read<F>,
    ) -> Result<(), Rejected> {
        let window = Known(W::default());
        let (frame, progress, timing) = (&mut state.frame, &mut state.progress, &self.timing);
        let (samples, kept) = (state.samples.as_mut(), state.intervals.kept_mut());
        // A window for samples of any length keeps their intervals.
        kept.map_or(Ok(()), |(kept, history_s)| {
            let room = Room { frame, samples, excess: kept, progress, history_s, timing, window };
            room.take(sample, excess, read)
        })
    }

    /// Integrates all pending samples.
    pub(super) fn end(&self, state: &mut State<F, W>, read: &mut impl Read<F>) {
        if let Some((kept, history_s)) = state.intervals.kept_mut() {
            let window = Known(W::default());
            let (frame, progress, timing) = (&mut state.frame, &mut state.progress, &self.timing);
            let samples = state.samples.as_mut();
            let room = Room { frame, samples, excess: kept, progress, history_s, timing, window };
            room.finish(read);
        } else {
            self.stream(state, &mut { R::ZERO }).last_blocks(read);
        }
    }

    /// A stream whose samples all last the nominal interval.
    #[inline(always)]
    fn stream<'a>(
        &'a self,
        state: &'a mut State<F, W>,
        history_s: &'a mut R,
    ) -> Stream<'a, F, Known<W>, false> {
        let State { frame, samples, progress, .. } = state;
        let place = Place { frame, progress, history_s };
        let window = Known(W::default());
        Stream { place, samples: (*samples).as_ref(), excess: &[], timing: &self.timing, window }
    }

    #[inline(always)]
    fn whole_block<const EDGES: bool, Q: Read<F>>(&self, state: &mut State<F, W>, read: &mut Q) {
        let end = state.progress.filled - state.progress.pending + W::BLOCK + W::LOOKAHEAD;
        let seen = state.samples.as_ref().get(..end).unwrap_or(&[]);
        let (time, interval) = (&self.timing.block, self.timing.interval.hi);
        let (half, order) = (time.half, self.timing.order);
        let history_s = &mut { R::ZERO };
        if W::LOOKAHEAD == 0 && W::HISTORY > 0 {
            if let Some((body, series, used)) =
                W::integrate_behind::<R>(seen, half, order, F::TWO_FLOAT)
            {
                state.progress.edges.last = used;
                let mut place = self.stream(state, history_s).place;
                place.step::<false, _>((time, &[]), interval, W::BLOCK, &body, &series, read);
            } else if EDGES {
                self.stream(state, history_s).edge_block(W::HISTORY, W::BLOCK, W::SAMPLES, read);
            }
            return;
        }
        let begin = end - W::SAMPLES;
        let begin = begin - W::BESIDE.min(begin);
        if let Some((body, series)) =
            W::integrate::<R>(seen.get(begin..).unwrap_or(&[]), half, order, F::TWO_FLOAT)
        {
            let mut place = self.stream(state, history_s).place;
            place.step::<false, _>((time, &[]), interval, W::BLOCK, &body, &series, read);
        }
    }
}

/// Moves what follows the first `count` to the front.
#[inline(always)]
#[expect(
    clippy::indexing_slicing,
    reason = "the loop ends at the length, and a copy in one call takes longer"
)]
fn drop_first<R: Real>(samples: &mut [Increment<R>], count: usize) {
    for from in count..samples.len() {
        samples[from - count] = samples[from];
    }
}
