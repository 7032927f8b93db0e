//! A flight that measurements aid, at the end of a link: bridging, navigation, filter, digest.
//!
//! Target and host fly the same code, so that the same samples and measurements leave the same bits. It starts as any
//! flight does, and then waits for the settings of its filter.
//!
//! ```
//! use schuler::aiding::aided::instant::Instant;
//! use schuler::aiding::aided::measured::Measured;
//! use schuler::aiding::aided::settings::{Settings, Start, States};
//! use schuler::aiding::states::Process;
//! use schuler::link::aided::{Linked, LinkedAided};
//! use schuler::link::flight::Taken;
//! use schuler::link::gap::Policy;
//! use schuler::link::refusal::Refusal;
//! use schuler::prelude::*;
//!
//! let start = Solution::new(Geodetic::default(), Vector::ZERO, Euler::default());
//! let navigator = Navigator4::<f64>::from_rate_hz(100.0)?;
//! let mut flight: Linked<Navigator4<f64>> =
//!     LinkedAided::new(navigator, Pair::of(0.01), start, Policy::Refuse)?;
//! assert_eq!(flight.take(1, Increment::ZERO, &mut ()), Err(Refusal::Unaided));
//!
//! let bias = [5e-5, 1e-3].map(Process::constant);
//! let first = Start { position_m: 1.0, velocity_m_s: 0.1, level_rad: 3e-3, heading_rad: 0.03 };
//! flight.aid(&Settings::new(States::new(3e-5, 8e-4, bias[0], bias[1]), first))?;
//! flight.measure(1, &Measured::zero_velocity(Instant::of_sample(1), 0.1))?;
//! assert_eq!(flight.take(1, Increment::ZERO, &mut ()), Ok(Taken::Flown));
//! assert!(flight.flying().is_some_and(|(_, state)| state.queue().waiting().len() == 1));
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```

use super::count::Count;
use super::flight::Taken;
use super::gap::{Bridge, Policy};
use super::refusal::Refusal;
use crate::aiding::aided::fault::AidedFault;
use crate::aiding::aided::measured::Measured;
use crate::aiding::aided::navigator::Aided;
use crate::aiding::aided::settings::Settings;
use crate::aiding::aided::state::AidedState;
use crate::aiding::aided::verdict::Witness;
use crate::digest::Digest;
use crate::flight::catalogue::Entry;
use crate::math::compensated::Pair;
use crate::math::real::{Real, Scalar};
use crate::record::Record;
use crate::sample::Increment;
use crate::solution::Solution;
use crate::strapdown::block::body::BodyMotion;

/// With room for every state; of 64 steps, six seconds, are remembered, and 32 measurements may wait.
pub type Linked<M> = LinkedAided<M, 21, 231, 6, 64, 32>;

/// An aided flight with what the link needs beside it.
#[derive(Clone, Copy)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LinkedAided<
    M: Entry,
    const N: usize,
    const P: usize,
    const E: usize,
    const L: usize,
    const Q: usize,
> {
    pub(super) stage: Stage<M, N, P, E, L, Q>,
    pub(super) digest: Digest,
    pub(super) bridge: Bridge<M::Real>,
    pub(super) count: Count,
    /// Number of the last measurement.
    pub(super) measured: u32,
}

/// Before its settings, and after them. Nothing is on a heap.
#[allow(clippy::large_enum_variant)]
#[derive(Clone, Copy)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) enum Stage<
    M: Entry,
    const N: usize,
    const P: usize,
    const E: usize,
    const L: usize,
    const Q: usize,
> {
    Waiting {
        mechanization: M,
        interval_s: Pair<M::Real>,
        initial: Solution<M::Real>,
        state: M::State,
    },
    Flying {
        aided: Aided<M, N, P, E, L, Q>,
        state: AidedState<M, N, P, E, L, Q>,
    },
}

impl<R, M, const N: usize, const P: usize, const E: usize, const L: usize, const Q: usize>
    LinkedAided<M, N, P, E, L, Q>
where
    R: Scalar + Real<Mask = bool> + Record,
    M: Entry<Real = R, Body = BodyMotion<R>>,
{
    /// From an initial solution; it waits for its settings.
    pub fn new(
        mechanization: M,
        interval_s: Pair<R>,
        initial: Solution<R>,
        gap: Policy,
    ) -> Result<Self, Refusal> {
        let state = mechanization.start(&initial)?;
        Ok(Self {
            stage: Stage::Waiting { mechanization, interval_s, initial, state },
            digest: Digest::default(),
            bridge: Bridge::new(gap),
            count: Count::default(),
            measured: 0,
        })
    }

    /// Takes the settings. A flight that has them keeps them.
    pub fn aid(&mut self, settings: &Settings<R>) -> Result<(), Refusal> {
        if let Stage::Waiting { mechanization, interval_s, initial, .. } = self.stage {
            let aided = Aided::new(mechanization, interval_s, *settings)?;
            let state = aided.start(&initial)?;
            self.stage = Stage::Flying { aided, state };
        }
        Ok(())
    }

    /// Takes the measurement of a number, from 1. What a sensor says again, too late, or without room for it is
    /// counted.
    pub fn measure(&mut self, number: u32, measured: &Measured<R>) -> Result<Taken, Refusal> {
        if number <= self.measured {
            return Ok(Taken::Again);
        }
        self.count.goes_on()?;
        let Stage::Flying { aided, state } = &mut self.stage else {
            return Err(Refusal::Unaided);
        };
        match aided.measure(state, measured) {
            Ok(()) | Err(AidedFault::Late | AidedFault::Again | AidedFault::Full) => {}
            Err(fault) => return Err(fault.into()),
        }
        self.measured = number;
        Ok(Taken::Flown)
    }

    /// Takes the sample of a number, from 1. Refused, it leaves everything as it was.
    pub fn take(
        &mut self,
        number: u32,
        sample: Increment<R>,
        witness: &mut impl Witness<R, N, P, E>,
    ) -> Result<Taken, Refusal> {
        let Some(missing) = self.count.before(number)? else { return Ok(Taken::Again) };
        self.fly(missing, Some(sample), witness)?;
        self.count.take(number, missing);
        Ok(Taken::Flown)
    }

    /// Ends the stream after this number of samples: what waits is taken.
    pub fn finish(
        &mut self,
        samples: u32,
        witness: &mut impl Witness<R, N, P, E>,
    ) -> Result<Taken, Refusal> {
        let Some(missing) = self.count.before_end(samples)? else { return Ok(Taken::Again) };
        self.fly(missing, None, witness)?;
        if let Stage::Flying { aided, state } = &mut self.stage {
            aided.finish(state, witness);
            self.digest.add(M::frame(state.navigator()));
            self.digest.add(state.filter());
        }
        self.count.end(samples, missing);
        Ok(Taken::Flown)
    }

    /// Flies a sample after those that are missing before it; none ends the stream.
    #[inline(never)]
    fn fly(
        &mut self,
        missing: u32,
        sample: Option<Increment<R>>,
        witness: &mut impl Witness<R, N, P, E>,
    ) -> Result<(), Refusal> {
        if missing > 0 {
            return self.fly_over_gap(missing, sample, witness);
        }
        // A sample that is refused changes no state.
        let before = self.bridge;
        let flown = self.pass(0, sample, witness);
        if flown.is_err() {
            self.bridge = before;
        }
        flown
    }

    /// Several samples, or none of them; apart, because it keeps a copy of everything.
    #[inline(never)]
    fn fly_over_gap(
        &mut self,
        missing: u32,
        sample: Option<Increment<R>>,
        witness: &mut impl Witness<R, N, P, E>,
    ) -> Result<(), Refusal> {
        let before = *self;
        let flown = self.pass(missing, sample, witness);
        if flown.is_err() {
            *self = before;
        }
        flown
    }

    fn pass(
        &mut self,
        missing: u32,
        sample: Option<Increment<R>>,
        witness: &mut impl Witness<R, N, P, E>,
    ) -> Result<(), Refusal> {
        let Self { stage, bridge, digest, .. } = self;
        let Stage::Flying { aided, state } = stage else { return Err(Refusal::Unaided) };
        let mut push = |sample: &Increment<R>| {
            let before = state.integrated();
            aided.push_seen(state, *sample, witness)?;
            if state.integrated() != before {
                digest.add(M::frame(state.navigator()));
            }
            Ok::<(), Refusal>(())
        };
        for _ in 0..missing {
            bridge.take(None, &mut push)?;
        }
        match sample {
            Some(_) => bridge.take(sample, &mut push),
            None => bridge.finish(&mut push),
        }
    }

    /// The navigator and its state; `None` while it waits for its settings.
    pub fn flying(&self) -> Option<(&Aided<M, N, P, E, L, Q>, &AidedState<M, N, P, E, L, Q>)> {
        match &self.stage {
            Stage::Flying { aided, state } => Some((aided, state)),
            Stage::Waiting { .. } => None,
        }
    }

    /// Number of the last sample taken, or filled in.
    pub fn taken(&self) -> u32 {
        self.count.taken()
    }

    /// Of the last 32 samples a bit each, the newest lowest: whether it came.
    pub fn came(&self) -> u32 {
        self.count.came()
    }

    /// Samples that lie behind the solution.
    pub fn integrated(&self) -> u64 {
        self.flying().map_or(0, |(_, state)| state.integrated())
    }

    /// Digest of every state of the navigator so far, and of the filter at the end.
    pub fn digest(&self) -> u64 {
        self.digest.value()
    }

    /// Navigation at the end of the last block.
    pub fn output(&self) -> M::Output {
        match &self.stage {
            Stage::Flying { aided, state } => aided.output(state),
            Stage::Waiting { mechanization, state, .. } => mechanization.output(state),
        }
    }
}
