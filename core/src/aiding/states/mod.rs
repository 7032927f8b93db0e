//! States beside position, velocity and attitude: what they do over time, and where their estimates go.
//!
//! | file | what it has |
//! |---|---|
//! | [`constant`], [`random_walk`], [`gauss_markov`] | what one number does over time |
//! | [`resonator`] | the displacement of a swaying vehicle |
//! | [`lever_arm`] | from the unit to the sensor that measures |
//! | [`scale`] | the scale factor of a speed |
//! | [`latency`] | how late a measurement is |
//!
//! ```
//! use schuler::aiding::covariance::ud::Ud;
//! use schuler::aiding::states::Process;
//!
//! let mut ud = Ud::<f64, 1, 1>::diagonal([2.0]);
//! // A tenth of a unit per √s for 25 s: 4 + 0.25.
//! Process::random_walk(2.0, 0.1).advance(&mut ud, 0, 25.0);
//! assert!((ud.variance(0) - 4.25).abs() < 1e-12);
//! ```

pub mod constant;
pub mod gauss_markov;
pub mod latency;
pub mod lever_arm;
pub mod random_walk;
pub mod resonator;
pub mod scale;

use crate::aiding::covariance::ud::Ud;
use crate::aiding::surroundings::Pose;
use crate::aiding::transition::Transition;
use crate::math::real::Real;
use constant::Constant;
use gauss_markov::GaussMarkov;
use latency::Latency;
use lever_arm::LeverArm;
use random_walk::RandomWalk;
use resonator::Resonator;
use scale::Scale;

/// What one number does over time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Process<R> {
    /// Nothing.
    Constant(Constant<R>),
    /// A random walk.
    RandomWalk(RandomWalk<R>),
    /// A Gauss-Markov process of first order.
    GaussMarkov(GaussMarkov<R>),
}

impl<R: Real> Process<R> {
    /// A constant with its standard deviation at the start. 0 is legal: the number is known.
    pub const fn constant(sigma: R) -> Self {
        Self::Constant(Constant { sigma })
    }

    /// A random walk with its standard deviation at the start, and its growth in units per √s.
    pub const fn random_walk(sigma: R, per_root_s: R) -> Self {
        Self::RandomWalk(RandomWalk { sigma, per_root_s })
    }

    /// A stationary Gauss-Markov process with its rms and its correlation time in seconds.
    pub const fn gauss_markov(rms: R, correlation_s: R) -> Self {
        Self::GaussMarkov(GaussMarkov { rms, correlation_s })
    }

    /// The standard deviation at the start.
    pub fn sigma(&self) -> R {
        match self {
            Self::Constant(x) => x.sigma,
            Self::RandomWalk(x) => x.sigma,
            Self::GaussMarkov(x) => x.rms,
        }
    }

    /// Carries the covariance of one state on; the result is the factor for its estimate.
    pub fn advance<const N: usize, const P: usize>(
        &self,
        ud: &mut Ud<R, N, P>,
        state: usize,
        time_s: R,
    ) -> R {
        match self {
            Self::Constant(_) => R::ONE,
            Self::RandomWalk(x) => x.advance(ud, state, time_s),
            Self::GaussMarkov(x) => x.advance(ud, state, time_s),
        }
    }
}

/// A group of further states of a filter. Errors are computed less true.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Extra<R> {
    /// One number, such as a barometer's bias.
    Number(Process<R>),
    /// The displacement of a swaying vehicle: six states.
    Resonator(Resonator<R>),
    /// A lever arm: three states.
    LeverArm(LeverArm<R>),
    /// The scale factor of a speed.
    Scale(Scale<R>),
    /// The latency of a measurement.
    Latency(Latency<R>),
}

impl<R: Real> Extra<R> {
    /// The number of its states.
    pub const fn states(&self) -> usize {
        match self {
            Self::Number(_) | Self::Scale(_) | Self::Latency(_) => 1,
            Self::LeverArm(_) => LeverArm::<R>::STATES,
            Self::Resonator(_) => Resonator::<R>::STATES,
        }
    }

    /// The standard deviation of one of its states at the start.
    pub fn sigma(&self, state: usize) -> R {
        match self {
            Self::Number(x) => x.sigma(),
            Self::Resonator(x) => x.sigma(state),
            Self::LeverArm(x) => x.sigma,
            Self::Scale(x) => x.process().sigma(),
            Self::Latency(x) => x.sigma_s,
        }
    }

    /// Carries covariance and estimate on over a step; the result is the factor of a single number.
    pub fn advance<const N: usize, const P: usize>(
        &self,
        ud: &mut Ud<R, N, P>,
        first: usize,
        estimate: &mut [R],
        transition: &Transition<R>,
    ) -> R {
        let process = match self {
            Self::Resonator(x) => {
                x.advance(ud, first, estimate, transition);
                return R::ONE;
            }
            Self::LeverArm(_) | Self::Latency(_) => return R::ONE,
            Self::Number(process) => *process,
            Self::Scale(x) => x.process(),
        };
        let factor = process.advance(ud, first, transition.time_s());
        for estimate in estimate {
            *estimate = *estimate * factor;
        }
        factor
    }

    /// Takes the estimated errors off the estimates.
    pub fn feed(&self, estimate: &mut [R], errors: &[R], pose: &Pose<R>) {
        if let Self::Resonator(_) = self {
            return Resonator::feed(estimate, errors, pose);
        }
        for (estimate, error) in estimate.iter_mut().zip(errors) {
            *estimate = *estimate - *error;
        }
    }
}
