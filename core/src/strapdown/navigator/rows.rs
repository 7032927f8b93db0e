//! Whether and by whom rows inside a block are read: a type decides, so that rows that are not read cost nothing.

use crate::strapdown::block::body::BodyMotion;
use crate::strapdown::frame::Frame;

/// A reader of rows.
pub(crate) trait Read<F: Frame> {
    /// Whether it reads rows inside a block.
    const EVERY_ROW: bool;
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
    const EVERY_ROW: bool = false;
}

/// A closure reads every row.
pub(crate) struct Every<C>(pub C);

impl<F: Frame, C: FnMut(u64, F::Output)> Read<F> for Every<C> {
    const EVERY_ROW: bool = true;
    #[inline(always)]
    fn row(&mut self, samples: u64, output: F::Output) {
        (self.0)(samples, output);
    }
}

/// A closure sees every block, step by step.
pub(crate) struct Blocks<C>(pub C);

impl<F: Frame, C: FnMut(u64, &BodyMotion<F::Real>, &F)> Read<F> for Blocks<C> {
    const EVERY_ROW: bool = false;
    #[inline(always)]
    fn block(&mut self, samples: u64, body: &BodyMotion<F::Real>, frame: &F) {
        (self.0)(samples, body, frame);
    }
}
