//! A stream of samples, whether the compiler knows its window or it is chosen at run time.

use super::rows::Read;
use crate::math::compensated::Pair;
use crate::math::real::Real;
use crate::sample::Increment;
use crate::strapdown::block::any_window::{Integration, Layout, Numbers};
use crate::strapdown::block::newton::Edges;
use crate::strapdown::frame::Frame;
use crate::strapdown::frame::block_time::BlockTime;
use crate::strapdown::limits::Rejected;

/// How far a stream has come.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct Progress<R> {
    /// Samples stored.
    pub filled: usize,
    /// Those of them that are not integrated yet, the latest.
    pub pending: usize,
    /// Samples integrated since the start.
    pub integrated: u64,
    /// Samples of the block that the gravity history belongs to; 0 before the first.
    pub seeded: usize,
    /// The number of samples that first and last blocks were fitted to.
    pub edges: Edges<R>,
}

impl<R: Real> Progress<R> {
    /// Before the first sample.
    pub fn none() -> Self {
        Self { filled: 0, pending: 0, integrated: 0, seeded: 0, edges: Edges::none() }
    }

    /// Samples stored that are integrated.
    #[inline(always)]
    pub fn past(&self) -> usize {
        self.filled.saturating_sub(self.pending)
    }
}

/// The duration of samples and blocks, and the order of their series.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct Timing<R> {
    /// The nominal interval, s.
    pub interval: Pair<R>,
    /// A block of such samples.
    pub block: BlockTime<R>,
    /// Order of its series.
    pub order: usize,
}

impl<R: Real> Timing<R> {
    /// Of a nominal interval in seconds and blocks of a number of samples.
    pub fn new(interval: Pair<R>, block: usize, order: usize) -> Self {
        Self { interval, block: BlockTime::new(interval, block), order }
    }
}

/// Where a stream stands: what a step over a block moves on.
pub(crate) struct Place<'a, F: Frame, const UNEQUAL: bool> {
    /// Position, velocity, attitude and gravity.
    pub frame: &'a mut F,
    /// How far it has come.
    pub progress: &'a mut Progress<F::Real>,
    /// Duration of the block that the gravity history belongs to, s; 0 if its number of samples determines it.
    pub history_s: &'a mut F::Real,
}

/// A stream with its samples. `UNEQUAL`: they may differ in length.
pub(crate) struct Stream<'a, F: Frame, K, const UNEQUAL: bool> {
    /// Where it stands.
    pub place: Place<'a, F, UNEQUAL>,
    /// The stored samples.
    pub samples: &'a [Increment<F::Real>],
    /// Their intervals less the nominal one, s.
    pub excess: &'a [F::Real],
    /// Durations and order.
    pub timing: &'a Timing<F::Real>,
    /// Its window.
    pub window: K,
}

/// The room of a stream whose samples may differ in length.
pub(crate) struct Room<'a, F: Frame, K> {
    /// Position, velocity, attitude and gravity.
    pub frame: &'a mut F,
    /// Room for samples.
    pub samples: &'a mut [Increment<F::Real>],
    /// Room for their intervals less the nominal one, s.
    pub excess: &'a mut [F::Real],
    /// How far the stream has come.
    pub progress: &'a mut Progress<F::Real>,
    /// Duration of the block that the gravity history belongs to, s.
    pub history_s: &'a mut F::Real,
    /// Durations and order.
    pub timing: &'a Timing<F::Real>,
    /// Its window.
    pub window: K,
}

impl<'a, F: Frame, K: Layout<F::Real>> Room<'a, F, K> {
    /// Takes a sample and integrates the blocks that it completes: one copy of the code for all readers, and for
    /// all windows that are chosen at run time.
    #[inline(never)]
    pub fn take(
        mut self,
        sample: Increment<F::Real>,
        excess: F::Real,
        read: &mut dyn Read<F>,
    ) -> Result<(), Rejected> {
        let &Numbers { shape, first, .. } = self.window.numbers();
        // If a block ended at a place where navigation cannot continue, every following sample is refused.
        if self.progress.pending <= shape.lookahead {
            self.frame.check_place()?;
        }
        self.store(sample, excess);
        let past = self.progress.past();
        let reach = shape.block + shape.lookahead;
        if past < shape.history {
            if self.progress.filled < first {
                return Ok(());
            }
        } else if self.progress.pending < reach {
            return Ok(());
        }
        let mut stream = self.stream();
        if past < shape.history {
            // The first block needs no history.
            stream.edge_block::<dyn Read<F>>(past, shape.block, first, read);
        }
        while stream.place.progress.pending >= reach {
            stream.block(read);
        }
        Ok(())
    }

