//! Numbers, one of each run, that go through the same operations side by side.
//!
//! Every lane has the result of a single `f64`, bit for bit: IEEE 754 determines the operations, and functions
//! are those of `f64`.

use super::sealed::Sealed;
use schuler::math::real::Real;
use schuler::record::Record;

/// What each lane of a pack calls itself where the fields of a state are listed.
pub(super) const LANE: &str = "lane";

/// A number of each of `N` runs. Nobody else can have lanes: a kind vouches for the processor.
pub trait Lanes<const N: usize>: Real + Record + Send + Sealed {
    /// From a number of each run.
    fn from_lanes(lanes: [f64; N]) -> Self;
    /// The numbers of all runs.
    fn lanes(self) -> [f64; N];
    /// Does a task, compiled for these lanes' registers.
    fn compiled<T: Task>(task: T) -> T::Output;
}

/// What is compiled for the registers of whoever does it.
pub trait Task {
    /// What comes of it.
    type Output;
    /// Does it; must be inlined, with all that is to use the registers.
    fn run(self) -> Self::Output;
}
