//! A flight that takes its samples in double precision, whatever its own precision.
//!
//! ```
//! use schuler::flight::from_double::FromDouble;
//! use schuler::math::compensated::Pair;
//! use schuler::prelude::*;
//!
//! let level = Euler { roll: 0.0, pitch: 0.0, yaw: 0.0 };
//! let start = Solution::new(Geodetic::default(), Vector::ZERO, level);
//! let mut flown =
//!     FromDouble::<Navigator4<f32>>::start(Pair::new(100.0).reciprocal(), 10, &start)?;
//! let sample = Increment { angle_b: Vector::ZERO, velocity_b: Vector::new(0.0, 0.0, -0.0978) };
//! for _ in 0..4 {
//!     flown.push_by(&sample, &mut |navigator, state, narrowed| navigator.push(state, narrowed))?;
//! }
//! assert!(flown.solution().velocity_ned.z.hi.abs() < 1e-3);
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```

use super::carried::Carried;
use super::catalogue::Entry;
use super::flight::Flight;
use crate::math::compensated::Pair;
use crate::math::real::Scalar;
use crate::output::Output as _;
use crate::record::Record;
use crate::sample::Increment;
use crate::solution::Solution;
use crate::strapdown::limits::{Rejected, StartError};
use crate::strapdown::mechanization::Mechanization;

/// A flight whose samples and initial solution come in double precision. They are narrowed so that no rounding
/// is lost.
#[derive(Clone, Copy)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FromDouble<M: Mechanization> {
    /// The flight.
    pub flight: Flight<M>,
    carried: Carried,
    /// The sum of the intervals taken in less the sum of those handed over, s.
    interval_rest: f64,
}

impl<M: Entry> FromDouble<M> {
    /// For samples of an interval in seconds, with a series of at most this order.
    pub fn start(
        interval_s: Pair<f64>,
        order: usize,
        initial: &Solution<f64>,
    ) -> Result<Self, StartError> {
        Self::new(M::configured(Pair::narrow(interval_s), order)?, initial)
    }
}

impl<M: Mechanization<Real: Scalar, Frame: Record>> FromDouble<M> {
    /// From an initial solution.
    pub fn new(mechanization: M, initial: &Solution<f64>) -> Result<Self, StartError> {
        let flight = Flight::new(mechanization, &Solution::narrow(initial))?;
        Ok(Self { flight, carried: Carried::default(), interval_rest: 0.0 })
    }

    /// Takes a sample by a function: [`Mechanization::push`], or one that reads rows or blocks. A refused sample
    /// changes nothing.
    #[inline]
    pub fn push_by<F>(&mut self, sample: &Increment<f64>, push: &mut F) -> Result<(), Rejected>
    where
        F: FnMut(&M, &mut M::State, Increment<M::Real>) -> Result<(), Rejected>,
    {
        let mut carried = self.carried;
        let sample = carried.narrow(sample);
        self.flight.push_by(sample, push)?;
        self.carried = carried;
        Ok(())
    }

    /// Takes a sample with its own interval in seconds. The function also gets the narrowed interval.
    pub fn push_over_by<F>(
        &mut self,
        sample: &Increment<f64>,
        interval_s: f64,
        push: &mut F,
    ) -> Result<(), Rejected>
    where
        F: FnMut(&M, &mut M::State, Increment<M::Real>, Pair<M::Real>) -> Result<(), Rejected>,
    {
        let exact = Pair::sum(interval_s, self.interval_rest);
        let interval = Pair::<M::Real>::narrow(exact);
        let narrowed = interval.widen_pair();
        self.push_by(sample, &mut |m, state, sample| push(m, state, sample, interval))?;
        self.interval_rest = (exact.hi - narrowed.hi) + (exact.lo - narrowed.lo);
        Ok(())
    }

    /// Mechanization, state and carried rounding, for a flight without the digest.
    pub fn parts_mut(&mut self) -> (&M, &mut M::State, &mut Carried) {
        let (mechanization, state) = self.flight.parts_mut();
        (mechanization, state, &mut self.carried)
    }

    /// Sets height (m) and vertical velocity (down, m/s).
    pub fn hold_vertical(&mut self, altitude_m: f64, down_m_s: f64) -> Result<(), Rejected> {
        self.flight.hold_vertical(M::Real::narrow(altitude_m), M::Real::narrow(down_m_s))
    }

    /// Navigation at the end of the last block.
    pub fn solution(&self) -> Solution<f64> {
        self.flight.output().wide()
    }
}
