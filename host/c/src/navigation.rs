//! What every navigator does, once for all of them. The functions of `navigators` follow the caller's pointers
//! and call these.

use crate::digest::Running;
use crate::held::Keep;
use crate::results::Code;
use crate::values::{Plain, pairs};
use schuler::flight::catalogue::Entry;
use schuler::flight::configuration::Configuration;
use schuler::flight::plan::HIGHEST_ORDER;
use schuler::math::compensated::Pair;
use schuler::math::quaternion::Quaternion;
use schuler::math::real::Scalar;
use schuler::output::Output as _;
use schuler::sample::{Increment, Rates};
use schuler::solution::Solution;
use schuler::strapdown::mechanization::{Mechanization, UnequalIntervals};

/// A navigator under way.
#[derive(Clone, Copy)]
pub(crate) struct Navigation<M: Mechanization> {
    pub(crate) mechanization: M,
    pub(crate) state: M::State,
    pub(crate) interval_s: Pair<M::Real>,
    /// Of its series, at most.
    pub(crate) order: u32,
}

/// A navigator with a number of its own.
pub(crate) trait Numbered: Entry<Real: Plain> {
    /// Whether it takes samples of any length.
    const ANY_INTERVAL: bool;
}

/// A configuration as a number. What it has fewer than 16 of takes four bits.
const fn number(configuration: &Configuration, any_interval: bool) -> u32 {
    let Configuration { precision, axes, algorithm, window } = *configuration;
    (precision as u32) << 28
        | (axes as u32) << 24
        | (algorithm as u32) << 20
        | (any_interval as u32) << 16
        | (window.history as u32) << 12
        | (window.block as u32) << 4
        | window.lookahead as u32
}

impl<M: Numbered> Keep for Navigation<M> {
    const KIND: u32 = number(&M::CONFIGURATION, M::ANY_INTERVAL);
}

/// The order that 0 stands for: no window's series has more.
fn order(order: u32) -> u32 {
    if order == 0 { HIGHEST_ORDER as u32 } else { order }
}

/// On the equator, level, at rest.
pub(crate) fn level<R: Scalar>() -> Solution<R> {
    Solution { attitude: Quaternion::IDENTITY.map(Pair::new), ..Solution::default() }
}

impl<M: Numbered> Navigation<M> {
    /// From a rate and a solution in double precision.
    #[inline(never)]
    pub(crate) fn start(rate_hz: f64, order: u32, initial: &Solution<f64>) -> Result<Self, Code> {
        let interval_s = Pair::narrow(Pair::new(rate_hz).reciprocal());
        Self::start_own(interval_s, order, &Solution::narrow(initial))
    }

    /// From an interval and a solution of the navigator's own precision.
    #[inline(never)]
    pub(crate) fn start_own(
        interval_s: Pair<M::Real>,
        most: u32,
        initial: &Solution<M::Real>,
    ) -> Result<Self, Code> {
        let order = order(most);
        let mechanization = M::configured(interval_s, order as usize)?;
        let state = mechanization.start(initial)?;
        Ok(Self { mechanization, state, interval_s, order })
    }

    /// On the equator, level, at rest, at 100 Hz: for the tests.
    #[cfg(not(feature = "archive"))]
    pub(crate) fn level() -> Result<Self, Code> {
        Self::start(100.0, 0, &level())
    }

    /// Takes a sample: one copy of the step, for every function that ends in it.
    #[inline(never)]
    pub(crate) fn push(&mut self, sample: Increment<M::Real>) -> Result<(), Code> {
        Ok(self.mechanization.push(&mut self.state, sample)?)
    }

    /// Takes a sample from the rates at its start and at its end.
    pub(crate) fn push_rates(
        &mut self,
        start: &Rates<M::Real>,
        end: &Rates<M::Real>,
    ) -> Result<(), Code> {
        self.push(Increment::from_rates(start, end, self.interval_s))
    }

    /// Integrates what waits for look-ahead.
    pub(crate) fn finish(&mut self) {
        finish(&self.mechanization, &mut self.state);
    }

    /// Samples behind the last block's end.
    pub(crate) fn integrated(&self) -> u64 {
        M::integrated(&self.state)
    }

    /// Adds the state to a digest if a block has been completed since the last time, or if it is to be in any case.
    #[inline(never)]
    pub(crate) fn digest(&self, running: &mut Running, always: bool) {
        let integrated = self.integrated();
        if always || integrated != running.integrated {
            running.digest.add(M::frame(&self.state));
            running.integrated = integrated;
        }
    }

    /// At the end of the last block, in double precision.
    pub(crate) fn read(&self) -> [Pair<f64>; 10] {
        wide::<M>(&self.output())
    }

    /// The same in the navigator's own precision and axes.
    pub(crate) fn read_own(&self) -> [Pair<M::Real>; 10] {
        pairs(&self.output())
    }

    fn output(&self) -> M::Output {
        self.mechanization.output(&self.state)
    }

    /// At the newest sample.
    #[inline(never)]
    fn ahead(&self) -> M::Output {
        let mut ahead = self.state;
        finish(&self.mechanization, &mut ahead);
        self.mechanization.output(&ahead)
    }

    /// At the newest sample, in double precision.
    pub(crate) fn predict(&self) -> [Pair<f64>; 10] {
        wide::<M>(&self.ahead())
    }

    /// The same in the navigator's own precision and axes.
    pub(crate) fn predict_own(&self) -> [Pair<M::Real>; 10] {
        pairs(&self.ahead())
    }

    /// Corrects the state at the end of the last block.
    pub(crate) fn correct(
        &mut self,
        correction: <M::Real as Plain>::Correction,
    ) -> Result<(), Code> {
        Ok(self.mechanization.correct(&mut self.state, &correction.into())?)
    }

    /// Holds height (m) and vertical velocity (down, m/s).
    pub(crate) fn hold_vertical(&mut self, altitude: M::Real, down: M::Real) -> Result<(), Code> {
        Ok(self.mechanization.hold_vertical(&mut self.state, altitude, down)?)
    }
}

/// One copy of it, too.
#[inline(never)]
fn finish<M: Mechanization>(mechanization: &M, state: &mut M::State) {
    mechanization.finish(state);
}

/// In local axes and double precision.
#[inline(never)]
fn wide<M: Numbered>(output: &M::Output) -> [Pair<f64>; 10] {
    pairs(&output.wide())
}

impl<M: Numbered + UnequalIntervals> Navigation<M> {
    /// Takes a sample of its own interval in seconds.
    #[inline(never)]
    pub(crate) fn push_over(
        &mut self,
        sample: Increment<M::Real>,
        interval_s: Pair<M::Real>,
    ) -> Result<(), Code> {
        Ok(self.mechanization.push_over(&mut self.state, sample, interval_s)?)
    }

    /// The same from rates.
    pub(crate) fn push_rates_over(
        &mut self,
        start: &Rates<M::Real>,
        end: &Rates<M::Real>,
        interval_s: Pair<M::Real>,
    ) -> Result<(), Code> {
        self.push_over(Increment::from_rates(start, end, interval_s), interval_s)
    }
}
