//! Checks of input: initial solutions, samples and held verticals are accepted or refused here.
//!
//! ```
//! use schuler::strapdown::gate::subnormals_survive;
//!
//! assert!(subnormals_survive::<f32>() && subnormals_survive::<f64>());
//! ```

use crate::earth::{SEMI_MAJOR_AXIS, SEMI_MINOR_AXIS};
use crate::math::compensated::Pair;
use crate::math::real::Real;
use crate::math::real::Twin as _;
use crate::math::vector::Vector;
use crate::sample::Increment;
use crate::solution::Solution;
use crate::strapdown::limits::{FARTHEST, FASTEST, Limits, MOST_TURN, Rejected, StartError};
use core::hint::black_box;

/// The limits over one sample.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct Gate<R> {
    /// The limit, or less if a block would turn too far.
    most_angle: R,
    limit: R,
    most_velocity: R,
    /// The largest angle of a sample of any interval, rad.
    most_turn: R,
    limits: Limits<R>,
}

/// Whether a number is positive, finite and neither vanishing nor huge.
#[inline]
fn is_positive<R: Real>(x: R) -> bool {
    x.is_within(R::of(1e30)) & !R::any(x.less(R::of(1e-30)))
}

/// Whether an interval is valid: above 0 s and at most 1 s.
#[inline]
fn is_interval<R: Real>(interval_s: R) -> bool {
    is_positive(interval_s) & interval_s.is_within(R::ONE)
}

/// The interval in seconds of a rate in hertz, to twice the digits.
#[inline]
pub(crate) fn interval_of<R: Real>(rate_hz: f64) -> Pair<R> {
    Pair::of(rate_hz).reciprocal()
}

impl<R: Real> Gate<R> {
    /// For samples of an interval in seconds and blocks of a number of samples.
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

    /// Whether a sample with its own interval is within the limits.
    #[inline]
    pub fn admit_over(&self, sample: &Increment<R>, interval_s: R) -> Result<(), Rejected> {
        if is_interval(interval_s) {
            Self::of(interval_s, self.limits, self.most_turn).admit(sample)
        } else {
            Err(Rejected::Interval)
        }
    }

    /// Whether a sample is within the limits.
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

/// Whether the processor computes with subnormal numbers, as IEEE 754 requires.
#[inline]
pub fn subnormals_survive<R: Real>() -> bool {
    // Half of the smallest normal number, and twice that again: both exact.
    let normal = black_box(R::entry(f32::MIN_POSITIVE, f64::MIN_POSITIVE));
    let subnormal = black_box(normal * R::HALF);
    let back = subnormal + subnormal;
    !R::any(back.less(normal)) & !R::any(normal.less(back))
}

/// Whether a height and a vertical velocity are within the limits.
pub(crate) fn admit_held<R: Real>(altitude: R, down: R) -> Result<(), Rejected> {
    if altitude.is_within(R::of(FARTHEST)) & down.is_within(R::of(FASTEST)) {
        Ok(())
    } else {
        Err(Rejected::Held)
    }
}

/// An initial solution with its attitude brought to unit length, if it is within the limits.
pub(crate) fn admit_start<R: Real>(initial: &Solution<R>) -> Result<Solution<R>, StartError> {
    if !subnormals_survive::<R>() {
        return Err(StartError::FlushToZero);
    }
    // The sum shows a remainder that is not finite, too.
    let position = initial.position.map(|c| c.hi + c.lo);
    let pole = R::of(core::f64::consts::FRAC_PI_2 * (1.0 + 1e-7));
    let on_earth = position.latitude.is_within(pole)
        & position.longitude.is_within(R::of(core::f64::consts::TAU))
        // At the widest place of the shell of Earth-fixed navigation; the frame itself is checked, too.
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
