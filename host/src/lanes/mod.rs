//! Four independent runs on one core: each lane of a vector register flies one.
//!
//! The core's generic code is compiled for a pack of runs in memory and for one in AVX2 registers; the
//! processor decides at run time. Each lane has the bits of its run flown alone.

#[cfg(target_arch = "x86_64")]
mod avx2;
pub mod pack;

use pack::{Lanes, RUNS};
use schuler::math::compensated::Pair;
use schuler::math::vector::Vector;
use schuler::sample::Increment;
use schuler::solution::{EarthFixedSolution, Solution};
use schuler::strapdown::frame::Frame;
use schuler::strapdown::mechanization::{Rejected, StartError};
use schuler::strapdown::navigator::{State, Strapdown};
use schuler::strapdown::window::Window;
use std::array;

/// Keeps [`Lanes`] in this house.
mod sealed {
    pub trait Sealed {}
}

/// What can be done in lanes of any kind.
pub trait InLanes {
    /// What comes of it.
    type Output;
    /// Does it in lanes of this kind.
    fn run<P: Lanes>(self) -> Self::Output;
}

/// Does it in AVX2 registers, if the processor has them.
pub fn in_registers<T: InLanes>(task: T) -> Option<T::Output> {
    #[cfg(target_arch = "x86_64")]
    if is_x86_feature_detected!("avx2") {
        return Some(task.run::<avx2::Avx2>());
    }
    drop(task);
    None
}

/// Four runs in flight: in frame `F` over a pack, with window `W`.
#[derive(Clone, Copy)]
pub struct Abreast<F: Frame, W: Window> {
    strapdown: Strapdown<F, W>,
    state: State<F, W>,
}

impl<P, F, W> Abreast<F, W>
where
    P: Lanes,
    F: Frame<Real = P, Output: Split>,
    W: Window,
{
    /// Starts every run from its initial solution, with a sampling interval in seconds and series of
    /// the given order.
    pub fn start(
        interval_s: Pair<f64>,
        order: usize,
        initial: &[Solution<f64>; RUNS],
    ) -> Result<Self, StartError> {
        let same = |x: f64| P::from_lanes([x; RUNS]);
        let interval_s = Pair { hi: same(interval_s.hi), lo: same(interval_s.lo) };
        let strapdown = Strapdown::new(interval_s)?.with_order(order);
        let state = strapdown.start(&join(initial))?;
        Ok(Self { strapdown, state })
    }

    /// Takes samples, each of every run; stops before one that is wrong in any lane and says how many
    /// were taken.
    pub fn push(&mut self, samples: &[Increment<P>]) -> Result<(), Refused> {
        #[cfg(target_arch = "x86_64")]
        if P::AVX2 {
            // SAFETY: it needs AVX2 and nothing else, and `in_registers` asked the processor for it.
            return unsafe { push_avx2(&self.strapdown, &mut self.state, samples) };
        }
        push(&self.strapdown, &mut self.state, samples)
    }

    /// Integrates what is pending: the streams are at their end.
    pub fn finish(&mut self) {
        self.strapdown.finish(&mut self.state);
    }

    /// Samples of each run that were integrated so far.
    pub fn integrated(&self) -> u64 {
        self.state.integrated()
    }

    /// Navigation of every run at the end of the last block.
    pub fn output(&self) -> [<F::Output as Split>::Alone; RUNS] {
        self.state.output().split()
    }
}

/// A sample that some lane could not take. The state is that after the samples before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Refused {
    /// Samples of this call that were taken.
    pub taken: usize,
    /// Why the next one was not.
    pub reason: Rejected,
}

impl std::fmt::Display for Refused {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "after {} samples: {}", self.taken, self.reason)
    }
}

impl std::error::Error for Refused {}

/// Everything below is inlined into its caller, and so compiled for the caller's vector unit.
#[inline(always)]
fn push<F: Frame, W: Window>(
    strapdown: &Strapdown<F, W>,
    state: &mut State<F, W>,
    samples: &[Increment<F::Real>],
) -> Result<(), Refused> {
    for (taken, &sample) in samples.iter().enumerate() {
        strapdown.push(state, sample).map_err(|reason| Refused { taken, reason })?;
    }
    Ok(())
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn push_avx2<F: Frame, W: Window>(
    strapdown: &Strapdown<F, W>,
    state: &mut State<F, W>,
    samples: &[Increment<F::Real>],
) -> Result<(), Refused> {
    push(strapdown, state, samples)
}

/// The samples of all runs as one.
#[inline]
pub fn pack<P: Lanes>(samples: &[Increment<f64>; RUNS]) -> Increment<P> {
    let join = |part: fn(&Increment<f64>) -> Vector<f64>| {
        let parts = samples.each_ref().map(part);
        Vector {
            x: P::from_lanes(parts.map(|v| v.x)),
            y: P::from_lanes(parts.map(|v| v.y)),
            z: P::from_lanes(parts.map(|v| v.z)),
        }
    };
    Increment { angle_b: join(|s| s.angle_b), velocity_b: join(|s| s.velocity_b) }
}

/// The solutions of all runs as one.
fn join<P: Lanes>(runs: &[Solution<f64>; RUNS]) -> Solution<P> {
    let numbers = runs.each_ref().map(numbers);
    let mut next = 0;
    let mut take = |_: Pair<P>| {
        let lanes = |part: fn(Pair<f64>) -> f64| P::from_lanes(numbers.map(|run| part(run[next])));
        let pair = Pair { hi: lanes(|x| x.hi), lo: lanes(|x| x.lo) };
        next += 1;
        pair
    };
    let joined = Solution::default();
    Solution {
        position: joined.position.map(&mut take),
        velocity_ned: joined.velocity_ned.map(&mut take),
        attitude: joined.attitude.map(&mut take),
    }
}

/// The numbers of a solution in order.
fn numbers(solution: &Solution<f64>) -> [Pair<f64>; 10] {
    let (r, v, q) = (solution.position, solution.velocity_ned, solution.attitude);
    [r.latitude, r.longitude, r.altitude, v.x, v.y, v.z, q.w, q.v.x, q.v.y, q.v.z]
}

/// What holds a number of every run, and comes apart into what each would hold alone.
pub trait Split {
    /// The same of a run flown alone.
    type Alone;
    /// Of every run.
    fn split(&self) -> [Self::Alone; RUNS];
}

fn lane<P: Lanes>(run: usize) -> impl Fn(Pair<P>) -> Pair<f64> + Copy {
    move |x| Pair { hi: x.hi.lanes()[run], lo: x.lo.lanes()[run] }
}

impl<P: Lanes> Split for Solution<P> {
    type Alone = Solution<f64>;
    fn split(&self) -> [Solution<f64>; RUNS] {
        array::from_fn(|run| Solution {
            position: self.position.map(lane(run)),
            velocity_ned: self.velocity_ned.map(lane(run)),
            attitude: self.attitude.map(lane(run)),
        })
    }
}

impl<P: Lanes> Split for EarthFixedSolution<P> {
    type Alone = EarthFixedSolution<f64>;
    fn split(&self) -> [EarthFixedSolution<f64>; RUNS] {
        array::from_fn(|run| EarthFixedSolution {
            position_e: self.position_e.map(lane(run)),
            velocity_e: self.velocity_e.map(lane(run)),
            attitude: self.attitude.map(lane(run)),
        })
    }
}
