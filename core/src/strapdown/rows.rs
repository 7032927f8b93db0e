//! Who reads the rows inside a block: decided by type, so that nobody pays for what is not read.

/// Who reads the rows.
pub(super) trait Read<O> {
    /// Whether rows inside a block are wanted at all.
    const EVERY_ROW: bool;
    /// A row: the number of samples that lie behind it, and the navigation there.
    fn row(&mut self, samples: u64, output: O);
}

/// Nobody reads rows: the state at a block's end is all.
pub(super) struct Unread;

impl<O> Read<O> for Unread {
    const EVERY_ROW: bool = false;
    #[inline(always)]
    fn row(&mut self, _: u64, _: O) {}
}

/// A closure reads every row.
pub(super) struct Every<C>(pub C);

impl<O, C: FnMut(u64, O)> Read<O> for Every<C> {
    const EVERY_ROW: bool = true;
    #[inline(always)]
    fn row(&mut self, samples: u64, output: O) {
        (self.0)(samples, output);
    }
}
