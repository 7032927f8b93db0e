//! A navigator under way, with what a report tells of it.

use crate::board::Counter;
use crate::paper::RATE_HZ;
use schuler::digest::Digest;
use schuler::drift::compare::drift;
use schuler::math::compensated::Pair;
use schuler::math::real::Scalar;
use schuler::record::Record;
use schuler::sample::Increment;
use schuler::flight::carried::Carried;
use schuler::solution::Solution;
use schuler::strapdown::frame::Frame;
use schuler::output::Output as _;
use schuler::strapdown::mechanization::Mechanization;
use schuler::strapdown::limits::{Rejected, StartError};
use schuler::strapdown::navigator::Strapdown;
use schuler::flight::configuration::{Axes, Precision};
use schuler::flight::plan;
use schuler::strapdown::block::window::Window;
use schuler::trajectory::Bound;

/// The navigator for the paper's flight, its series of the order that the host plans.
pub fn planned<F: Frame<Real: Scalar>, W: Window>(
    precision: Precision,
    bound: Bound<f64>,
) -> Result<Strapdown<F, W>, StartError> {
    let interval_s = Pair::new(RATE_HZ).reciprocal();
    let demand = plan::Demand {
        bandwidth: bound.bandwidth,
        angular_rate: bound.angular_rate,
        // No order depends on it.
        speed: 0.0,
        interval_s: 1.0 / RATE_HZ,
        precision,
        axes: Axes::LocalLevel,
    };
    let order = plan::order(&demand, W::SHAPE);
    Ok(Strapdown::new(Pair::narrow(interval_s))?.with_order(order))
}

/// The larger; a NaN stays for everyone to see.
pub fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

/// One of the core's mechanizations with its state.
pub struct Navigation<M: Mechanization> {
    mechanization: M,
    state: M::State,
    carried: Carried,
    digest: Digest,
    counts: u64,
    samples: u64,
    /// Distance from the truth at the last block's end, m.
    pub final_m: f64,
    /// The largest distance at any block's end, m.
    pub largest_m: f64,
}

impl<M: Mechanization<Real: Scalar, Frame: Record>> Navigation<M> {
    /// At the start of a flight.
    pub fn new(mechanization: M, initial: &Solution<f64>) -> Result<Self, StartError> {
        let state = mechanization.start(&Solution::narrow(initial))?;
        Ok(Self {
            mechanization,
            state,
            carried: Carried::default(),
            digest: Digest::default(),
            counts: 0,
            samples: 0,
            final_m: 0.0,
            largest_m: 0.0,
        })
    }

    /// Takes a sample, narrowed with the rest of those before it.
    #[inline(never)]
    pub fn push(&mut self, counter: &Counter, sample: &Increment<f64>) -> Result<(), Rejected> {
        let sample = self.carried.narrow(sample);
        let before = M::integrated(&self.state);
        let from = counter.now();
        let pushed = self.mechanization.push(&mut self.state, sample);
        let to = counter.now();
        pushed?;
        self.counts += u64::from(counter.between(from, to));
        self.samples += 1;
        if M::integrated(&self.state) != before {
            self.digest.add(M::frame(&self.state));
        }
        Ok(())
    }

    /// Compares with the truth at the end of the last block.
    pub fn compare(&mut self, truth: &Solution<f64>) {
        self.final_m = drift(&self.solution(), truth).position_ned.norm();
        self.largest_m = larger(self.final_m, self.largest_m);
    }

    /// Navigation at the end of the last block.
    pub fn solution(&self) -> Solution<f64> {
        self.mechanization.output(&self.state).wide()
    }

    /// Ends the flight, and returns the digest of every state.
    pub fn finish(&mut self) -> u64 {
        self.mechanization.finish_rows(&mut self.state, |_, _| ());
        self.digest.add(M::frame(&self.state));
        self.digest.value()
    }

    /// What a sample cost on average, in the board's unit.
    pub fn cost(&self, counter: &Counter) -> f64 {
        counter.worth(self.counts) / self.samples.max(1) as f64
    }
}
