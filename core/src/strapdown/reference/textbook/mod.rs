//! The textbook mechanization: a step per sample, with the previous sample for coning and sculling.
//!
//! It is the kind of algorithm that the paper uses (§2.4: quaternion, attitude matrix, velocity, position),
//! after Savage, *Strapdown Inertial Navigation Integration Algorithm Design*, J. Guidance 21 (1998), and
//! Groves, 2nd ed., §5.5; with the complete rotation of the velocity increment. Gravity, Coriolis and
//! transport rate are taken at the middle of the step. It calls no trigonometric function: sines and cosines
//! advance by increments.
//!
//! ```
//! use schuler::earth::Geodetic;
//! use schuler::math::{compensated::Pair, vector::Vector};
//! use schuler::sample::Increment;
//! use schuler::solution::{Euler, Solution};
//! use schuler::strapdown::mechanization::Mechanization;
//! use schuler::strapdown::reference::textbook::{LocalLevelTextbook, Textbook};
//!
//! let at = Geodetic { latitude: 0.8_f64, longitude: 0.1, altitude: 100.0 };
//! let initial = Solution::new(at, Vector::ZERO, Euler::default());
//! let navigator = Textbook::<LocalLevelTextbook<f64>>::new(0.01)?;
//! let mut state = navigator.start(&initial)?;
//! let sample = Increment { angle_b: Vector::ZERO, velocity_b: Vector::new(0.0, 0.0, -0.0981) };
//! navigator.push(&mut state, sample)?;
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```

pub mod body;
pub mod earth_fixed;
mod frame;
pub mod local_level;
mod stored;

pub use earth_fixed::EarthFixedTextbook;
pub use frame::TextbookFrame;
pub use local_level::LocalLevelTextbook;

use crate::math::compensated::Pair;
use crate::math::real::Real;
use crate::sample::Increment;
use crate::solution::Solution;
use crate::strapdown::correction::{Correction, CorrectionError};
use crate::strapdown::gate::{Gate, admit_held, admit_start, interval_of};
use crate::strapdown::limits::{Limits, Rejected, StartError};
use crate::strapdown::mechanization::{Mechanization, UnequalIntervals};
use crate::strapdown::plausible::{Damaged, MOST_COUNTED};
use body::Compensated;
use core::marker::PhantomData;

/// Configuration of the textbook navigator in frame `F`.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Textbook<F: TextbookFrame> {
    interval: F::Real,
    gate: Gate<F::Real>,
    frame: PhantomData<F>,
}

/// State of the textbook navigator.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TextbookState<F: TextbookFrame> {
    pub(super) frame: F,
    pub(super) previous: Increment<F::Real>,
    pub(super) integrated: u64,
}

impl<F: TextbookFrame> Textbook<F> {
    /// With a sampling interval in seconds and the default limits.
    ///
    /// # Errors
    ///
    /// [`StartError`] if the interval or a limit is out of range.
    pub fn new(interval_s: F::Real) -> Result<Self, StartError> {
        Self::with_limits(interval_s, Limits::default())
    }

    /// With a sampling rate in hertz: the interval is its reciprocal, rounded once to the digits of the
    /// frame's scalar, which is all that this algorithm keeps of it.
    #[inline]
    pub fn from_rate_hz(rate_hz: f64) -> Result<Self, StartError> {
        Self::new(interval_of::<F::Real>(rate_hz).hi)
    }

    /// With a sampling interval in seconds, rounded to the digits of the frame's scalar.
    #[inline]
    pub fn from_interval_s(interval_s: f64) -> Result<Self, StartError> {
        Self::new(F::Real::of(interval_s))
    }

    /// With a sampling interval in seconds and limits.
    ///
    /// # Errors
    ///
    /// [`StartError`] if the interval or a limit is out of range.
    pub fn with_limits(interval_s: F::Real, limits: Limits<F::Real>) -> Result<Self, StartError> {
        Ok(Self {
            interval: interval_s,
            gate: Gate::new(interval_s, limits, 1)?,
            frame: PhantomData,
        })
    }

    /// Steps over a sample if it can be right; returns the body's motion over it.
    #[inline(always)]
    fn step(
        &self,
        state: &mut TextbookState<F>,
        sample: Increment<F::Real>,
    ) -> Result<Compensated<F::Real>, Rejected> {
        self.gate.admit(&sample)?;
        state.frame.check_place()?;
        let body = Compensated::from_samples(&sample, &state.previous);
        state.frame.step(self.interval, &body);
        state.previous = sample;
        state.integrated += 1;
        Ok(body)
    }

    /// The same with an interval of its own, s.
    #[inline(never)]
    fn step_over(
        &self,
        state: &mut TextbookState<F>,
        sample: Increment<F::Real>,
        interval_s: Pair<F::Real>,
    ) -> Result<Compensated<F::Real>, Rejected> {
        let interval_s = interval_s.hi + interval_s.lo;
        if (interval_s - self.interval).is_within(F::Real::ZERO) {
            return self.step(state, sample);
        }
        self.gate.admit_over(&sample, interval_s)?;
        state.frame.check_place()?;
        // The sample is kept as it would be over the nominal interval.
        let longer = interval_s / self.interval;
        let shorter = self.interval / interval_s;
        state.frame.stretch(longer);
        let body = Compensated::from_samples(&sample, &scaled(&state.previous, longer));
        state.frame.step(interval_s, &body);
        state.frame.stretch(shorter);
        state.previous = scaled(&sample, shorter);
        state.integrated += 1;
        Ok(body)
    }
}

/// A sample of the same steady motion over an interval that is longer by a factor.
fn scaled<R: Real>(sample: &Increment<R>, factor: R) -> Increment<R> {
    Increment { angle_b: sample.angle_b * factor, velocity_b: sample.velocity_b * factor }
}

impl<F: TextbookFrame> UnequalIntervals for Textbook<F> {
    fn push_over(
        &self,
        state: &mut TextbookState<F>,
        sample: Increment<F::Real>,
        interval_s: Pair<F::Real>,
    ) -> Result<(), Rejected> {
        self.step_over(state, sample, interval_s).map(|_| ())
    }

    fn push_rows_over(
        &self,
        state: &mut TextbookState<F>,
        sample: Increment<F::Real>,
        interval_s: Pair<F::Real>,
        mut read: impl FnMut(u64, F::Output),
    ) -> Result<(), Rejected> {
        self.step_over(state, sample, interval_s)?;
        read(state.integrated, state.frame.output());
        Ok(())
    }

    fn push_blocks_over(
        &self,
        state: &mut TextbookState<F>,
        sample: Increment<F::Real>,
        interval_s: Pair<F::Real>,
        mut see: impl FnMut(u64, &Compensated<F::Real>, &F),
    ) -> Result<(), Rejected> {
        let body = self.step_over(state, sample, interval_s)?;
        see(state.integrated, &body, &state.frame);
        Ok(())
    }
}

impl<F: TextbookFrame> Mechanization for Textbook<F> {
    type Real = F::Real;
    type Frame = F;
    type State = TextbookState<F>;
    type Output = F::Output;
    type Body = Compensated<F::Real>;

    fn start(&self, initial: &Solution<F::Real>) -> Result<TextbookState<F>, StartError> {
        let initial = admit_start(initial)?;
        let frame = F::start(&initial);
        frame.check_place()?;
        // No previous sample: no rotation and no force, hence no coning and no sculling.
        Ok(TextbookState { frame, previous: Increment::ZERO, integrated: 0 })
    }

    #[inline(always)]
    fn push(
        &self,
        state: &mut TextbookState<F>,
        sample: Increment<F::Real>,
    ) -> Result<(), Rejected> {
        self.step(state, sample).map(|_| ())
    }

    #[inline(always)]
    fn push_rows(
        &self,
        state: &mut TextbookState<F>,
        sample: Increment<F::Real>,
        mut read: impl FnMut(u64, F::Output),
    ) -> Result<(), Rejected> {
        self.push(state, sample)?;
        read(state.integrated, state.frame.output());
        Ok(())
    }

    fn finish(&self, _: &mut TextbookState<F>) {}

    fn finish_rows(&self, _: &mut TextbookState<F>, _: impl FnMut(u64, F::Output)) {}

    fn push_blocks(
        &self,
        state: &mut TextbookState<F>,
        sample: Increment<F::Real>,
        mut see: impl FnMut(u64, &Compensated<F::Real>, &F),
    ) -> Result<(), Rejected> {
        let body = self.step(state, sample)?;
        see(state.integrated, &body, &state.frame);
        Ok(())
    }

    fn finish_blocks(
        &self,
        _: &mut TextbookState<F>,
        _: impl FnMut(u64, &Compensated<F::Real>, &F),
    ) {
    }

    fn hold_vertical(
        &self,
        state: &mut TextbookState<F>,
        altitude: F::Real,
        down: F::Real,
    ) -> Result<(), Rejected> {
        admit_held(altitude, down)?;
        state.frame.hold_vertical(altitude, down);
        Ok(())
    }

    fn correct(
        &self,
        state: &mut TextbookState<F>,
        correction: &Correction<F::Real>,
    ) -> Result<(), CorrectionError> {
        correction.apply(&mut state.frame, F::correct)
    }

    fn check(&self, state: &TextbookState<F>) -> Result<(), Damaged> {
        let sound = state.integrated <= MOST_COUNTED
            && self.gate.admit(&state.previous).is_ok()
            && state.frame.is_plausible();
        if sound { Ok(()) } else { Err(Damaged) }
    }

    fn frame(state: &TextbookState<F>) -> &F {
        &state.frame
    }

    fn integrated(state: &TextbookState<F>) -> u64 {
        state.integrated
    }

    fn output(&self, state: &TextbookState<F>) -> F::Output {
        state.frame.output()
    }
}
