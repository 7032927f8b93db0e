//! What the textbook needs of a frame.

use super::body::Compensated;
use crate::math::real::Real;
use crate::output::Output;
use crate::solution::Solution;
use crate::strapdown::correction::Correction;
use crate::strapdown::limits::Rejected;
use crate::strapdown::plausible::Plausible;

/// A textbook frame: its state and the step over one sample.
pub trait TextbookFrame: Copy + Send + Plausible {
    /// The scalar it computes in.
    type Real: Real;
    /// The form of its solution.
    type Output: Output<Self::Real>;

    /// From an initial solution.
    fn start(initial: &Solution<Self::Real>) -> Self;
    /// Scales the changes over the previous sample to a sample that is longer by a factor.
    fn stretch(&mut self, factor: Self::Real);
    /// Steps over one sample of `interval_s`.
    fn step(&mut self, interval_s: Self::Real, body: &Compensated<Self::Real>);
    /// Sets height (m) and vertical velocity (down, m/s), as an altimeter would.
    fn hold_vertical(&mut self, altitude: Self::Real, down: Self::Real);
    /// Adds a correction that is finite and not too large; what is refused leaves half of one.
    fn correct(&mut self, correction: &Correction<Self::Real>) -> Result<(), Rejected>;
    /// Whether navigation can continue at its place.
    ///
    /// # Errors
    ///
    /// [`Rejected::Pole`] or [`Rejected::Place`].
    fn check_place(&self) -> Result<(), Rejected>;
    /// The present solution.
    fn output(&self) -> Self::Output;
}
