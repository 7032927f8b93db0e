//! A satellite receiver: positions and velocities of its antenna.
//!
//! ```
//! use schuler::aiding::aided::instant::Instant;
//! use schuler::math::vector::Vector;
//! use schuler::sensor::aiding::gnss::Gnss;
//! use schuler::sensor::aiding::line::Line;
//! use schuler::sensor::aiding::truth::Truth;
//! use schuler::solution::{Euler, Solution};
//!
//! let gnss = Gnss::new(Line::every(1.0_f64), 1.0, 0.05).checked()?;
//! let mut state = gnss.start(1, 0);
//! let solution = Solution::new(Default::default(), Vector::ZERO, Euler::default());
//! let truth = Truth::of(&solution, Vector::new(7.292115e-5, 0.0, 0.0));
//! let heard = gnss.measure(&mut state, &truth, Instant::of_sample(100)).unwrap();
//! assert_eq!((heard.measured.degrees(), heard.arrives_s), (6, 1.0));
//! assert!(heard.measured.position.altitude.hi.abs() < 5.0);
//! # Ok::<(), schuler::sensor::parameter::ParameterError>(())
//! ```

use super::fault::{Outliers, Spoofing};
use super::line::{Delivered, Line, LineState};
use super::noise::{VectorNoise, VectorNoiseState};
use super::truth::Truth;
use crate::aiding::aided::instant::Instant;
use crate::aiding::aided::measured::{Kind, Measured};
use crate::math::vector::Vector;
use crate::noise::random::Random;
use crate::noise::{Deviate, Stream, Streams};
use crate::record::{Record, record};
use crate::sensor::parameter::{Parameter, ParameterError};

/// A satellite receiver.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Gnss<R> {
    /// When it measures, and when that arrives.
    pub line: Line<R>,
    /// What it reports: positions, velocities, or both.
    pub kind: Kind,
    /// From the inertial unit to the antenna, body axes, m.
    pub lever_b: Vector<R>,
    /// Noise of the position, north, east, down, m.
    pub position: VectorNoise<R>,
    /// Noise of the velocity, m/s.
    pub velocity: VectorNoise<R>,
    /// What it claims its position to be good for, m.
    pub position_sigma: Vector<R>,
    /// The same of its velocity, m/s.
    pub velocity_sigma: Vector<R>,
    /// Outliers.
    pub outliers: Option<Outliers<R>>,
    /// A forged position.
    pub spoofing: Option<Spoofing<R>>,
}

/// The state of a receiver.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GnssState<R: Random> {
    /// Its epochs.
    pub line: LineState,
    position: VectorNoiseState<R>,
    velocity: VectorNoiseState<R>,
    outliers: Stream,
}

impl<R: Deviate> Gnss<R> {
    /// The branch of its random numbers.
    const BRANCH: u64 = 0;

    /// Positions and velocities with white noise of the same size along all axes, as claimed; the antenna at the
    /// inertial unit.
    pub fn new(line: Line<R>, position_m: R, velocity_m_s: R) -> Self {
        let three = |x: R| Vector::new(x, x, x);
        Self {
            line,
            kind: Kind::PositionVelocity,
            lever_b: Vector::ZERO,
            position: VectorNoise::white(three(position_m)),
            velocity: VectorNoise::white(three(velocity_m_s)),
            position_sigma: three(position_m),
            velocity_sigma: three(velocity_m_s),
            outliers: None,
            spoofing: None,
        }
    }

    /// The same, checked.
    ///
    /// # Errors
    ///
    /// [`ParameterError`] for the first parameter that is out of range.
    pub fn checked(self) -> Result<Self, ParameterError> {
        self.line.checked()?;
        Parameter::LeverArm.signed(self.lever_b)?;
        self.position.checked()?;
        self.velocity.checked()?;
        Parameter::ClaimedSigma.positive(self.position_sigma)?;
        Parameter::ClaimedSigma.positive(self.velocity_sigma)?;
        self.outliers.map(Outliers::checked).transpose()?;
        self.spoofing.map(Spoofing::checked).transpose()?;
        Ok(self)
    }

    /// Before the first measurement of a run.
    pub fn start(&self, seed: u64, run: u64) -> GnssState<R> {
        let streams = Streams::new(seed, run).branch(Streams::AIDING).branch(Self::BRANCH);
        GnssState {
            line: self.line.start(streams.branch(0)),
            position: self.position.start(self.line.interval_s, streams.branch(1)),
            velocity: self.velocity.start(self.line.interval_s, streams.branch(2)),
            outliers: streams.branch(3).open(),
        }
    }

    /// The next measurement, of the truth at its epoch, whose time in samples of the inertial unit is `at`. Nothing
    /// if it is not heard.
    pub fn measure(
        &self,
        state: &mut GnssState<R>,
        truth: &Truth<R>,
        at: Instant<R>,
    ) -> Option<Delivered<R>> {
        let interval_s = self.line.interval_s;
        let next = self.line.next(&mut state.line);
        let mut way = self.position.next(interval_s, &mut state.position);
        let mut velocity = self.velocity.next(interval_s, &mut state.velocity);
        if let Some(outliers) = &self.outliers {
            way = way + outliers.next(&mut state.outliers);
        }
        let (time_s, (arrives_s, again_s)) = next?;
        if let Some(spoofing) = &self.spoofing {
            way = way + spoofing.offset(time_s);
            velocity = velocity + spoofing.rate(time_s);
        }
        let position = truth.position_at(way + truth.body_to_ned * self.lever_b);
        let velocity = velocity + truth.velocity_at(self.lever_b);
        let (position_sigma, velocity_sigma) = (self.position_sigma, self.velocity_sigma);
        let measured = match self.kind {
            Kind::Position => Measured::position(at, position, position_sigma),
            Kind::Velocity => Measured::velocity(at, velocity, velocity_sigma),
            _ => {
                Measured::position_velocity(at, position, position_sigma, velocity, velocity_sigma)
            }
        };
        Some(Delivered { measured, arrives_s, again_s })
    }
}

impl<R: Random> Record for GnssState<R> {
    record!(line, position, velocity, outliers);
}