    /// Integrates all pending samples.
    #[inline(never)]
    pub fn finish(self, read: &mut dyn Read<F>) {
        self.stream().last_blocks::<dyn Read<F>>(read);
    }

    fn store(&mut self, sample: Increment<F::Real>, excess: F::Real) {
        let &Numbers { shape, stored, .. } = self.window.numbers();
        let drop = store(
            self.samples.get_mut(..stored).unwrap_or(&mut []),
            self.progress,
            shape.block,
            sample,
            drop_first,
        );
        let kept = self.excess.get_mut(..stored).unwrap_or(&mut []);
        drop_first(kept, drop);
        if let Some(slot) = kept.get_mut(self.progress.filled.saturating_sub(1)) {
            *slot = excess;
        }
    }

    fn stream(self) -> Stream<'a, F, K, true> {
        let Self { frame, samples, excess, progress, history_s, timing, window } = self;
        let place = Place { frame, progress, history_s };
        Stream { place, samples, excess, timing, window }
    }
}

/// Stores a sample, dropping the oldest ones a block at a time by a function; gives how many those were.
#[inline(always)]
pub(super) fn store<R: Real>(
    samples: &mut [Increment<R>],
    progress: &mut Progress<R>,
    block: usize,
    sample: Increment<R>,
    drop_first: impl FnOnce(&mut [Increment<R>], usize),
) -> usize {
    let mut drop = 0;
    if progress.filled >= samples.len() {
        // After an early `finish`, more than a block's length may still be pending.
        drop = block.min(progress.past());
        drop_first(samples, drop);
        progress.filled = samples.len() - drop;
    }
    if let Some(slot) = samples.get_mut(progress.filled) {
        *slot = sample;
        progress.filled += 1;
        progress.pending += 1;
    }
    drop
}

/// Moves what follows the first `count` to the front.
fn drop_first<T: Copy>(slots: &mut [T], count: usize) {
    if count <= slots.len() {
        slots.copy_within(count.., 0);
    }
}

impl<F: Frame, K: Layout<F::Real>> Stream<'_, F, K, true> {
    /// A block within the stream.
    fn block(&mut self, read: &mut dyn Read<F>) {
        let &Numbers { shape, .. } = self.window.numbers();
        if self.is_nominal(shape.history, shape.samples()) {
            self.whole_block(read);
        } else {
            self.unequal_block::<dyn Read<F>>(shape, false, read);
        }
    }

    /// A block whose samples last the nominal interval.
    fn whole_block(&mut self, read: &mut dyn Read<F>) {
        let &Numbers { shape, beside, .. } = self.window.numbers();
        let end = self.place.progress.past() + shape.block + shape.lookahead;
        let seen = self.samples.get(..end).unwrap_or(&[]);
        // The samples before the window are used if they are there and have the same interval.
        let begin = end.saturating_sub(shape.samples());
        let beside = beside.min(begin);
        let alike = self.is_nominal(shape.history + beside, beside);
        let begin = if alike { begin - beside } else { begin };
        let Timing { block, order, .. } = self.timing;
        let how = Integration { half_time_s: block.half, order: *order, two_float: F::TWO_FLOAT };
        let place = &mut self.place;
        let interval = self.timing.interval.hi;
        let integrated = self.window.integrate(seen, begin, &how, |body, series, used| {
            if let Some(used) = used {
                place.progress.edges.last = used;
            }
            let crossed = (block, &[] as &[F::Real]);
            place.step_any(crossed, interval, shape.block, body, series, read);
        });
        let behind = shape.lookahead == 0 && shape.history > 0;
        if behind && !integrated {
            self.edge_block::<dyn Read<F>>(shape.history, shape.block, shape.samples(), read);
        }
    }
}
