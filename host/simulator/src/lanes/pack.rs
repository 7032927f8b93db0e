//! Numbers, one of each run, that go through the same operations side by side.
//!
//! Every lane has the result of a single `f64`, bit for bit: IEEE 754 determines the operations, and functions
//! are those of `f64`.

use super::drawn::{Deviates, Generator};
use super::sealed::Sealed;
use super::words::Words;
use schuler::noise::random::Random;

/// What each lane of a pack calls itself where the fields of a state are listed.
pub(super) const LANE: &str = "lane";

/// A number of each of `N` runs. Nobody else can have lanes: a kind vouches for the processor.
pub trait Lanes<const N: usize>: Random + Send + Sealed {
    /// The bits of such numbers.
    type Words: Words<N>;

    /// From a number of each run.
    fn from_lanes(lanes: [f64; N]) -> Self;
    /// The numbers of all runs.
    fn lanes(self) -> [f64; N];
    /// From the bits of each number.
    fn from_bits(bits: Self::Words) -> Self;
    /// The bits of each number.
    fn to_bits(self) -> Self::Words;
    /// The nearest numbers to words below 2⁶³.
    fn nearest(words: Self::Words) -> Self;
    /// Which words exceed a bound, all below 2⁶³.
    fn beyond(words: Self::Words, bound: i64) -> Self::Mask;
    /// A bit for each lane, the lowest for the first.
    fn marks(mask: Self::Mask) -> u32;
    /// Does a task, compiled for these lanes' registers.
    fn compiled<T: Task>(task: T) -> T::Output;
    /// The next deviates of each lane's stream.
    fn fill(generator: &mut Generator<N>, deviates: &mut Deviates);
}

/// What is compiled for the registers of whoever does it.
pub trait Task {
    /// What comes of it.
    type Output;
    /// Does it; must be inlined, with all that is to use the registers.
    fn run(self) -> Self::Output;
}
