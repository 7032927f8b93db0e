//! The step over a block, in either navigation frame.
//!
//! | file | what it has |
//! |---|---|
//! | [`local_level`] | north, east, down at the vehicle |
//! | [`earth_fixed`] | axes that turn with the Earth |
//! | [`block_time`] | what a block's duration alone decides |
//! | `meridian` | latitude's sine and cosine, advanced by increments |
//! | `displacement`, `beginning` | the way over a block, from its forces |
//! | [`gravitation`], `gravity_history` | gravity and its differences from block to block |
//! | `two_float` | the same step with two-float products |

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
use crate::solution::Output;
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
    /// What it prints: its own coordinates, converted only when asked.
    type Output: Output<Self::Real>;
    /// What the inside of a block needs to know of the step across it.
    type Step: Copy;
    /// Whether it wants the body's motion with what rounding drops from it.
    const TWO_FLOAT: bool;

    /// From an initial solution.
    fn start(initial: &Solution<Self::Real>) -> Self;
    /// Sets up the gravity history: at the start, and whenever a block's duration changes.
    fn seed(&mut self, time: &BlockTime<Self::Real>, body: &BodyMotion<Self::Real>);
    /// Brings the gravity history to blocks that are longer by a factor.
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
    /// Whether navigation can go on from where it stands.
    fn check_place(&self) -> Result<(), Rejected>;
    /// The state as it stands.
    fn output(&self) -> Self::Output;
}
