//! The step over a block, and the rows within it.

use super::edges;
use super::rows::Read;
use super::{State, Strapdown};
use crate::math::real::Real;
use crate::strapdown::block::body::BodyMotion;
use crate::strapdown::block::inside::{BlockSeries, Mirror};
use crate::strapdown::block::intervals::Intervals as _;
use crate::strapdown::block::window::Window;
use crate::strapdown::frame::Frame;
use crate::strapdown::frame::block_time::BlockTime;

/// A block to be crossed.
struct Crossing<'a, R: Real> {
    time: &'a BlockTime<R>,
    /// Samples.
    block: usize,
    body: &'a BodyMotion<R>,
    /// The nominal interval, s, and the differences of its samples' intervals from it; empty if there are none.
    interval: R,
    excess: &'a [R],
    /// Samples before it.
    integrated: u64,
}

impl<R: Real> Crossing<'_, R> {
    #[inline(always)]
    fn cross<const EDGE: bool, F: Frame<Real = R>, Q: Read<F> + ?Sized>(
        &self,
        frame: &mut F,
        series: &(impl BlockSeries<R> + ?Sized),
        read: &mut Q,
    ) {
        let &Self { time, block, body, interval, excess, integrated } = self;
        let before = *frame;
        let step = if EDGE { edges::step(frame, time, body) } else { frame.step(time, body) };
        if read.wants_rows() {
            let part = R::ONE / R::count(block as u32);
            let mut mirror = Mirror::new();
            let mut elapsed = R::ZERO;
            for row in 1..block {
                let (inside, fraction) = match excess.get(row - 1) {
                    None => (
                        series.until_row(row, block, time.half, &mut mirror),
                        R::count(row as u32) * part,
                    ),
                    Some(&excess) => {
                        elapsed = elapsed + (interval + excess);
                        let fraction = elapsed / time.time.hi;
                        (series.until(fraction + fraction - R::ONE, time.half), fraction)
                    }
                };
                let output = before.within(&step, time, &inside, fraction);
                read.row(integrated + row as u64, output);
            }
            read.row(integrated + block as u64, frame.output());
        }
    }
}

/// Crosses a block: one copy of the code for all windows and readers of a frame.
#[inline(never)]
fn cross_any<F: Frame>(
    frame: &mut F,
    crossing: &Crossing<F::Real>,
    series: &dyn BlockSeries<F::Real>,
    read: &mut dyn Read<F>,
) {
    crossing.cross::<false, _, _>(frame, series, read);
}

impl<R: Real, F: Frame<Real = R>, W: Window> Strapdown<F, W> {
    /// Crosses a block: sets up the gravity history if the block's length is new, steps, reads rows. `excess`
    /// has the differences of its samples' intervals from the nominal one; it is empty if there are none.
    #[inline(always)]
    pub(super) fn step<const EDGE: bool, Q: Read<F> + ?Sized>(
        &self,
        state: &mut State<F, W>,
        (time, excess): (&BlockTime<R>, &[R]),
        block: usize,
        body: &BodyMotion<R>,
        series: &impl BlockSeries<R>,
        read: &mut Q,
    ) {
        let uneven = !excess.is_empty();
        if W::UNEQUAL && (uneven || R::any(R::ZERO.less(state.intervals.history_s()))) {
            self.adapt_history(state, time, body);
            state.intervals.set_history(if uneven { time.time.hi } else { R::ZERO });
            state.seeded = block;
        } else if state.seeded != block {
            state.frame.seed(time, body);
            state.seeded = block;
        }
        let crossing = Crossing {
            time,
            block,
            body,
            interval: self.interval.hi,
            excess,
            integrated: state.integrated,
        };
        if W::UNEQUAL {
            let mut read = &mut *read;
            cross_any(&mut state.frame, &crossing, series, &mut read);
        } else {
            crossing.cross::<EDGE, _, _>(&mut state.frame, series, read);
        }
        state.integrated += block as u64;
        state.pending -= block;
        read.block(state.integrated, body, &state.frame);
    }
}
