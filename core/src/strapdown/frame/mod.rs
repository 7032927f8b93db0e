//! The navigation step over a block, in either navigation frame.
//!
//! | file | what it has |
//! |---|---|
//! | [`local_level`] | north, east, down at the vehicle |
//! | [`earth_fixed`] | axes that turn with the Earth |
//! | [`block_time`] | constants that depend only on a block's duration |
//! | `meridian` | latitude's sine and cosine, advanced by increments |
//! | `displacement`, `beginning` | the displacement over a block, from its forces |
//! | [`gravitation`], `gravity_history` | gravity and its differences from block to block |
//! | `two_float` | the same step with two-float products |
//!
//! ```
//! use schuler::earth::Geodetic;
//! use schuler::math::{compensated::Pair, vector::Vector};
//! use schuler::output::Output;
//! use schuler::solution::{Euler, Solution};
//! use schuler::strapdown::frame::{Frame, earth_fixed::EarthFixed, local_level::LocalLevel};
//!
//! let at = Geodetic { latitude: 0.8_f64, longitude: 0.1, altitude: 100.0 };
//! let initial = Solution::new(at, Vector::ZERO, Euler::default());
//! let local = LocalLevel::<Pair<f64>>::start(&initial).output();
//! let fixed = EarthFixed::<Pair<f64>>::start(&initial).output().solution();
//! assert!((local.position.altitude.hi - fixed.position.altitude.hi).abs() < 1e-8);
//! ```

mod beginning;
pub mod block_time;
mod displacement;
pub mod earth_fixed;
pub mod gravitation;
mod gravity_history;
pub mod local_level;
#[doc(hidden)]
pub mod meridian;
mod two_float;

use crate::math::real::Real;
use crate::output::Output;
use crate::solution::Solution;
use crate::strapdown::block::body::BodyMotion;
use crate::strapdown::correction::Correction;
use crate::strapdown::frame::block_time::BlockTime;
use crate::strapdown::limits::Rejected;
use crate::strapdown::plausible::Plausible;

/// A navigation frame's state, with the step that carries it over a block.
pub trait Frame: Copy + Send + Plausible {
    /// The scalar it computes in.
    type Real: Real;
    /// The form of its solution: its own coordinates, which are converted only on request.
    type Output: Output<Self::Real>;
    /// What rows inside a block need from the step across it.
    type Step: Copy;
    /// Whether it uses the body's motion with the parts that rounding drops.
    const TWO_FLOAT: bool;

    /// From an initial solution.
    fn start(initial: &Solution<Self::Real>) -> Self;
    /// Sets up the gravity history, at the start and whenever a block's duration changes.
    fn seed(&mut self, time: &BlockTime<Self::Real>, body: &BodyMotion<Self::Real>);
    /// Converts the gravity history to blocks that are longer by a factor.
    fn stretch(&mut self, factor: Self::Real);
    /// Steps over a block.
    fn step(&mut self, time: &BlockTime<Self::Real>, body: &BodyMotion<Self::Real>) -> Self::Step;
    /// The state at a fraction τ of the block that `step` crossed; `self` is the state before it and
    /// `body` the body's motion up to τ.
    fn within(
        &self,
        step: &Self::Step,
        time: &BlockTime<Self::Real>,
        body: &BodyMotion<Self::Real>,
        fraction: Self::Real,
    ) -> Self::Output;
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

/// A state that is to be restored.
#[doc(hidden)]
pub trait Blank {
    /// All its numbers are 0.
    fn blank() -> Self;
}
