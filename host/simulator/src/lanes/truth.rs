//! Perfect increments of samples side by side, one in each lane: the bits of each alone.

use super::pack::{Lanes, Task};
use super::{InLanes, Registers, in_registers};
use schuler::imu::Quadrature;
use schuler::math::compensated::Pair;
use schuler::math::real::Real;
use schuler::math::vector::Vector;
use schuler::sample::Increment;
use schuler::trajectory::harmonic::HarmonicTrajectory;
use schuler::trajectory::{Bound, Motion, Trajectory};
use std::array;
use std::marker::PhantomData;

/// Perfect increments to work out, of samples from the number `first` on.
pub struct Truth<'a, const H: usize> {
    /// The motion.
    pub course: &'a HarmonicTrajectory<f64, H>,
    /// The quadrature of its rates.
    pub quadrature: Quadrature,
    /// Samples per second.
    pub rate_hz: f64,
    /// The number of the first, from 1.
    pub first: u64,
    /// Where they go.
    pub increments: &'a mut [Increment<f64>],
}

impl<const H: usize> Truth<'_, H> {
    /// In the widest registers that are there; whether there are any.
    pub fn work_out(self) -> bool {
        let widest = [Registers::Avx512, Registers::Avx2].into_iter().find(|r| r.are_there());
        widest.is_some_and(|registers| in_registers(registers, self).is_some())
    }
}

impl<const H: usize> InLanes for Truth<'_, H> {
    type Output = ();
    fn run<P: Lanes<N>, const N: usize>(self) {
        P::compiled(TruthIn::<P, H, N>(self, PhantomData));
    }
}

/// The same in lanes of one kind.
struct TruthIn<'a, P, const H: usize, const N: usize>(Truth<'a, H>, PhantomData<P>);

impl<P: Lanes<N>, const H: usize, const N: usize> Task for TruthIn<'_, P, H, N> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let Truth { course, quadrature, rate_hz, mut first, increments } = self.0;
        let course = AtOnce(course);
        for increments in increments.chunks_mut(N) {
            let numbers = array::from_fn(|lane| (first + lane as u64) as f64);
            let numbers = P::from_lanes(numbers);
            let Increment { angle_b: a, velocity_b: v } =
                quadrature.samples::<P, _>(&course, numbers, P::of(rate_hz));
            let angle = [a.x.lanes(), a.y.lanes(), a.z.lanes()];
            let velocity = [v.x.lanes(), v.y.lanes(), v.z.lanes()];
            for (lane, increment) in increments.iter_mut().enumerate() {
                increment.angle_b = of_lane(&angle, lane);
                increment.velocity_b = of_lane(&velocity, lane);
            }
            first += N as u64;
        }
    }
}

/// What is in one lane.
#[inline(always)]
fn of_lane<const N: usize>([x, y, z]: &[[f64; N]; 3], lane: usize) -> Vector<f64> {
    Vector { x: x[lane], y: y[lane], z: z[lane] }
}

/// A course at several times at once.
struct AtOnce<'a, const H: usize>(&'a HarmonicTrajectory<f64, H>);

impl<P: Real, const H: usize> Trajectory<P> for AtOnce<'_, H> {
    #[inline(always)]
    fn at_instant(&self, time_s: Pair<P>) -> Motion<P> {
        self.0.at_instants(time_s, P::of)
    }
    fn bound(&self) -> Bound<P> {
        let Bound { bandwidth, angular_rate } = self.0.bound();
        Bound { bandwidth: P::of(bandwidth), angular_rate: P::of(angular_rate) }
    }
}
