//! The alignment: samples in, attitude and biases out.
//!
//! A navigator runs from the first sample on, however wrong its heading is, and a filter beside it measures that the
//! vehicle goes nowhere. The errors of the filter are the same at any heading, so that it needs no first attitude
//! beyond a rough level.
//!
//! ```
//! use schuler::aiding::alignment::base::Base;
//! use schuler::aiding::alignment::fine::Fine15;
//! use schuler::aiding::alignment::settings::Settings;
//! use schuler::aiding::model::Model;
//! use schuler::aiding::states::Process;
//! use schuler::prelude::*;
//! use schuler::units::{DEGREE, DEGREE_PER_HOUR};
//!
//! // Still at 45° N, level, the forward axis 30° east of north; samples of 10 ms, the heading unknown.
//! let place = Geodetic { latitude: 45.0 * DEGREE, longitude: 0.0, altitude: 0.0 };
//! let (rate, yaw) = (7.292115e-5_f64 * 0.5_f64.sqrt(), 30.0 * DEGREE);
//! let force = schuler::earth::gravity(0.5_f64.sqrt(), 0.0);
//! let sample = Increment {
//!     angle_b: Vector::new(rate * yaw.cos(), -rate * yaw.sin(), -rate) * 0.01,
//!     velocity_b: Vector::new(0.0, 0.0, -force * 0.01),
//! };
//! let bias = [0.01 * DEGREE_PER_HOUR, 5e-4].map(Process::constant);
//! let model = Model::new(6e-7, 1e-4, bias[0], bias[1]);
//! let settings = Settings { base: Base::still(), ..Settings::new(model) };
//! let navigator = Navigator4::from_rate_hz(100.0)?;
//! let fine = Fine15::new(navigator, Pair::of(0.01), &place, settings)?;
//! let mut state = fine.start(Euler::default())?;
//! for _ in 0..6000 {
//!     fine.push(&mut state, sample)?;
//! }
//! let aligned = fine.aligned(&state);
//! assert!((aligned.attitude.yaw - yaw).abs() < aligned.heading_sigma);
//! assert!(aligned.heading_sigma < 0.2 * DEGREE);
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```

use super::aligned::Aligned;
use super::base::Base;
use super::search::Search;
use super::settings::Settings;
use super::verdict::AlignmentFault;
use crate::aiding::filter::Filter;
use crate::aiding::gate::{Gate, Watch};
use crate::aiding::states::Extra;
use crate::aiding::surroundings::{Pose, Surroundings};
use crate::aiding::transition::Stretch;
use crate::earth::{Geodetic, POLAR_SINE};
use crate::math::compensated::Pair;
use crate::math::real::{Real, Scalar};
use crate::math::vector::Vector;
use crate::output::Output;
use crate::record::{Record, record};
use crate::sample::Increment;
use crate::solution::{Euler, Solution};
use crate::strapdown::block::body::BodyMotion;
use crate::strapdown::mechanization::Mechanization;

/// A step of the filter, s, about: the blocks within it are chained.
pub(super) const STEP_S: f64 = 0.1;
/// A χ² of three degrees exceeds this once in a million times.
const REFUSED: f64 = 30.7;
/// Refusals in a row, of steps, after which the vehicle counts as moving.
const PATIENCE: u32 = 10;

/// An alignment by a mechanization: configuration.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Fine<M: Mechanization, const N: usize, const P: usize, const E: usize> {
    pub(super) mechanization: M,
    pub(super) interval: Pair<M::Real>,
    pub(super) settings: Settings<M::Real>,
    pub(super) position: Geodetic<M::Real>,
    pub(super) here: Surroundings<M::Real>,
    pub(super) cosine: M::Real,
    pub(super) gate: Gate<M::Real>,
}

/// Of a vehicle that stands still, or moves.
pub type Fine15<M> = Fine<M, 15, 120, 0>;
/// Of a vehicle that sways.
pub type Fine21<M> = Fine<M, 21, 231, 6>;

/// A running alignment.
#[derive(Clone, Copy)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FineState<M: Mechanization, const N: usize, const P: usize, const E: usize> {
    pub(super) navigator: M::State,
    pub(super) filter: Filter<M::Real, N, P, E>,
    pub(super) stretch: Stretch<M::Real>,
    pub(super) search: Search<M::Real>,
    /// The heading's standard deviation as long as the filter finds level alone, rad; then 0.
    pub(super) unsure: M::Real,
    /// Samples before the filter last started.
    pub(super) before: u64,
    /// Samples since then, up to the end of the last block.
    pub(super) integrated: u64,
    pub(super) watch: Watch<M::Real>,
    /// Samples at the first refusal that became a lockout; 0: none.
    pub(super) moved: u64,
}

impl<R: Scalar, M, const N: usize, const P: usize, const E: usize> Fine<M, N, P, E>
where
    M: Mechanization<Real = R, Body = BodyMotion<R>>,
    R: Real<Mask = bool>,
{
    /// By a mechanization for samples of an interval, in seconds, at a place. One without look-ahead is best: then
    /// no sample waits when its bias becomes known.
    ///
    /// # Errors
    ///
    /// [`AlignmentFault::Pole`] beyond 84° of latitude, [`AlignmentFault::Settings`] if a standard deviation is not
    /// above 0 or the states do not fit.
    pub fn new(
        mechanization: M,
        interval_s: Pair<R>,
        position: &Geodetic<R>,
        settings: Settings<R>,
    ) -> Result<Self, AlignmentFault> {
        let (sine, cosine) = position.latitude.sin_cos();
        if !sine.is_within(R::of(POLAR_SINE)) {
            return Err(AlignmentFault::Pole);
        }
        let mut settings = settings;
        if let Base::Swaying { sway, .. } = settings.base {
            let with = settings.model.with(Extra::Resonator(sway));
            settings.model = with.ok_or(AlignmentFault::Settings)?;
        }
        let positive = |x: R| x > R::ZERO && x.is_within(R::of(1e6));
        let sound = settings.model.states() <= N
            && positive(settings.level_rad)
            && positive(settings.heading_rad)
            && positive(settings.velocity_m_s)
            && positive(settings.model.noise.gyro)
            && positive(settings.model.noise.accelerometer)
            && settings.base.displacement_m().is_none_or(positive);
        if !sound {
            return Err(AlignmentFault::Settings);
        }
        Ok(Self {
            mechanization,
            interval: interval_s,
            settings,
            position: *position,
            here: Surroundings::from_latitude(sine, cosine, position.altitude),
            cosine,
            gate: Gate { limit: R::of(REFUSED), patience: PATIENCE },
        })
    }

    /// From a first attitude, at rest.
    ///
    /// # Errors
    ///
    /// [`AlignmentFault::Start`] if the mechanization cannot start.
    pub fn start(&self, attitude: Euler<R>) -> Result<FineState<M, N, P, E>, AlignmentFault> {
        self.start_moving(attitude, Vector::ZERO)
    }

    /// The same with a velocity in north, east and down, m/s.
    ///
    /// # Errors
    ///
    /// As of [`start`](Self::start).
    pub fn start_moving(
        &self,
        attitude: Euler<R>,
        velocity_ned: Vector<R>,
    ) -> Result<FineState<M, N, P, E>, AlignmentFault> {
        let initial = Solution::new(self.position, velocity_ned, attitude);
        self.start_unsure(&initial, self.settings.heading_rad)
    }

    /// From a solution with a heading of a standard deviation of its own, rad.
    pub(super) fn start_unsure(
        &self,
        initial: &Solution<R>,
        heading_rad: R,
    ) -> Result<FineState<M, N, P, E>, AlignmentFault> {
        let navigator = self.mechanization.start(initial).map_err(|_| AlignmentFault::Start)?;
        let pose = Pose::of(initial);
        let Settings { level_rad, velocity_m_s, base, .. } = self.settings;
        let mut filter = Filter::new(&self.settings.model);
        let all = |x: R| Vector::new(x, x, x);
        // The place is where it starts, give or take how far it goes.
        let place = match base {
            Base::Still { displacement_m } => displacement_m,
            Base::Swaying { sway, .. } => sway.rms_m,
            Base::Moving => R::ONE,
        };
        filter.add_uncertainty(0, all(place), &pose);
        filter.add_uncertainty(3, all(velocity_m_s), &pose);
        // Tilt times an unknown heading is what a linear filter leaves out: at rest it first finds level, which needs
        // no heading.
        let level_first = matches!(base, Base::Still { .. });
        let unsure = if level_first { heading_rad } else { R::ZERO };
        let heading = if level_first { R::ZERO } else { heading_rad };
        filter.add_uncertainty(6, Vector::new(level_rad, level_rad, heading), &pose);
        Ok(FineState {
            navigator,
            filter,
            stretch: Stretch::NONE,
            search: Search::new(heading_rad),
            unsure,
            before: 0,
            integrated: 0,
            watch: Watch::default(),
            moved: 0,
        })
    }

    /// Takes a sample.
    ///
    /// # Errors
    ///
    /// [`AlignmentFault::Rejected`] if the mechanization refuses it; the state is then unchanged.
    /// [`AlignmentFault::Diverged`] if it refuses a correction: start again.
    #[inline]
    pub fn push(
        &self,
        state: &mut FineState<M, N, P, E>,
        sample: Increment<R>,
    ) -> Result<(), AlignmentFault> {
        let FineState { navigator, filter, stretch, integrated, .. } = state;
        let interval_s = self.interval.hi;
        let sample = filter.without_biases(&sample, interval_s);
        let see = |now: u64, body: &BodyMotion<R>, _: &M::Frame| {
            let samples = R::count(now.saturating_sub(*integrated) as u32);
            stretch.add(body, samples * interval_s);
            *integrated = now;
        };
        self.mechanization.push_blocks(navigator, sample, see).map_err(AlignmentFault::Rejected)?;
        // Half a sample early is on time.
        if stretch.time_s + interval_s * R::HALF > R::of(STEP_S) {
            self.step(state)
        } else {
            Ok(())
        }
    }

    /// What came of it so far.
    pub fn aligned(&self, state: &FineState<M, N, P, E>) -> Aligned<R> {
        let solution = self.mechanization.output(&state.navigator).solution();
        let samples = state.before.saturating_add(state.integrated);
        let times = [samples, state.moved].map(|n| R::count(n as u32) * self.interval.hi);
        let aligned =
            Aligned::of(&state.filter, &solution, self.way(&solution), times, &state.watch);
        let square = |x: R| x * x;
        let heading = (square(aligned.heading_sigma) + square(state.unsure)).sqrt();
        Aligned { heading_sigma: heading, ..aligned }
    }

    /// The navigator's solution at the end of its last block.
    pub fn solution(&self, state: &FineState<M, N, P, E>) -> Solution<R> {
        self.mechanization.output(&state.navigator).solution()
    }

    /// The covariance of the attitude as a rotation vector in north, east, down, rad².
    pub fn attitude_covariance(&self, state: &FineState<M, N, P, E>) -> [[R; 3]; 3] {
        let pose = Pose::of(&self.mechanization.output(&state.navigator).solution());
        let [n, e, d] = pose.body_to_ned.rows;
        let ud = state.filter.covariance();
        let along = |a: Vector<R>, b: Vector<R>| {
            let mut sum = R::ZERO;
            for (i, a) in a.into_array().into_iter().enumerate() {
                for (j, b) in b.into_array().into_iter().enumerate() {
                    sum = sum + a * b * ud.covariance(6 + i, 6 + j);
                }
            }
            sum
        };
        let mut covariance = [n, e, d].map(|a| [n, e, d].map(|b| along(a, b)));
        let [_, _, [_, _, heading]] = &mut covariance;
        *heading = *heading + state.unsure * state.unsure;
        covariance
    }

    /// How it is aligned.
    pub fn settings(&self) -> &Settings<R> {
        &self.settings
    }
}

impl<M: Mechanization<State: Record>, const N: usize, const P: usize, const E: usize> Record
    for FineState<M, N, P, E>
where
    M::Real: Record,
{
    record!(navigator, filter, stretch, search, unsure, before, integrated, watch, moved);
}
