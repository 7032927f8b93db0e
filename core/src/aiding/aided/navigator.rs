//! The navigator with its filter: samples and measurements in, position, velocity, attitude and their σ out.
//!
//! ```
//! use schuler::aiding::aided::instant::Instant;
//! use schuler::aiding::aided::measured::{Measured, Sensor};
//! use schuler::aiding::aided::navigator::Aided15;
//! use schuler::aiding::aided::settings::{Settings, Start, States};
//! use schuler::aiding::states::Process;
//! use schuler::prelude::*;
//!
//! // A vehicle that stands on the equator. The navigator starts 3 m too far north.
//! let truth = Geodetic { latitude: 0.0, longitude: 0.1, altitude: 0.0 };
//! let wrong = Geodetic { latitude: 3.0 / 6_335_439.0, ..truth };
//! let bias = [5e-5_f64, 1e-3].map(Process::constant);
//! let start = Start { position_m: 5.0, velocity_m_s: 0.1, level_rad: 3e-3, heading_rad: 0.03 };
//! let settings = Settings::new(States::new(3e-5, 8e-4, bias[0], bias[1]), start);
//! let navigator = Navigator4::from_rate_hz(100.0)?;
//! let aided = Aided15::new(navigator, Pair::of(0.01), settings)?;
//! let mut state = aided.start(&Solution::new(wrong, Vector::ZERO, Euler::default()))?;
//! let sample = Increment {
//!     angle_b: Vector::new(7.292115e-7, 0.0, 0.0),
//!     velocity_b: Vector::new(0.0, 0.0, -9.7803253359 * 0.01),
//! };
//! for k in 1..=500 {
//!     if k % 100 == 0 {
//!         let sigma = Vector::new(0.5, 0.5, 0.5);
//!         let fix = Measured::position(Instant::of_sample(k), truth.map(Pair::new), sigma);
//!         aided.measure(&mut state, &fix)?;
//!     }
//!     aided.push(&mut state, sample)?;
//! }
//! let north_m = aided.solution(&state).position.latitude.hi * 6_335_439.0;
//! let sigma = aided.sigma_ned(&state);
//! assert!(north_m.abs() < sigma[0] && sigma[0] < 0.5);
//! assert_eq!(state.tally(Sensor::Gnss).accepted(), 5);
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```

use super::anchor::Anchor;
use super::fault::AidedFault;
use super::instant::Instant;
use super::locality::Reference;
use super::measured::Measured;
use super::queue::Queue;
use super::ring::{Entry, Ring};
use super::settings::{Limits, Places, Settings, Start};
use super::state::{AidedState, Taken};
use super::tally::{Tally, Transport};
use crate::aiding::alignment::search::Search;
use crate::aiding::filter::{Fading, Filter};
use crate::aiding::model::Model;
use crate::aiding::surroundings::Pose;
use crate::aiding::transition::Stretch;
use crate::math::compensated::Pair;
use crate::math::real::{Real, Scalar};
use crate::math::vector::Vector;
use crate::output::Output;
use crate::solution::Solution;
use crate::strapdown::block::body::BodyMotion;
use crate::strapdown::mechanization::Mechanization;
use crate::strapdown::plausible::Damaged;

/// Samples that a measurement may be ahead of the newest one.
const AHEAD: u64 = 4096;

/// An aided navigator by a mechanization: configuration. Its filter has `N` = 15 + `E` states and `P` = N(N + 1)/2
/// numbers of covariance; `L` steps are remembered, `Q` measurements may wait.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Aided<
    M: Mechanization,
    const N: usize,
    const P: usize,
    const E: usize,
    const L: usize,
    const Q: usize,
> {
    pub(super) mechanization: M,
    pub(super) interval: Pair<M::Real>,
    pub(super) settings: Settings<M::Real>,
    pub(super) model: Model<M::Real>,
    pub(super) places: Places,
    pub(super) limits: Limits<M::Real>,
}

/// Position, velocity, attitude and biases; measurements up to about three seconds late.
pub type Aided15<M> = Aided<M, 15, 120, 0, 32, 16>;
/// With room for every further state.
pub type Aided21<M> = Aided<M, 21, 231, 6, 32, 16>;

impl<R, M, const N: usize, const P: usize, const E: usize, const L: usize, const Q: usize>
    Aided<M, N, P, E, L, Q>
where
    R: Scalar + Real<Mask = bool>,
    M: Mechanization<Real = R, Body = BodyMotion<R>>,
{
    /// By a mechanization for samples of an interval, in seconds.
    ///
    /// # Errors
    ///
    /// [`AidedFault::Settings`], [`AidedFault::Lever`] or [`AidedFault::Horizon`] for what is out of range.
    pub fn new(
        mechanization: M,
        interval_s: Pair<R>,
        settings: Settings<R>,
    ) -> Result<Self, AidedFault> {
        let limits = settings.admit(N)?;
        let horizon = R::count(settings.horizon_samples.unwrap_or(0)) * interval_s.hi;
        // Measurements end steps early.
        if horizon > settings.step_s * R::count(L as u32) * R::HALF {
            return Err(AidedFault::Horizon);
        }
        let (model, places) = settings.states.placed();
        Ok(Self { mechanization, interval: interval_s, settings, model, places, limits })
    }

    /// From a first solution with the uncertainties of the settings.
    ///
    /// # Errors
    ///
    /// [`AidedFault::Start`] if the mechanization cannot start.
    pub fn start(&self, initial: &Solution<R>) -> Result<AidedState<M, N, P, E, L, Q>, AidedFault> {
        let navigator = self.mechanization.start(initial).map_err(|_| AidedFault::Start)?;
        let solution = self.mechanization.output(&navigator).precise();
        let heading = self.settings.start.heading_rad;
        let entry = Entry::new(0, &solution, Vector::ZERO, &Stretch::NONE, &Fading::NONE);
        Ok(AidedState {
            navigator,
            filter: self.filter(&Pose::of(&solution), &self.settings.start),
            stretch: Stretch::NONE,
            rates: [Vector::ZERO; 2],
            block_s: R::ZERO,
            integrated: 0,
            pushed: 0,
            reference: Reference::at(solution.position.latitude),
            ring: Ring::new(entry),
            queue: Queue::EMPTY,
            taken: Taken::NONE,
            search: Search::new(heading),
            corrected: [R::ZERO; 3],
            anchor: Anchor {
                samples: 0,
                velocity_ned: solution.velocity_ned.map(|c| c.hi),
                sigma: self.settings.start.velocity_m_s,
            },
            tallies: [Tally::default(); 5],
            transport: Transport::default(),
        })
    }

    /// A filter with first uncertainties.
    pub(super) fn filter(&self, pose: &Pose<R>, start: &Start<R>) -> Filter<R, N, P, E> {
        let Start { position_m, velocity_m_s, level_rad, heading_rad } = *start;
        let mut filter = Filter::new(&self.model);
        let all = |x: R| Vector::new(x, x, x);
        filter.add_uncertainty(0, all(position_m), pose);
        filter.add_uncertainty(3, all(velocity_m_s), pose);
        filter.add_uncertainty(6, Vector::new(level_rad, level_rad, heading_rad), pose);
        filter
    }

    /// The number of samples at whose end a measurement is due.
    pub(super) fn due(&self, at: &Instant<R>) -> u64 {
        let after = u64::from(at.part > R::ZERO);
        let horizon = u64::from(self.settings.horizon_samples.unwrap_or(0));
        at.samples.saturating_add(after).saturating_add(horizon)
    }

    /// Takes a measurement: it waits until the navigator has passed its time, and the horizon.
    ///
    /// # Errors
    ///
    /// [`AidedFault`] if it is refused. Only the counts of transport change then.
    pub fn measure(
        &self,
        state: &mut AidedState<M, N, P, E, L, Q>,
        measured: &Measured<R>,
    ) -> Result<(), AidedFault> {
        measured.admit()?;
        let at = measured.at;
        if at.samples > state.pushed.saturating_add(AHEAD) {
            return Err(AidedFault::Future);
        }
        let horizon = self.settings.horizon_samples.is_some();
        let result = if state.taken.has(&at, measured.kind) {
            Err(AidedFault::Again)
        } else if (horizon && self.due(&at) <= state.integrated) || at.samples < state.ring.oldest()
        {
            Err(AidedFault::Late)
        } else {
            state.queue.put(measured)
        };
        let counts = &mut state.transport;
        let count = match result {
            Err(AidedFault::Again) => &mut counts.again,
            Err(AidedFault::Late) => &mut counts.late,
            Err(AidedFault::Full) => &mut counts.dropped,
            other => return other,
        };
        *count = count.saturating_add(1);
        result
    }

    /// Navigation at the end of the last block.
    pub fn output(&self, state: &AidedState<M, N, P, E, L, Q>) -> M::Output {
        self.mechanization.output(&state.navigator)
    }

    /// The same in local axes.
    pub fn solution(&self, state: &AidedState<M, N, P, E, L, Q>) -> Solution<R> {
        self.output(state).precise()
    }

    /// The settings.
    pub fn settings(&self) -> &Settings<R> {
        &self.settings
    }

    /// The mechanization.
    pub fn mechanization(&self) -> &M {
        &self.mechanization
    }

    /// Checks a state that was restored.
    ///
    /// # Errors
    ///
    /// [`Damaged`] if it can be none of this navigator.
    pub fn check(&self, state: &AidedState<M, N, P, E, L, Q>) -> Result<(), Damaged> {
        self.mechanization.check(&state.navigator)?;
        state.filter.check()?;
        let most = R::of(1e7);
        let sound = state.stretch.time_s.is_within(R::of(1e3))
            && state.rates.iter().all(|rate| rate.is_within(most))
            && state.ring.is_plausible()
            && state.queue.is_plausible()
            && state.integrated == M::integrated(&state.navigator)
            && state.pushed >= state.integrated;
        if sound { Ok(()) } else { Err(Damaged) }
    }
}
