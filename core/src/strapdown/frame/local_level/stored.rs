//! The byte form of a local-level state.

use super::LocalLevel;
use crate::math::compensated::Accumulate;
use crate::record::{Record, record};

impl<S: Accumulate + Record> Record for LocalLevel<S>
where
    S::Real: Record,
{
    record!(
        position,
        sine,
        cosine,
        velocity,
        attitude,
        curvature,
        gravity_excess,
        gravity_excess_low,
        longitude_rest,
        history
    );
}
