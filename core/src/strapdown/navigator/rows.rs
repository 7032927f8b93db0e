//! Readers of the rows inside a block. The type of the reader decides whether rows are computed, so that rows that
//! nobody reads cost nothing. With a window for samples of any length this is decided at run time, so that one
//! copy of the code serves all readers.

use crate::strapdown::block::body::BodyMotion;
use crate::strapdown::frame::Frame;

/// A reader of rows.
pub(crate) trait Read<F: Frame> {
    /// Whether it reads rows inside a block.
    fn wants_rows(&self) -> bool;
    /// A row: the number of samples up to it, and the solution there.
    #[inline(always)]
    fn row(&mut self, _: u64, _: F::Output) {}
    /// A block: the number of samples at its end, the body's motion over it, and the frame there.
    #[inline(always)]
    fn block(&mut self, _: u64, _: &BodyMotion<F::Real>, _: &F) {}
}

/// Reads no rows; only the state at the end of a block is used.
pub(crate) struct Unread;

impl<F: Frame> Read<F> for Unread {
    #[inline(always)]
    fn wants_rows(&self) -> bool {
        false
    }
}

/// A closure reads every row.
pub(crate) struct Every<C>(pub C);

impl<F: Frame, C: FnMut(u64, F::Output)> Read<F> for Every<C> {
    #[inline(always)]
    fn wants_rows(&self) -> bool {
        true
    }
    #[inline(always)]
    fn row(&mut self, samples: u64, output: F::Output) {
        (self.0)(samples, output);
    }
}

/// A closure sees every block, step by step.
pub(crate) struct Blocks<C>(pub C);

impl<F: Frame, C: FnMut(u64, &BodyMotion<F::Real>, &F)> Read<F> for Blocks<C> {
    #[inline(always)]
    fn wants_rows(&self) -> bool {
        false
    }
    #[inline(always)]
    fn block(&mut self, samples: u64, body: &BodyMotion<F::Real>, frame: &F) {
        (self.0)(samples, body, frame);
    }
}

/// A reader as one that is chosen at run time.
pub(crate) trait Chosen<F: Frame>: Read<F> {
    /// Itself.
    fn chosen(&mut self) -> &mut (dyn Read<F> + '_);
}

impl<F: Frame, Q: Read<F>> Chosen<F> for Q {
    #[inline(always)]
    fn chosen(&mut self) -> &mut (dyn Read<F> + '_) {
        self
    }
}

impl<F: Frame> Chosen<F> for dyn Read<F> + '_ {
    #[inline(always)]
    fn chosen(&mut self) -> &mut (dyn Read<F> + '_) {
        self
    }
}
