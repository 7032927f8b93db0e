//! A recording of a vehicle at rest: level, north, and whether the readings are plausible.

pub mod align;
pub mod fine;
pub mod opening;
pub mod units;
mod words;

use crate::output::heard::warn;
