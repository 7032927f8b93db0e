//! What is wrong with some positions: outliers, and forged ones.
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::sensor::aiding::fault::Spoofing;
//!
//! // From 100 s on the position is pulled north by half a metre per second.
//! let north = Vector::new(0.5_f64, 0.0, 0.0);
//! let ramp = Spoofing { from_s: 100.0, until_s: 200.0, jump_ned: Vector::ZERO, ramp_ned: north };
//! assert_eq!((ramp.offset(110.0).x, ramp.offset(201.0).x), (5.0, 0.0));
//! ```

use crate::math::vector::Vector;
use crate::noise::{Deviate, Stream};
use crate::sensor::parameter::{Fault, Parameter, ParameterError};

/// Outliers: now and then a position is off by much, in any direction.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Outliers<R> {
    /// How probable one is.
    pub probability: R,
    /// How far off it is, m.
    pub size_m: R,
}

impl<R: Deviate> Outliers<R> {
    /// The same, checked.
    ///
    /// # Errors
    ///
    /// [`ParameterError`] if the probability is not within 0 and 1, or the size is negative or not finite.
    pub fn checked(self) -> Result<Self, ParameterError> {
        Parameter::Probability.share(self.probability)?;
        Parameter::Outlier.size(self.size_m)?;
        Ok(self)
    }

    /// That of the next measurement; 0 for most. It uses the same words every time.
    pub fn next(&self, stream: &mut Stream) -> Vector<R> {
        let is_one = stream.uniform::<R>() < self.probability;
        let direction = Vector::new(stream.normal::<R>(), stream.normal(), stream.normal());
        let length = direction.norm();
        if is_one && length > R::ZERO { direction * (self.size_m / length) } else { Vector::ZERO }
    }
}

/// A forged position: it jumps, and then drifts away.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Spoofing<R> {
    /// When it begins, s.
    pub from_s: R,
    /// When it ends, s.
    pub until_s: R,
    /// By how much it jumps, north, east, down, m.
    pub jump_ned: Vector<R>,
    /// How fast it drifts, m/s. The velocity is forged to match.
    pub ramp_ned: Vector<R>,
}

impl<R: Deviate> Spoofing<R> {
    /// The same, checked.
    ///
    /// # Errors
    ///
    /// [`ParameterError`] if a number is not finite, or it ends before it begins.
    pub fn checked(self) -> Result<Self, ParameterError> {
        Parameter::FaultTimes.number(self.from_s)?;
        Parameter::FaultTimes.number(self.until_s)?;
        Parameter::Spoofing.signed(self.jump_ned)?;
        Parameter::Spoofing.signed(self.ramp_ned)?;
        if self.until_s < self.from_s {
            return Err(Parameter::FaultTimes.fault(Fault::OutOfRange));
        }
        Ok(self)
    }

    /// Whether it goes on.
    fn goes_on(&self, time_s: R) -> bool {
        time_s >= self.from_s && time_s <= self.until_s
    }

    /// How far off the position is, m.
    pub fn offset(&self, time_s: R) -> Vector<R> {
        if self.goes_on(time_s) {
            self.jump_ned + self.ramp_ned * (time_s - self.from_s)
        } else {
            Vector::ZERO
        }
    }

    /// How far off the velocity is, m/s.
    pub fn rate(&self, time_s: R) -> Vector<R> {
        if self.goes_on(time_s) { self.ramp_ned } else { Vector::ZERO }
    }
}
