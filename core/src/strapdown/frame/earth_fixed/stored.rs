//! The byte form of an Earth-fixed state.

use super::EarthFixed;
use crate::math::compensated::Accumulate;
use crate::record::{Record, record};

impl<S: Accumulate + Record> Record for EarthFixed<S>
where
    S::Real: Record,
{
    record!(position, velocity, attitude, gravitation, gravitation_low, history, latitude);
}
