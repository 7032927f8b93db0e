//! The byte form of an Earth-fixed state.

use super::super::Blank;
use super::super::gravitation::Latitude;
use super::super::gravity_history::GravityHistory;
use super::EarthFixed;
use crate::math::compensated::{Accumulate, Pair};
use crate::math::quaternion::Quaternion;
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::record::{Record, record};

impl<S: Accumulate + Record> Record for EarthFixed<S>
where
    S::Real: Record,
{
    record!(position, velocity, attitude, gravitation, gravitation_low, history, latitude);
}

impl<R: Real, S: Accumulate<Real = R>> Blank for EarthFixed<S> {
    fn blank() -> Self {
        let none = S::from_pair(Pair::default());
        Self {
            position: Vector::new(none, none, none),
            velocity: Vector::new(none, none, none),
            attitude: Quaternion::new(none, Vector::new(none, none, none)),
            gravitation: Vector::ZERO,
            gravitation_low: Vector::ZERO,
            history: GravityHistory::NONE,
            latitude: Latitude { sine: R::ZERO, cosine: R::ZERO, change: R::ZERO },
        }
    }
}
