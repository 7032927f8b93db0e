//! What came of an alignment, with standard deviations.
//!
//! See [`Fine`](super::fine::Fine) for an example.

use crate::aiding::filter::Filter;
use crate::aiding::gate::Watch;
use crate::aiding::model::{ACCELEROMETER_BIAS, GYRO_BIAS};
use crate::aiding::surroundings::Pose;
use crate::math::real::Scalar;
use crate::math::vector::Vector;
use crate::solution::{Euler, Solution};

/// Attitude and biases.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Aligned<R> {
    /// At the end of the last block, rad.
    pub attitude: Euler<R>,
    /// Velocity at that time, north, east, down, m/s.
    pub velocity_ned: Vector<R>,
    /// The way from the place, north, east, down, m.
    pub way_ned: Vector<R>,
    /// Standard deviation of level about north and about east, rad.
    pub level_sigma: [R; 2],
    /// Standard deviation of the heading, rad.
    pub heading_sigma: R,
    /// Gyro biases and their standard deviations, rad/s.
    pub gyro_bias: [Vector<R>; 2],
    /// Accelerometer biases and their standard deviations, m/s².
    pub accelerometer_bias: [Vector<R>; 2],
    /// Time aligned, s.
    pub seconds: R,
    /// Steps whose measurement was accepted.
    pub accepted: u32,
    /// Steps whose measurement was refused.
    pub refused: u32,
    /// The mean NIS of the accepted ones by its expected value of 3: above 1 the vehicle moves more than it is said
    /// to, by the root of it.
    pub residual: R,
    /// When the vehicle left its place: the time after which a second of measurements had been refused, s.
    pub moved_s: Option<R>,
}

impl<R: Scalar> Aligned<R> {
    pub(super) fn of<const N: usize, const P: usize, const E: usize>(
        filter: &Filter<R, N, P, E>,
        solution: &Solution<R>,
        way_ned: Vector<R>,
        [seconds, moved_s]: [R; 2],
        watch: &Watch<R>,
    ) -> Self {
        let pose = Pose::of(solution);
        let ud = filter.covariance();
        let [north, east, heading] = pose.body_to_ned.rows.map(|axis| filter.sigma_about(axis));
        let three =
            |first: usize| Vector::new(ud.sigma(first), ud.sigma(first + 1), ud.sigma(first + 2));
        Self {
            attitude: solution.euler(),
            velocity_ned: pose.velocity_ned,
            way_ned,
            level_sigma: [north, east],
            heading_sigma: heading,
            gyro_bias: [filter.gyro_bias(), three(GYRO_BIAS)],
            accelerometer_bias: [filter.accelerometer_bias(), three(ACCELEROMETER_BIAS)],
            seconds,
            accepted: watch.accepted(),
            refused: watch.refused(),
            residual: watch.nis() / (R::of(3.0) * R::count(watch.accepted().max(1))),
            moved_s: (moved_s > R::ZERO).then_some(moved_s),
        }
    }

    /// The standard deviation of the residuals where they are as expected: of n of three degrees of freedom, √(2/3n).
    pub fn residual_spread(&self) -> R {
        (R::TWO / (R::of(3.0) * R::count(self.accepted.max(1)))).sqrt()
    }

    /// Whether the residuals are no larger than the standard deviations say: within five of their own, 3n degrees of
    /// freedom of a χ² by its number.
    pub fn fits(&self) -> bool {
        self.residual < R::ONE + R::of(5.0) * self.residual_spread()
    }
}
