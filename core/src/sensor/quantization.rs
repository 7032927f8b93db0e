//! Quantization: increments come in whole steps, and the remainder is carried to the next sample.
//!
//! The cumulative sum is rounded and its difference emitted. Rounding each sample alone would
//! turn the Allan variance 3Q²/τ² into that of white noise, and bias slow motion.
//!
//! A sensor with limits delivers at most the largest whole number of steps within them. The excess is lost,
//! as with any limit: the remainder never exceeds half a step, so nothing accumulates while the sensor is at
//! its limit.
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::noise::Streams;
//! use schuler::sensor::{ErrorTerm, Reading, Stimulus, quantization::Quantization};
//!
//! let axes = |x| Vector::new(x, x, x);
//! let term = Quantization::new(axes(0.015))?;
//! let mut state = term.start(Streams::new(1, 0));
//! let truth = Vector::new(0.02_f64, 0.0, 0.0);
//! let stimulus = Stimulus { sensed: truth, velocity_b: Vector::new(0.0, 0.0, -0.098) };
//! let mut reading = Reading::new(truth);
//! term.apply(&mut state, &stimulus, &mut reading);
//! assert_eq!(reading.increment.x, 0.015);
//! # Ok::<(), schuler::sensor::parameter::ParameterError>(())
//! ```

use super::parameter::{Parameter, ParameterError};
use super::{ErrorTerm, Reading, Stimulus};
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::noise::random::Random;
use crate::noise::{Deviate, Streams};

/// Quantization of the output. Its Allan variance is 3Q²/τ² with Q = step/√12.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Quantization<R> {
    step: Vector<R>,
    steps_per_unit: Vector<R>,
}

impl<R: Deviate> Quantization<R> {
    /// From the least significant bit of each axis, angle; 0 leaves an axis continuous.
    ///
    /// # Errors
    ///
    /// [`ParameterError`] if a step is negative or not finite.
    pub fn new(step: Vector<R>) -> Result<Self, ParameterError> {
        let step = Parameter::Quantization.magnitude(step)?;
        let inverse = step.map(|s| if s > R::ZERO { R::ONE / s } else { R::ZERO });
        Ok(Self { step, steps_per_unit: Parameter::Quantization.computed(inverse)? })
    }
}

impl<R: Copy> Quantization<R> {
    /// The same term in numbers of another type, as `number` makes them from these.
    pub fn map<T>(&self, number: impl Fn(R) -> T) -> Quantization<T> {
        let step = self.step.map(&number);
        Quantization { step, steps_per_unit: self.steps_per_unit.map(number) }
    }
}

impl<R: Random> ErrorTerm<R> for Quantization<R> {
    /// The input so far less the output so far: at most half a step.
    type State = Vector<R>;

    #[inline]
    fn start(&self, _: Streams) -> Vector<R> {
        Vector::ZERO
    }

    #[inline(always)]
    fn apply(&self, remainder: &mut Vector<R>, _: &Stimulus<R>, reading: &mut Reading<R>) {
        // y = x + c,  out = q·round(y/q),  c ← y − out
        let exact = reading.increment + *remainder;
        let (q, inverse) = (self.step, self.steps_per_unit);
        let out = Vector {
            x: whole(exact.x, q.x, inverse.x),
            y: whole(exact.y, q.y, inverse.y),
            z: whole(exact.z, q.z, inverse.z),
        };
        (reading.increment, *remainder) = (out, exact - out);
        let Some(limit) = reading.limit else { return };
        let limited = Vector {
            x: within(out.x, most(limit.x, q.x, inverse.x)),
            y: within(out.y, most(limit.y, q.y, inverse.y)),
            z: within(out.z, most(limit.z, q.z, inverse.z)),
        };
        let (x, y, z) =
            (differ(limited.x, out.x), differ(limited.y, out.y), differ(limited.z, out.z));
        reading.saturated = reading.saturated | x | y | z;
        reading.increment = limited;
        let (rest, half) = (exact - limited, q * R::HALF);
        *remainder = Vector {
            x: within(rest.x, half.x),
            y: within(rest.y, half.y),
            z: within(rest.z, half.z),
        };
    }
}

/// The nearest whole number of steps, as an increment; the same where there is no step.
#[inline(always)]
fn whole<R: Real>(y: R, step: R, steps_per_unit: R) -> R {
    R::select(R::ZERO.less(step), step * (y * steps_per_unit).round(), y)
}

/// A number, cut to ± a limit.
#[inline(always)]
fn within<R: Real>(y: R, most: R) -> R {
    let negative = y.less(R::ZERO);
    let size = R::select(negative, -y, y);
    let cut = R::select(most.less(size), most, size);
    R::select(negative, -cut, cut)
}

/// Whether two numbers differ.
#[inline(always)]
fn differ<R: Real>(a: R, b: R) -> R::Mask {
    a.less(b) | b.less(a)
}

/// The largest whole number of steps within a limit, as an increment.
#[inline(always)]
fn most<R: Real>(limit: R, step: R, steps_per_unit: R) -> R {
    let nearest = (limit * steps_per_unit).round();
    // A limit that is a whole number of steps, but for its own rounding, is that number of steps.
    let most = nearest * step;
    let is_more = (limit * R::entry(5e-7, 1e-15)).less(most - limit);
    let below = R::select(is_more, (nearest - R::ONE) * step, limit);
    let most = R::select(limit.less(most), below, most);
    R::select(R::ZERO.less(step), most, limit)
}
