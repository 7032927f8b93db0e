//! Numbers of a segment, checked before anything moves.
//!
//! ```
//! use schuler::trajectory::segment::attitude::AttitudeRule;
//! use schuler::trajectory::segment::compile::check::Known;
//! use schuler::trajectory::segment::compile::segment::{Pace, Segment};
//! use schuler::trajectory::segment::fault::Fault;
//!
//! let known = Known { speed: 0.0, altitude: 0.0, rule: AttitudeRule::Upright };
//! let start = Segment::Accelerate { speed: 2e5, pace: Pace::Blend(60.0) };
//! assert_eq!(start.check(known), Err(Fault::TooFast));
//! ```

use super::segment::{Amount, Length, Pace, Segment, Tightness};
use super::{climb, turn};
use crate::trajectory::segment::attitude::AttitudeRule;
use crate::trajectory::segment::fault::{Fault, HEIGHTS, LARGEST_SPEED, LEAST_TIME_S};
use core::f64::consts::TAU;

/// What is known before a segment without flying to it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Known {
    /// Speed along the path, m/s.
    pub speed: f64,
    /// Height above the ellipsoid, m.
    pub altitude: f64,
    /// How body axes lie along the path.
    pub rule: AttitudeRule,
}

impl Known {
    /// Whether a path may begin so.
    ///
    /// # Errors
    ///
    /// [`Fault::NotFinite`], [`Fault::TooFast`], [`Fault::Height`].
    pub fn check(self) -> Result<Self, Fault> {
        finite(&[self.speed, self.altitude])?;
        let [least, most] = HEIGHTS;
        if self.speed.abs() > LARGEST_SPEED {
            return Err(Fault::TooFast);
        }
        if self.altitude < least || self.altitude > most {
            return Err(Fault::Height);
        }
        Ok(self)
    }
}

fn finite(numbers: &[f64]) -> Result<(), Fault> {
    if numbers.iter().all(|x| x.is_finite()) { Ok(()) } else { Err(Fault::NotFinite) }
}

fn positive(x: f64) -> Result<(), Fault> {
    finite(&[x])?;
    if x > 0.0 { Ok(()) } else { Err(Fault::NotPositive) }
}

/// A time of at least a millisecond.
fn time(x: f64) -> Result<(), Fault> {
    finite(&[x])?;
    if x >= LEAST_TIME_S { Ok(()) } else { Err(Fault::TooShort) }
}

/// The same, or no time.
fn time_or_none(x: f64) -> Result<(), Fault> {
    if x == 0.0 { Ok(()) } else { time(x) }
}

impl Segment {
    /// What is known after it, if its numbers are possible.
    ///
    /// # Errors
    ///
    /// The [`Fault`] of the first number that is not.
    pub fn check(&self, known: Known) -> Result<Known, Fault> {
        let mut after = known;
        match *self {
            Self::Hold { duration_s } => time_or_none(duration_s)?,
            Self::Straight { length: Length::Time(duration_s), .. } => time_or_none(duration_s)?,
            Self::Straight { length: Length::Distance(distance), .. } => {
                positive(distance)?;
                if known.speed == 0.0 {
                    return Err(Fault::AtRest);
                }
                time(distance / known.speed.abs())?;
            }
            Self::Accelerate { speed, pace } => {
                finite(&[speed])?;
                let (Pace::Blend(number) | Pace::Acceleration(number)) = pace;
                positive(number)?;
                after.speed = speed;
                let change = speed - known.speed;
                if change != 0.0 || matches!(pace, Pace::Blend(_)) {
                    time(pace.blend_s(change))?;
                }
            }
            Self::Climb { height, rate, blend_s } => {
                finite(&[height])?;
                positive(rate)?;
                time(blend_s)?;
                let banks = known.rule == AttitudeRule::Coordinated;
                climb::check(known.speed, height, rate, blend_s, banks)?;
                after.altitude += height;
            }
            Self::Turn { amount, tightness, blend_s } => {
                let (Tightness::Bank(number) | Tightness::Radius(number)) = tightness;
                positive(number)?;
                time(blend_s)?;
                let (Amount::By(angle) | Amount::To { course: angle, .. }) = amount;
                finite(&[angle])?;
                if matches!(amount, Amount::To { .. }) && angle.abs() > TAU {
                    return Err(Fault::Angle);
                }
                turn::check(known.speed, tightness)?;
            }
            Self::Rotate { angles, blend_s } => {
                finite(&angles)?;
                time(blend_s)?;
            }
        }
        after.check()
    }
}
