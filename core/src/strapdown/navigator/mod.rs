//! The navigator: samples go in one by one, states come out block by block.
//!
//! Look-ahead delays a row but does not change it. The first block of a window with history looks
//! ahead instead, and the last blocks look back. So a stream of any length ends with a row for every sample.
//!
//! | file | what it has |
//! |---|---|
//! | `take` | samples in; when a block is integrated |
//! | `crossing` | the step over a block, and the rows within it |
//! | `edges` | the first and the last blocks of a stream |
//! | `unequal` | blocks of samples of unequal intervals |
//! | [`selected`] | a navigator whose window is chosen at run time |
//! | `correct` | a running state corrected |
//! | `stream` | the same without the type of the window |
//! | `rows` | whether and by whom rows within a block are read |
//! | `mechanization` | the navigator as a mechanization |
//! | `check`, `stored` | a state as bytes, and its check |
//!
//! ```
//! use schuler::earth::Geodetic;
//! use schuler::math::{compensated::Pair, vector::Vector};
//! use schuler::sample::Increment;
//! use schuler::solution::{Euler, Solution};
//! use schuler::strapdown::block::window::H2B4A2;
//! use schuler::strapdown::frame::earth_fixed::EarthFixed;
//! use schuler::strapdown::navigator::Strapdown;
//!
//! let at = Geodetic { latitude: 0.8_f64, longitude: 0.1, altitude: 100.0 };
//! let initial = Solution::new(at, Vector::ZERO, Euler::default());
//! let navigator = Strapdown::<EarthFixed<Pair<f64>>, H2B4A2>::new(Pair::of(0.01))?;
//! let mut state = navigator.start(&initial)?;
//! let sample = Increment { angle_b: Vector::ZERO, velocity_b: Vector::new(0.0, 0.0, -0.0981) };
//! let mut rows = 0;
//! for _ in 0..101 {
//!     navigator.push_rows(&mut state, sample, |_, _| rows += 1)?;
//! }
//! navigator.finish_rows(&mut state, |_, _| rows += 1);
//! assert_eq!((rows, state.integrated()), (101, 101));
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```

mod check;
mod correct;
mod crossing;
mod edges;
mod mechanization;
mod rows;
pub mod selected;
mod stored;
mod stream;
mod take;
mod unequal;

use crate::math::compensated::Pair;
use crate::math::real::Real;
use crate::sample::Increment;
use crate::solution::Solution;
use crate::strapdown::block::body::BodyMotion;
use crate::strapdown::block::intervals::Intervals as _;
use crate::strapdown::block::newton::Edges;
use crate::strapdown::block::window::Window;
use crate::strapdown::frame::{Blank, Frame};
use crate::strapdown::gate::{Gate, admit_start, interval_of};
use crate::strapdown::limits::{Limits, Rejected, StartError};
use crate::strapdown::navigator::rows::{Blocks, Every, Unread};
use crate::strapdown::navigator::stream::{Progress, Timing};
use core::marker::PhantomData;

/// Configuration of a strapdown navigator in frame `F` with window `W`.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Strapdown<F: Frame, W> {
    timing: Timing<F::Real>,
    gate: Gate<F::Real>,
    window: PhantomData<W>,
}

/// State of a strapdown navigator: `Copy`, so that it can be stored, compared or used for a prediction.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct State<F: Frame, W: Window> {
    pub(crate) frame: F,
    /// The latest samples, of which the last pending ones are not integrated yet.
    pub(crate) samples: W::Samples<Increment<F::Real>>,
    pub(crate) progress: Progress<F::Real>,
    pub(crate) intervals: W::Intervals<F::Real>,
}

impl<F: Frame, W: Window> State<F, W> {
    /// A state to be restored.
    #[doc(hidden)]
    pub fn blank() -> Self
    where
        F: Blank,
    {
        Self::of(F::blank())
    }

    /// Before the first sample.
    fn of(frame: F) -> Self {
        Self {
            frame,
            samples: W::samples(Increment::ZERO),
            progress: Progress::none(),
            intervals: W::Intervals::nominal(),
        }
    }

    /// Navigation at the end of the last block.
    pub fn output(&self) -> F::Output {
        self.frame.output()
    }

    /// Samples integrated since the start: the index of the sample that `output` belongs to.
    pub fn integrated(&self) -> u64 {
        self.progress.integrated
    }

    /// Whether its next blocks are within the stream: [`Strapdown::push_inside`] is enough for them.
    #[doc(hidden)]
    pub fn is_inside(&self) -> bool {
        self.progress.integrated > 0 && self.progress.past() >= W::HISTORY
    }

    /// The number of samples that first and last blocks were fitted to.
    pub fn edges(&self) -> Edges<F::Real> {
        self.progress.edges
    }
}

impl<R: Real, F: Frame<Real = R>, W: Window> Strapdown<F, W> {
    /// With a sampling interval in seconds and the default limits. In [`Pair::new`] a number such as 0.01 is already
    /// rounded. [`Strapdown::from_rate_hz`] is exact.
    ///
    /// # Errors
    ///
    /// [`StartError`] if the interval or a limit is out of range.
    pub fn new(interval_s: Pair<R>) -> Result<Self, StartError> {
        Self::with_limits(interval_s, Limits::default())
    }

    /// With a sampling rate in hertz. The interval is its reciprocal, to twice the digits of `R`.
    ///
    /// ```
    /// use schuler::Navigator4;
    ///
    /// let navigator = Navigator4::<f32>::from_rate_hz(100.0)?;
    /// # Ok::<(), schuler::StartError>(())
    /// ```
    #[inline]
    pub fn from_rate_hz(rate_hz: f64) -> Result<Self, StartError> {
        Self::new(interval_of(rate_hz))
    }

    /// With a sampling interval in seconds, to twice the digits of `f32`, or to the digits of `f64`. 1/100 is not a
    /// binary fraction: if the rate is a round number, [`Strapdown::from_rate_hz`] is exact.
    #[inline]
    pub fn from_interval_s(interval_s: f64) -> Result<Self, StartError> {
        Self::new(Pair::of(interval_s))
    }

    /// With a sampling interval in seconds and limits.
    ///
    /// # Errors
    ///
    /// [`StartError`] if the interval or a limit is out of range.
    pub fn with_limits(interval_s: Pair<R>, limits: Limits<R>) -> Result<Self, StartError> {
        Ok(Self {
            timing: Timing::new(interval_s, W::BLOCK, W::TERMS),
            gate: Gate::new(interval_s.hi + interval_s.lo, limits, W::BLOCK)?,
            window: PhantomData,
        })
    }

    /// With a series of the order that [`plan::order`](crate::flight::plan::order) finds sufficient, at most
    /// that of the window.
    pub fn with_order(self, order: usize) -> Self {
        let order = order.clamp(1, W::TERMS);
        Self { timing: Timing { order, ..self.timing }, ..self }
    }

    /// Starts from an initial solution, whose attitude is brought to unit length.
    ///
    /// # Errors
    ///
    /// [`StartError`] if the initial solution is out of range, or navigation cannot start at its place.
    pub fn start(&self, initial: &Solution<R>) -> Result<State<F, W>, StartError> {
        let initial = admit_start(initial)?;
        let frame = F::start(&initial);
        frame.check_place()?;
        Ok(State::of(frame))
    }

    /// Takes a sample; the state moves on whenever a block is complete.
    ///
    /// # Errors
    ///
    /// [`Rejected`] if the sample is refused. The state is then unchanged.
    #[inline(always)]
    pub fn push(&self, state: &mut State<F, W>, sample: Increment<R>) -> Result<(), Rejected> {
        self.gate.admit(&sample)?;
        self.take::<true>(state, sample, R::ZERO, &mut Unread)
    }

    /// The same for a stream that [`State::is_inside`], in a window with look-ahead or without history. It has no
    /// code for edges, which lanes would compile in vain.
    #[doc(hidden)]
    #[inline(always)]
    pub fn push_inside(
        &self,
        state: &mut State<F, W>,
        sample: Increment<R>,
    ) -> Result<(), Rejected> {
        self.gate.admit(&sample)?;
        self.take::<false>(state, sample, R::ZERO, &mut Unread)
    }

    /// Takes a sample and reads every row that it completes: the number of samples up to the row, and
    /// the navigation there.
    ///
    /// # Errors
    ///
    /// [`Rejected`] if the sample is refused. The state is then unchanged.
    #[inline(always)]
    pub fn push_rows(
        &self,
        state: &mut State<F, W>,
        sample: Increment<R>,
        read: impl FnMut(u64, F::Output),
    ) -> Result<(), Rejected> {
        self.gate.admit(&sample)?;
        self.take::<true>(state, sample, R::ZERO, &mut Every(read))
    }

    /// Takes a sample and shows every block that it completes, step by step: the number of samples at
    /// the block's end, the body's motion over it, and the frame after it.
    ///
    /// # Errors
    ///
    /// [`Rejected`] if the sample is refused. The state is then unchanged.
    pub fn push_blocks(
        &self,
        state: &mut State<F, W>,
        sample: Increment<R>,
        see: impl FnMut(u64, &BodyMotion<R>, &F),
    ) -> Result<(), Rejected> {
        self.gate.admit(&sample)?;
        self.take::<true>(state, sample, R::ZERO, &mut Blocks(see))
    }

    /// Integrates all pending samples at the end of the stream. More samples may still follow.
    pub fn finish(&self, state: &mut State<F, W>) {
        self.end(state, &mut Unread);
    }

    /// The same, reading every row.
    pub fn finish_rows(&self, state: &mut State<F, W>, read: impl FnMut(u64, F::Output)) {
        self.end(state, &mut Every(read));
    }

    /// The same, showing every block.
    pub fn finish_blocks(&self, state: &mut State<F, W>, see: impl FnMut(u64, &BodyMotion<R>, &F)) {
        self.end(state, &mut Blocks(see));
    }

    /// Navigation at the newest sample, without the look-ahead that its rows wait for.
    pub fn predict(&self, state: &State<F, W>) -> F::Output {
        let mut ahead = *state;
        self.finish(&mut ahead);
        ahead.output()
    }
}
