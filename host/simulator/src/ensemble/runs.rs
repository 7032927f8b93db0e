//! What runs that fly together can do, and how one of them ends early.

use super::held::Held;
use schuler::sample::Increment;
use schuler::solution::Solution;
use schuler::strapdown::limits::Rejected;

/// A run that could not go on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Failure {
    /// Its number, from 0.
    pub run: u64,
    /// The sample that it did not take, from 1.
    pub sample: u64,
    /// Why not.
    pub why: Rejected,
}

/// Runs of an ensemble, flown together.
pub trait Group: Send {
    /// Takes the perfect increments of the next samples, and the vertical where it is held. A run that
    /// refuses a sample has failed; the others go on.
    fn fly(&mut self, perfect: &[Increment<f64>], held: Option<&Held>);
    /// The runs that have failed.
    fn failures(&self) -> Vec<Failure>;
    /// Whether there is a run that has not.
    fn goes_on(&self) -> bool;
    /// Integrates what is pending: the samples are at their end.
    fn finish(&mut self);
    /// Samples of each run that were integrated so far.
    fn integrated(&self) -> u64;
    /// Navigation of each run at the end of the last block; `None` of those that have failed.
    fn solutions(&self) -> Vec<Option<Solution<f64>>>;
    /// Samples so far in which a sensor was at its limit, over all runs.
    fn saturated(&self) -> u64;
    /// What navigation alone costs, ns per sample and run, over perfect increments after those `before`.
    fn navigation_ns(&mut self, before: &[Increment<f64>], perfect: &[Increment<f64>]) -> f64;
}
