//! The step over a block, and the rows within it.

use super::edges;
use super::rows::{Chosen, Read};
use super::stream::Place;
use crate::math::real::Real;
use crate::strapdown::block::body::BodyMotion;
use crate::strapdown::block::inside::{BlockSeries, Mirror};
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

impl<R: Real, F: Frame<Real = R>, const UNEQUAL: bool> Place<'_, F, UNEQUAL> {
    /// Crosses a block: sets up the gravity history if the block's length is new, steps, reads rows. `excess`
    /// has the differences of its samples' intervals from the nominal `interval`; it is empty if there are none.
    #[inline(always)]
    pub fn step<const EDGE: bool, Q: Chosen<F> + ?Sized>(
        &mut self,
        (time, excess): (&BlockTime<R>, &[R]),
        interval: R,
        block: usize,
        body: &BodyMotion<R>,
        series: &impl BlockSeries<R>,
        read: &mut Q,
    ) {
        if UNEQUAL {
            return self.step_any((time, excess), interval, block, body, series, read.chosen());
        }
        if self.progress.seeded != block {
            self.frame.seed(time, body);
            self.progress.seeded = block;
        }
        let integrated = self.progress.integrated;
        let crossing = Crossing { time, block, body, interval, excess: &[], integrated };
        crossing.cross::<EDGE, _, _>(self.frame, series, read);
        self.moved(block, body, read);
    }

    /// The same, one copy of the code for all windows and readers of a frame.
    #[inline(never)]
    pub fn step_any(
        &mut self,
        (time, excess): (&BlockTime<R>, &[R]),
        interval: R,
        block: usize,
        body: &BodyMotion<R>,
        series: &dyn BlockSeries<R>,
        read: &mut dyn Read<F>,
    ) {
        let uneven = !excess.is_empty();
        if uneven || R::any(R::ZERO.less(*self.history_s)) {
            self.adapt_history(interval, time, body);
            *self.history_s = if uneven { time.time.hi } else { R::ZERO };
            self.progress.seeded = block;
        } else if self.progress.seeded != block {
            self.frame.seed(time, body);
            self.progress.seeded = block;
        }
        let integrated = self.progress.integrated;
        let crossing = Crossing { time, block, body, interval, excess, integrated };
        crossing.cross::<false, _, _>(self.frame, series, read);
        self.moved(block, body, read);
    }

    #[inline(always)]
    fn moved<Q: Read<F> + ?Sized>(&mut self, block: usize, body: &BodyMotion<R>, read: &mut Q) {
        self.progress.integrated += block as u64;
        self.progress.pending -= block;
        read.block(self.progress.integrated, body, self.frame);
    }
}
