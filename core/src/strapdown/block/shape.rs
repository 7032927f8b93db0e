//! A window's shape: how many samples before, in and after a block it has.
//!
//! ```
//! use schuler::strapdown::block::shape::WindowShape;
//!
//! let shape: WindowShape = "2,4,2".parse()?;
//! assert_eq!(shape, WindowShape::new(2, 4, 2));
//! assert_eq!((shape.samples(), shape.to_string().as_str()), (8, "2,4,2"));
//! # Ok::<(), schuler::strapdown::block::shape::NotAShape>(())
//! ```

use core::fmt::{self, Display, Formatter};
use core::str::FromStr;

/// How many samples a window has; written `history,block,lookahead`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct WindowShape {
    /// Samples before the block.
    pub history: usize,
    /// Samples integrated at once.
    pub block: usize,
    /// Samples after the block.
    pub lookahead: usize,
}

impl WindowShape {
    /// From the three counts.
    pub const fn new(history: usize, block: usize, lookahead: usize) -> Self {
        Self { history, block, lookahead }
    }

    /// Samples in all.
    pub const fn samples(self) -> usize {
        self.history + self.block + self.lookahead
    }
}

impl Display for WindowShape {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "{},{},{}", self.history, self.block, self.lookahead)
    }
}

/// Text that is not three counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct NotAShape;

impl Display for NotAShape {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str("a window is written as history,block,lookahead: three numbers of samples")
    }
}

impl core::error::Error for NotAShape {}

impl FromStr for WindowShape {
    type Err = NotAShape;

    fn from_str(text: &str) -> Result<Self, NotAShape> {
        let mut counts = text.split(',').map(|count| count.trim().parse().map_err(|_| NotAShape));
        let mut next = || counts.next().unwrap_or(Err(NotAShape));
        let shape = Self { history: next()?, block: next()?, lookahead: next()? };
        if counts.next().is_none() { Ok(shape) } else { Err(NotAShape) }
    }
}
