//! The first and the last blocks of a stream, whose windows are incomplete.
//!
//! They are rare, so the fit is computed at run time, through as many samples as the motion supports, and all of
//! them use the longest series.

use super::rows::Chosen;
use super::stream::Stream;
use crate::math::real::Real;
use crate::sample::Increment;
use crate::strapdown::block::any_window::{Layout, Numbers};
use crate::strapdown::block::body::{self, BodyMotion, Sum};
use crate::strapdown::block::fit::LINE_LAST_SAMPLES;
use crate::strapdown::block::fit::{Fit, MOST_SAMPLES};
use crate::strapdown::block::newton::{self, Used};
use crate::strapdown::block::series::Series;
use crate::strapdown::block::shape::WindowShape;
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

impl<R, F, K, const UNEQUAL: bool> Stream<'_, F, K, UNEQUAL>
where
    R: Real,
    F: Frame<Real = R>,
    K: Layout<R>,
{
    /// A block of `block` samples within the window of at most `all` samples that starts `history`
    /// before it.
    #[inline(never)]
    pub fn edge_block<Q: Chosen<F> + ?Sized>(
        &mut self,
        history: usize,
        block: usize,
        all: usize,
        read: &mut Q,
    ) {
        let lookahead = all.saturating_sub(history + block);
        let shape = WindowShape { history, block, lookahead };
        if UNEQUAL && !self.is_nominal(history, all) {
            return self.unequal_block(shape, true, read);
        }
        let progress = &mut *self.place.progress;
        let past = progress.past();
        let begin = past.saturating_sub(history);
        let stored = self.samples.get(..progress.filled).unwrap_or(&[]);
        let own = stored.get(past..past + block).unwrap_or(&[]);
        let interval = self.timing.interval;
        let time = BlockTime::new(interval, block);
        let (fit, used) = fit(stored, shape, begin);
        let sum = if F::TWO_FLOAT { Sum::exact(own) } else { Sum::plain(own) };
        let window = self.window.numbers().shape;
        if progress.integrated == 0 && window.history > 0 {
            progress.edges.first = used;
        }
        if lookahead < window.lookahead || window.lookahead == 0 {
            progress.edges.last = used;
        }
        let (body, series) = integrate(&fit, &sum, time.half);
        self.place.step::<true, _>((&time, &[]), interval.hi, block, &body, &series, read);
    }

    /// The last blocks: missing look-ahead is replaced by history.
    #[inline(never)]
    pub fn last_blocks<Q: Chosen<F> + ?Sized>(&mut self, read: &mut Q) {
        let &Numbers { shape, coefficients, .. } = self.window.numbers();
        let samples = shape.samples();
        while self.place.progress.pending > 0 {
            let pending = self.place.progress.pending;
            let block = pending.min(shape.block).min(LAST_BLOCK);
            let most =
                if coefficients < samples { LINE_LAST_SAMPLES } else { samples.max(LAST_BLOCK) };
            // As much history as look-ahead, if there are enough samples of both.
            let (beside, after) = (most - block, pending - block);
            let past = self.place.progress.past();
            let history = past.min((beside / 2).max(beside.saturating_sub(after)));
            let lookahead = after.min(beside - history);
            self.edge_block(history, block, history + block + lookahead, read);
        }
    }
}
