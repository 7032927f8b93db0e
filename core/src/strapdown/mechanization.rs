//! What every mechanization has in common: how it is started and fed, and why it refuses.

use super::frame::Output;
use super::navigator::Edges;
use super::plausible::Damaged;
use crate::math::real::Real;
use crate::sample::Increment;
use crate::solution::Solution;

/// A mechanization: a configuration that carries a state from sample to sample.
pub trait Mechanization {
    /// The scalar it computes in.
    type Real: Real;
    /// The frame's share of the state: what navigation stands at.
    type Frame: Copy;
    /// What goes on from sample to sample.
    type State: Copy;
    /// What it prints.
    type Output: Output<Self::Real>;
    /// The body's motion over one of its steps.
    type Body: Copy;

    /// Starts from an initial solution.
    fn start(&self, initial: &Solution<Self::Real>) -> Result<Self::State, StartError>;
    /// Takes a sample; no row is read.
    fn push(&self, state: &mut Self::State, sample: Increment<Self::Real>) -> Result<(), Rejected>;
    /// Takes a sample and reads the rows that it completes: the number of samples up to each, and the
    /// navigation there.
    fn push_rows(
        &self,
        state: &mut Self::State,
        sample: Increment<Self::Real>,
        read: impl FnMut(u64, Self::Output),
    ) -> Result<(), Rejected>;
    /// Integrates what waits for samples; no row is read.
    fn finish(&self, state: &mut Self::State);
    /// Completes the rows that wait for samples, and reads them.
    fn finish_rows(&self, state: &mut Self::State, read: impl FnMut(u64, Self::Output));
    /// Takes a sample and shows every step that it completes: the number of samples at its end, the
    /// body's motion over it, and the frame after it. What an audit records.
    fn push_blocks(
        &self,
        state: &mut Self::State,
        sample: Increment<Self::Real>,
        see: impl FnMut(u64, &Self::Body, &Self::Frame),
    ) -> Result<(), Rejected>;
    /// Completes the steps that wait for samples, and shows them.
    fn finish_blocks(
        &self,
        state: &mut Self::State,
        see: impl FnMut(u64, &Self::Body, &Self::Frame),
    );
    /// Sets height (m) and vertical velocity (down, m/s), as an altimeter would.
    fn hold_vertical(
        &self,
        state: &mut Self::State,
        altitude: Self::Real,
        down: Self::Real,
    ) -> Result<(), Rejected>;
    /// Whether a state can be one that navigation left: asked of every state that was written back, before
    /// it goes on.
    fn check(&self, state: &Self::State) -> Result<(), Damaged>;
    /// The frame's share of a state.
    fn frame(state: &Self::State) -> &Self::Frame;
    /// How many samples it has integrated.
    fn integrated(state: &Self::State) -> u64;
    /// Samples that the blocks at the edges were fitted through; `None` where no fit is made.
    fn edges(_: &Self::State) -> Option<Edges<Self::Real>> {
        None
    }
    /// The navigation that the state stands at.
    fn output(&self, state: &Self::State) -> Self::Output;
}

/// Why a sample, or a vertical to hold, was not taken. The state is as it was, bit for bit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Rejected {
    /// An angle increment that is not finite, or above the limit.
    Angle,
    /// A velocity increment that is not finite, or above the limit.
    Velocity,
    /// The local-level frame has come within a ten-thousandth of the Earth's radius of a pole, where
    /// its axes end: the Earth-fixed frame goes on.
    Pole,
    /// Navigation has left the neighbourhood of the ellipsoid, 1000 km up or down.
    Place,
    /// A height or a vertical velocity to hold that is not finite, above 1000 km or above 10⁵ m/s.
    Held,
    /// An interval that is not finite, not above 0 s or above 1 s.
    Interval,
    /// An angle increment within the limit, but so large that a block of such samples would turn by more
    /// than [`MOST_TURN`](super::gate::MOST_TURN): a window with a shorter block, or samples more often, would do.
    Turn,
}

impl core::fmt::Display for Rejected {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(match self {
            Self::Angle => "the angle increment is not finite or exceeds the limit",
            Self::Velocity => "the velocity increment is not finite or exceeds the limit",
            Self::Pole => "the local-level frame ends at the pole; earth-fixed goes on",
            Self::Place => {
                "navigation has left the ellipsoid by over 1000 km: \
                 check signs and units of the samples, or hold the vertical"
            }
            Self::Held => "the vertical to hold must be finite, within 1000 km and 100 km/s",
            Self::Interval => "the sample's interval must be above 0 s and at most 1 s",
            Self::Turn => {
                "the angle increment turns a block by over 2 rad: \
                 a window with a shorter block or a higher rate would do"
            }
        })
    }
}

impl core::error::Error for Rejected {}

/// Why navigation cannot start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum StartError {
    /// The sampling interval is not above 0 s and at most 1 s.
    Interval,
    /// A limit is not a positive finite number.
    Limits,
    /// The position is not finite, beyond ±90° of latitude or ±360° of longitude, or farther than
    /// 1000 km from the ellipsoid.
    Position,
    /// The velocity is not finite or above 10⁵ m/s.
    Velocity,
    /// The attitude is not a unit quaternion to a thousandth.
    Attitude,
    /// The local-level frame cannot start at a pole.
    Pole,
    /// The processor takes subnormal numbers for zero: its bits would be others than everywhere else.
    FlushToZero,
}

impl core::fmt::Display for StartError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(match self {
            Self::Interval => "the sampling interval must be above 0 s and at most 1 s",
            Self::Limits => "the limits must be positive and finite",
            Self::Position => {
                "the initial position must be finite: latitude within 90°, longitude within 360°, \
                 height within 1000 km"
            }
            Self::Velocity => "the initial velocity must be finite and at most 100 km/s",
            Self::Attitude => "the initial attitude must be a unit quaternion to a thousandth",
            Self::Pole => "the local-level frame cannot start at a pole; earth-fixed can",
            Self::FlushToZero => "the processor flushes subnormal numbers to zero; clear that mode",
        })
    }
}

impl core::error::Error for StartError {}

impl From<Rejected> for StartError {
    /// Why a frame cannot go on from a place.
    fn from(rejected: Rejected) -> Self {
        if rejected == Rejected::Pole { Self::Pole } else { Self::Position }
    }
}
