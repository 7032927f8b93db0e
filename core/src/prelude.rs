//! What a typical program needs, in one line: `use schuler::prelude::*`.

pub use crate::earth::Geodetic;
pub use crate::math::compensated::Pair;
pub use crate::math::quaternion::Quaternion;
pub use crate::math::vector::Vector;
pub use crate::navigators::*;
pub use crate::output::Output;
pub use crate::readout::Readout;
pub use crate::sample::{Increment, RateIntegrator, Rates};
pub use crate::solution::{EarthFixedSolution, Euler, Solution};
pub use crate::strapdown::correction::{Correction, CorrectionError};
pub use crate::strapdown::limits::{Limits, Rejected, StartError};
pub use crate::strapdown::mechanization::{Mechanization, UnequalIntervals};
pub use crate::strapdown::navigator::Strapdown;
pub use crate::strapdown::reference::textbook::Textbook;
