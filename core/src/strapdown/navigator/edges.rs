//! The first and the last blocks of a stream, which want samples that are not there.
//!
//! Their windows are rare: the fit is made at run time, and the series is the longest for all.

use super::super::block_time::BlockTime;
use super::super::body::{self, BodyMotion, Sum};
use super::super::fit::{Fit, MOST_SAMPLES};
use super::super::frame::Frame;
use super::super::rows::Read;
use super::super::series::Series;
use super::super::window::{LINE_LAST_SAMPLES, Window};
use super::{State, Strapdown};
use crate::math::real::Real;

/// Terms of the series of first and last blocks, whatever their window.
const EDGE_TERMS: usize = 16;
/// Samples at most in a stream's last blocks.
const LAST_BLOCK: usize = 4;

/// Integrates a block at an edge: one code for all frames, windows and readers.
#[inline(never)]
fn integrate<R: Real>(
    fit: &Fit<R, MOST_SAMPLES>,
    sum: &Sum<R>,
    half_time_s: R,
) -> (BodyMotion<R>, Series<R, { EDGE_TERMS + 1 }>) {
    body::integrate(fit, sum, half_time_s, EDGE_TERMS)
}

/// Steps over a block at an edge: one code for all windows and readers of a frame.
#[inline(never)]
pub(super) fn step<F: Frame>(
    frame: &mut F,
    time: &BlockTime<F::Real>,
    body: &BodyMotion<F::Real>,
) -> F::Step {
    frame.step(time, body)
}

impl<R: Real, F: Frame<Real = R>, W: Window> Strapdown<F, W> {
    /// A block of `block` samples within the window of `all` samples that starts `history` before it.
    #[inline(never)]
    pub(super) fn edge_block(
        &self,
        state: &mut State<F, W>,
        history: usize,
        block: usize,
        all: usize,
        read: &mut impl Read<F>,
    ) {
        if !self.is_nominal(state, history, all) {
            let lookahead = all.saturating_sub(history + block);
            return self.unequal_block(state, (history, block, lookahead), true, read);
        }
        let is_first = history == 0 && block == W::BLOCK && all == W::FIRST;
        let begin = state.filled.saturating_sub(state.pending + history);
        let samples = state.samples;
        let window = samples.as_ref().get(begin..begin + all).unwrap_or(&[]);
        let own = window.get(history..history + block).unwrap_or(&[]);
        let time = BlockTime::new(self.interval, block);
        let first = if is_first { W::first_fit(window) } else { None };
        let (fit, sum) = first.unwrap_or_else(|| Fit::of_any(window, history, block));
        let sum = if F::TWO_FLOAT { Sum::exact(own) } else { Sum::rounded(sum) };
        let (body, series) = integrate(&fit, &sum, time.half);
        self.step::<true, _>(state, &time, &[], block, &body, &series, read);
    }

    /// The last blocks: the look-ahead that is missing goes to the history.
    #[inline(never)]
    pub(super) fn last_blocks(&self, state: &mut State<F, W>, read: &mut impl Read<F>) {
        while state.pending > 0 {
            let block = state.pending.min(W::BLOCK).min(LAST_BLOCK);
            let most = if W::COEFFICIENTS < W::SAMPLES {
                LINE_LAST_SAMPLES
            } else {
                W::SAMPLES.max(LAST_BLOCK)
            };
            let lookahead = (state.pending - block).min(most - block);
            let past = state.filled - state.pending;
            let history = past.min(most - block - lookahead);
            self.edge_block(state, history, block, history + block + lookahead, read);
        }
    }
}
