//! The motion of a scene: channels of harmonics, or any path in pieces, and the unit that it carries.

use crate::lanes::truth::Truth;
use schuler::imu::Quadrature;
use schuler::math::compensated::Pair;
use schuler::sample::{Increment, Rates};
use schuler::solution::Solution;
use schuler::trajectory::carried::{Carried, Mount};
use schuler::trajectory::harmonic::HarmonicTrajectory;
use schuler::trajectory::kinematics::Kinematics;
use schuler::trajectory::piecewise::Piecewise;
use schuler::trajectory::piecewise::piece::Piece;
use schuler::trajectory::{Bound, Motion, Trajectory};
use std::sync::Arc;

/// Harmonics that a motion may have, over all channels.
pub const HARMONICS: usize = 64;

/// A path in pieces of degree 7, of way-points and logs.
pub type Spline = Piecewise<Vec<Piece<8>>, 8>;
/// A path in pieces of degree 11, of segments.
pub type Blend = Piecewise<Vec<Piece<12>>, 12>;

/// A path that was compiled once, for everybody who flies it.
#[derive(Clone, Debug)]
pub enum Path {
    /// In pieces of degree 7.
    Spline(Arc<Spline>),
    /// In pieces of degree 11.
    Blend(Arc<Blend>),
}

/// A motion without its mount.
#[derive(Clone, Debug)]
pub enum Reference {
    /// Channels of harmonics.
    Harmonic(Box<HarmonicTrajectory<f64, HARMONICS>>),
    /// Pieces.
    Path(Path),
}

/// The motion of a scene.
#[derive(Clone, Debug)]
pub enum Course {
    /// Of the unit itself.
    Plain(Reference),
    /// Of a vehicle that carries the unit.
    Carried(Box<Carried<Reference, HARMONICS>>),
}

/// The same call on whatever it is.
macro_rules! each {
    ($self:ident, $motion:ident => $call:expr) => {
        match $self {
            Course::Plain(Reference::Harmonic($motion)) => {
                let $motion = $motion.as_ref();
                $call
            }
            Course::Plain(Reference::Path(Path::Spline($motion))) => {
                let $motion = $motion.as_ref();
                $call
            }
            Course::Plain(Reference::Path(Path::Blend($motion))) => {
                let $motion = $motion.as_ref();
                $call
            }
            Course::Carried($motion) => {
                let $motion = $motion.as_ref();
                $call
            }
        }
    };
}

macro_rules! reference {
    ($self:ident, $motion:ident => $call:expr) => {
        match $self {
            Reference::Harmonic($motion) => $call,
            Reference::Path(Path::Spline($motion)) => $call,
            Reference::Path(Path::Blend($motion)) => $call,
        }
    };
}

impl Course {
    /// Of a reference motion, and of a mount if there is one.
    pub fn new(reference: Reference, mount: Option<Mount<HARMONICS>>) -> Self {
        match mount {
            None => Self::Plain(reference),
            Some(mount) => Self::Carried(Box::new(Carried::new(reference, mount))),
        }
    }

    /// The path in pieces that it follows, if it does.
    pub fn path(&self) -> Option<&Path> {
        let reference = match self {
            Self::Plain(reference) => reference,
            Self::Carried(carried) => carried.path(),
        };
        match reference {
            Reference::Harmonic(_) => None,
            Reference::Path(path) => Some(path),
        }
    }

    /// The perfect increment of a sample, whose number counts from 1.
    pub fn sample(&self, quadrature: Quadrature, number: u64, rate_hz: f64) -> Increment<f64> {
        each!(self, motion => quadrature.sample(motion, number, rate_hz))
    }

    /// Whether samples are worked out side by side where the machine has lanes.
    pub fn is_for_lanes(&self) -> bool {
        matches!(self, Self::Plain(Reference::Harmonic(_)))
    }

    /// The perfect increments of samples from a number on, side by side where that is possible: the bits of each
    /// alone.
    pub fn samples(
        &self,
        quadrature: Quadrature,
        first: u64,
        rate_hz: f64,
        increments: &mut [Increment<f64>],
    ) {
        if let Self::Plain(Reference::Harmonic(course)) = self {
            let increments = &mut *increments;
            if (Truth { course, quadrature, rate_hz, first, increments }).work_out() {
                return;
            }
        }
        for (number, increment) in (first..).zip(increments) {
            *increment = self.sample(quadrature, number, rate_hz);
        }
    }

    /// The perfect increment between two times, s.
    pub fn increment(&self, quadrature: Quadrature, from_s: f64, to_s: f64) -> Increment<f64> {
        each!(self, motion => quadrature.increment(motion, from_s, to_s))
    }
}

impl Path {
    /// When it ends, s.
    pub fn end_s(&self) -> f64 {
        match self {
            Self::Spline(path) => path.end_s(),
            Self::Blend(path) => path.end_s(),
        }
    }

    /// Beginnings and ends of its pieces, s.
    pub fn spans(&self) -> Vec<[f64; 2]> {
        fn spans<const N: usize>(pieces: &[Piece<N>]) -> Vec<[f64; 2]> {
            pieces.iter().map(|piece| [piece.start_s, piece.end_s]).collect()
        }
        match self {
            Self::Spline(path) => spans(path.pieces()),
            Self::Blend(path) => spans(path.pieces()),
        }
    }
}

impl PartialEq for Path {
    /// The same pieces with the same rule.
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Spline(a), Self::Spline(b)) => a == b,
            (Self::Blend(a), Self::Blend(b)) => a == b,
            _ => false,
        }
    }
}

macro_rules! trajectory {
    ($type:ty, $each:ident) => {
        impl Trajectory<f64> for $type {
            fn at_instant(&self, time_s: Pair<f64>) -> Motion<f64> {
                $each!(self, motion => motion.at_instant(time_s))
            }
            fn rates_at(&self, time_s: Pair<f64>) -> Rates<f64> {
                $each!(self, motion => motion.rates_at(time_s))
            }
            fn kinematics_at(&self, time_s: Pair<f64>) -> Kinematics {
                $each!(self, motion => motion.kinematics_at(time_s))
            }
            fn solution_at(&self, time_s: Pair<f64>) -> Solution<f64> {
                $each!(self, motion => motion.solution_at(time_s))
            }
            fn initial_at(&self, time_s: Pair<f64>) -> Solution<f64> {
                $each!(self, motion => motion.initial_at(time_s))
            }
            fn joint_after(&self, time_s: f64) -> Option<f64> {
                $each!(self, motion => motion.joint_after(time_s))
            }
            fn bound(&self) -> Bound<f64> {
                $each!(self, motion => motion.bound())
            }
        }
    };
}

trajectory!(Reference, reference);
trajectory!(Course, each);
