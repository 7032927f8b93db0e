//! Who reads the rows inside a block: decided by type, so that nobody pays for what is not read. With a window
//! for samples of any length it is decided at run time, so that there is one code for all readers.

use crate::strapdown::block::body::BodyMotion;
use crate::strapdown::frame::Frame;

/// Who reads the rows.
pub(crate) trait Read<F: Frame> {
    /// Whether rows inside a block are wanted at all.
    fn wants_rows(&self) -> bool;
    /// A row: the number of samples that lie behind it, and the navigation there.
    #[inline(always)]
    fn row(&mut self, _: u64, _: F::Output) {}
    /// A block: the number of samples at its end, the body's motion over it, and the frame there.
    #[inline(always)]
    fn block(&mut self, _: u64, _: &BodyMotion<F::Real>, _: &F) {}
}

/// Nobody reads rows: the state at a block's end is all.
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

/// Another reader by reference: a type of known size for one chosen at run time.
impl<F: Frame, Q: Read<F> + ?Sized> Read<F> for &mut Q {
    #[inline(always)]
    fn wants_rows(&self) -> bool {
        (**self).wants_rows()
    }
    #[inline(always)]
    fn row(&mut self, samples: u64, output: F::Output) {
        (**self).row(samples, output);
    }
    #[inline(always)]
    fn block(&mut self, samples: u64, body: &BodyMotion<F::Real>, frame: &F) {
        (**self).block(samples, body, frame);
    }
}
