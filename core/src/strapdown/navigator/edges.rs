//! The first and the last blocks of a stream, whose windows are incomplete.
//!
//! They are rare, so the fit is computed at run time, through as many samples as the motion supports, and all of
//! them use the longest series.

use super::rows::Read;
use super::{State, Strapdown};
use crate::math::real::Real;
use crate::sample::Increment;
use crate::strapdown::block::body::{self, BodyMotion, Sum};
use crate::strapdown::block::fit::LINE_LAST_SAMPLES;
use crate::strapdown::block::fit::{Fit, MOST_SAMPLES};
use crate::strapdown::block::newton::{self, Used};
use crate::strapdown::block::series::Series;
use crate::strapdown::block::shape::WindowShape;
use crate::strapdown::block::window::Window;
use crate::strapdown::frame::Frame;
use crate::strapdown::frame::block_time::BlockTime;

/// Terms of the series of first and last blocks of any window.
const EDGE_TERMS: usize = 26;
/// Samples at most in a stream's last blocks.
const LAST_BLOCK: usize = 4;

/// Integrates a block at an edge: one copy of the code for all frames, windows and readers.
#[inline(never)]
fn integrate<R: Real>(
    fit: &Fit<R, MOST_SAMPLES>,
    sum: &Sum<R>,
    half_time_s: R,
) -> (BodyMotion<R>, Series<R, { EDGE_TERMS + 1 }>) {
    body::integrate(fit, sum, half_time_s, EDGE_TERMS)
}

/// Steps over a block at an edge: one copy of the code for all windows and readers of a frame.
#[inline(never)]
pub(crate) fn step<F: Frame>(
    frame: &mut F,
    time: &BlockTime<F::Real>,
    body: &BodyMotion<F::Real>,
) -> F::Step {
    frame.step(time, body)
}

/// The fit of a block at an edge: one copy of the code for all frames, windows and readers.
#[inline(never)]
fn fit<R: Real>(
    samples: &[Increment<R>],
    shape: WindowShape,
    begin: usize,
) -> (Fit<R, MOST_SAMPLES>, Used<R>) {
    newton::at_edge(samples, shape, begin)
}

impl<R: Real, F: Frame<Real = R>, W: Window> Strapdown<F, W> {
    /// A block of `block` samples within the window of at most `all` samples that starts `history`
    /// before it.
    #[inline(never)]
    pub(crate) fn edge_block<Q: Read<F> + ?Sized>(
        &self,
        state: &mut State<F, W>,
        history: usize,
        block: usize,
        all: usize,
        read: &mut Q,
    ) {
        if !self.is_nominal(state, history, all) {
            let lookahead = all.saturating_sub(history + block);
            return self.unequal_block(
                state,
                WindowShape { history, block, lookahead },
                true,
                read,
            );
        }
        let past = state.filled.saturating_sub(state.pending);
        let begin = past.saturating_sub(history);
        let samples = state.samples;
        let stored = samples.as_ref().get(..state.filled).unwrap_or(&[]);
        let own = stored.get(past..past + block).unwrap_or(&[]);
        let lookahead = all.saturating_sub(history + block);
        let time = BlockTime::new(self.interval, block);
        let (fit, used) = fit(stored, WindowShape { history, block, lookahead }, begin);
        let sum = if F::TWO_FLOAT { Sum::exact(own) } else { Sum::plain(own) };
        if state.integrated == 0 && W::HISTORY > 0 {
            state.edges.first = used;
        }
        if lookahead < W::LOOKAHEAD || W::LOOKAHEAD == 0 {
            state.edges.last = used;
        }
        let (body, series) = integrate(&fit, &sum, time.half);
        self.step::<true, _>(state, (&time, &[]), block, &body, &series, read);
    }

    /// The last blocks: missing look-ahead is replaced by history.
    #[inline(never)]
    pub(crate) fn last_blocks<Q: Read<F> + ?Sized>(&self, state: &mut State<F, W>, read: &mut Q) {
        while state.pending > 0 {
            let block = state.pending.min(W::BLOCK).min(LAST_BLOCK);
            let most = if W::COEFFICIENTS < W::SAMPLES {
                LINE_LAST_SAMPLES
            } else {
                W::SAMPLES.max(LAST_BLOCK)
            };
            // As much history as look-ahead, if there are enough samples of both.
            let (beside, after) = (most - block, state.pending - block);
            let past = state.filled - state.pending;
            let history = past.min((beside / 2).max(beside.saturating_sub(after)));
            let lookahead = after.min(beside - history);
            self.edge_block(state, history, block, history + block + lookahead, read);
        }
    }
}
