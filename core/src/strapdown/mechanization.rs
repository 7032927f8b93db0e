//! What every mechanization has in common: how it is started and fed, and what it refuses.

use super::frame::{FARTHEST, Output};
use super::navigator::Edges;
use super::plausible::Damaged;
use crate::earth::{SEMI_MAJOR_AXIS, SEMI_MINOR_AXIS};
use crate::math::compensated::Pair;
use crate::math::real::Real;
use crate::math::twin::Twin as _;
use crate::math::vector::Vector;
use crate::sample::Increment;
use crate::solution::Solution;
use core::hint::black_box;

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

/// Velocity, m/s, that navigation starts with at most.
const FASTEST: f64 = 1e5;

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
    /// than [`MOST_TURN`]: a window with a shorter block, or samples more often, would do.
    Turn,
}

/// The largest angle that a block may turn by about one axis, rad: the series of a step are cut short,
/// and are made for less.
pub const MOST_TURN: f64 = 2.0;

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

/// The largest readings that can be right.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Limits<R> {
    /// Angular rate, rad/s.
    pub angular_rate: R,
    /// Specific force, m/s².
    pub specific_force: R,
}

impl<R: Real> Default for Limits<R> {
    /// 10⁵ °/s and 10⁵ m/s².
    fn default() -> Self {
        Self {
            angular_rate: R::of(1e5 * core::f64::consts::PI / 180.0),
            specific_force: R::of(1e5),
        }
    }
}

/// The limits over one sample.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct Gate<R> {
    /// The limit, and what a block may turn by if that is less.
    most_angle: R,
    limit: R,
    most_velocity: R,
    /// What a sample of any interval may turn by, rad.
    most_turn: R,
    limits: Limits<R>,
}

/// Whether a number is positive, finite and neither vanishing nor huge.
#[inline]
fn is_positive<R: Real>(x: R) -> bool {
    x.is_within(R::of(1e30)) & !R::any(x.less(R::of(1e-30)))
}

/// Whether an interval can be one of a sample: above 0 s and at most 1 s.
#[inline]
fn is_interval<R: Real>(interval_s: R) -> bool {
    is_positive(interval_s) & interval_s.is_within(R::ONE)
}

impl<R: Real> Gate<R> {
    /// For samples of an interval in seconds, so many to a block.
    pub fn new(interval_s: R, limits: Limits<R>, block: usize) -> Result<Self, StartError> {
        if !is_interval(interval_s) {
            return Err(StartError::Interval);
        }
        if !is_positive(limits.angular_rate) || !is_positive(limits.specific_force) {
            return Err(StartError::Limits);
        }
        let most_turn = R::of(MOST_TURN) / R::count(block as u32);
        Ok(Self::of(interval_s, limits, most_turn))
    }

    fn of(interval_s: R, limits: Limits<R>, most_turn: R) -> Self {
        let limit = limits.angular_rate * interval_s;
        Self {
            most_angle: R::select(most_turn.less(limit), most_turn, limit),
            limit,
            most_velocity: limits.specific_force * interval_s,
            most_turn,
            limits,
        }
    }

    /// Whether a sample of an interval of its own can be right.
    #[inline]
    pub fn admit_over(&self, sample: &Increment<R>, interval_s: R) -> Result<(), Rejected> {
        if is_interval(interval_s) {
            Self::of(interval_s, self.limits, self.most_turn).admit(sample)
        } else {
            Err(Rejected::Interval)
        }
    }

    /// Whether a sample can be right.
    #[inline(always)]
    pub fn admit(&self, sample: &Increment<R>) -> Result<(), Rejected> {
        let (angle, velocity) = (self.most_angle, self.most_velocity);
        let bounds = Increment {
            angle_b: Vector::new(angle, angle, angle),
            velocity_b: Vector::new(velocity, velocity, velocity),
        };
        if R::Twin::all_within(sample.twins(), bounds.twins()) {
            Ok(())
        } else if sample.angle_b.is_within(angle) {
            Err(Rejected::Velocity)
        } else if sample.angle_b.is_within(self.limit) {
            Err(Rejected::Turn)
        } else {
            Err(Rejected::Angle)
        }
    }
}

/// Whether the processor computes with subnormal numbers, as IEEE 754 has it.
#[inline(never)]
pub fn subnormals_survive<R: Real>() -> bool {
    // Half of the smallest normal number, and twice that again: both exact.
    let normal = black_box(R::entry(f32::MIN_POSITIVE, f64::MIN_POSITIVE));
    let subnormal = black_box(normal * R::HALF);
    let back = subnormal + subnormal;
    !R::any(back.less(normal)) & !R::any(normal.less(back))
}

/// Whether a height and a vertical velocity can be right.
pub(super) fn admit_held<R: Real>(altitude: R, down: R) -> Result<(), Rejected> {
    if altitude.is_within(R::of(FARTHEST)) & down.is_within(R::of(FASTEST)) {
        Ok(())
    } else {
        Err(Rejected::Held)
    }
}

impl From<Rejected> for StartError {
    /// Why a frame cannot go on from a place.
    fn from(rejected: Rejected) -> Self {
        if rejected == Rejected::Pole { Self::Pole } else { Self::Position }
    }
}

/// An initial solution, if it can be right, its attitude brought to unit length.
pub(super) fn admit_start<R: Real>(initial: &Solution<R>) -> Result<Solution<R>, StartError> {
    if !subnormals_survive::<R>() {
        return Err(StartError::FlushToZero);
    }
    // A remainder that is not finite shows in the sum.
    let position = initial.position.map(|c| c.hi + c.lo);
    let pole = R::of(core::f64::consts::FRAC_PI_2 * (1.0 + 1e-7));
    let on_earth = position.latitude.is_within(pole)
        & position.longitude.is_within(R::of(core::f64::consts::TAU))
        // Where the shell that Earth-fixed navigation stays in is widest; the frame itself is asked, too.
        & position.altitude.is_within(R::of(FARTHEST + SEMI_MAJOR_AXIS - SEMI_MINOR_AXIS));
    if !on_earth {
        return Err(StartError::Position);
    }
    if !initial.velocity_ned.map(|c| c.hi + c.lo).is_within(R::of(FASTEST)) {
        return Err(StartError::Velocity);
    }
    let q = initial.attitude.map(|c| c.hi + c.lo);
    if !(q.dot(q) - R::ONE).is_within(R::of(2e-3)) {
        return Err(StartError::Attitude);
    }
    let mut admitted = *initial;
    for _ in 0..3 {
        // q ← q(3 − |q|²)/2
        let q = admitted.attitude;
        let square = q.w * q.w + q.v.dot(q.v);
        let scale = (Pair::new(R::of(3.0)) - square) * Pair::new(R::HALF);
        admitted.attitude = q * scale;
    }
    Ok(admitted)
}
