//! The byte form of a local-level state.

use super::super::Blank;
use super::super::gravity_history::GravityHistory;
use super::LocalLevel;
use crate::earth::Geodetic;
use crate::math::compensated::{Accumulate, Pair};
use crate::math::quaternion::Quaternion;
use crate::math::real::Real;
use crate::math::vector::Vector;
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

impl<R: Real, S: Accumulate<Real = R>> Blank for LocalLevel<S> {
    fn blank() -> Self {
        let none = S::from_pair(Pair::default());
        Self {
            position: Geodetic { latitude: none, longitude: none, altitude: none },
            sine: none,
            cosine: none,
            velocity: Vector::new(none, none, none),
            attitude: Quaternion::new(none, Vector::new(none, none, none)),
            curvature: R::ZERO,
            gravity_excess: R::ZERO,
            gravity_excess_low: R::ZERO,
            longitude_rest: R::ZERO,
            history: GravityHistory::NONE,
        }
    }
}
