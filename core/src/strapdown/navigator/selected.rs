//! A navigator whose window is chosen at run time: one type, and one copy of the code, for all windows of a frame.
//!
//! Its bits are those of [`Strapdown`](super::Strapdown) with the same window, and it takes samples of any
//! length. It keeps room for the largest window.
//!
//! ```
//! use schuler::earth::Geodetic;
//! use schuler::math::{compensated::Pair, vector::Vector};
//! use schuler::sample::Increment;
//! use schuler::solution::{Euler, Solution};
//! use schuler::strapdown::block::any_window::AnyWindow;
//! use schuler::strapdown::block::window::{H0B4A0, H2B4A2};
//! use schuler::strapdown::frame::local_level::LocalLevel;
//! use schuler::strapdown::mechanization::Mechanization;
//! use schuler::strapdown::navigator::selected::Selected;
//!
//! let at = Geodetic { latitude: 0.8_f64, longitude: 0.1, altitude: 100.0 };
//! let initial = Solution::new(at, Vector::ZERO, Euler::default());
//! let fast = true;
//! let window = if fast { AnyWindow::of::<H2B4A2>() } else { AnyWindow::of::<H0B4A0>() };
//! let navigator = Selected::<LocalLevel<Pair<f64>>>::new(Pair::of(0.01), window)?;
//! let mut state = navigator.start(&initial)?;
//! let sample = Increment { angle_b: Vector::ZERO, velocity_b: Vector::new(0.0, 0.0, -0.0981) };
//! for _ in 0..100 {
//!     navigator.push(&mut state, sample)?;
//! }
//! navigator.finish(&mut state);
//! assert!(navigator.output(&state).velocity_ned.z.hi.abs() < 1e-2);
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```

use super::check::check;
use super::correct;
use super::rows::{Blocks, Every, Read, Unread};
use super::stream::{Progress, Room, Timing};
use crate::math::compensated::Pair;
use crate::math::real::Real;
use crate::record::Record;
use crate::sample::Increment;
use crate::solution::Solution;
use crate::strapdown::block::any_window::AnyWindow;
use crate::strapdown::block::body::BodyMotion;
use crate::strapdown::block::intervals::{Intervals as _, Kept};
use crate::strapdown::block::newton::Edges;
use crate::strapdown::block::window::*;
use crate::strapdown::correction::{Correction, CorrectionError};
use crate::strapdown::frame::Frame;
use crate::strapdown::gate::{Gate, admit_held, admit_start};
use crate::strapdown::limits::{Limits, Rejected, StartError};
use crate::strapdown::mechanization::{Mechanization, UnequalIntervals};
use crate::strapdown::plausible::Damaged;

/// Samples that there is room for: those of the largest window.
const MOST_STORED: usize = {
    macro_rules! most {
        ($($window:ident),+) => {{
            let mut most = 0;
            $(if $window::STORED > most {
                most = $window::STORED;
            })+
            most
        }};
    }
    every_window! { most! }
};

/// Configuration of a navigator in frame `F` with any window.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Selected<F: Frame> {
    timing: Timing<F::Real>,
    gate: Gate<F::Real>,
    window: AnyWindow<F::Real>,
}

/// Its state.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SelectedState<F: Frame> {
    frame: F,
    samples: [Increment<F::Real>; MOST_STORED],
    intervals: Kept<F::Real, [F::Real; MOST_STORED]>,
    progress: Progress<F::Real>,
}

impl<R: Real, F: Frame<Real = R>> Selected<F> {
    /// With a sampling interval in seconds, a window and the default limits.
    ///
    /// # Errors
    ///
    /// [`StartError`] if the interval is out of range.
    pub fn new(interval_s: Pair<R>, window: AnyWindow<R>) -> Result<Self, StartError> {
        let numbers = window.numbers();
        let block = numbers.shape.block;
        Ok(Self {
            timing: Timing::new(interval_s, block, numbers.terms),
            gate: Gate::new(interval_s.hi + interval_s.lo, Limits::default(), block)?,
            window,
        })
    }

    /// With a series of this order, at most that of the window.
    pub fn with_order(self, order: usize) -> Self {
        let order = order.clamp(1, self.window.numbers().terms);
        Self { timing: Timing { order, ..self.timing }, ..self }
    }

    fn room<'a>(
        &'a self,
        state: &'a mut SelectedState<F>,
    ) -> Option<Room<'a, F, &'a AnyWindow<R>>> {
        let SelectedState { frame, samples, intervals, progress } = state;
        let (excess, history_s) = intervals.kept_mut()?;
        let (timing, window) = (&self.timing, &self.window);
        Some(Room { frame, samples, excess, progress, history_s, timing, window })
    }

    fn take(
        &self,
        state: &mut SelectedState<F>,
        sample: Increment<R>,
        read: &mut dyn Read<F>,
    ) -> Result<(), Rejected> {
        self.gate.admit(&sample)?;
        self.room(state).map_or(Ok(()), |room| room.take(sample, R::ZERO, read))
    }

    fn take_over(
        &self,
        state: &mut SelectedState<F>,
        sample: Increment<R>,
        interval_s: Pair<R>,
        read: &mut dyn Read<F>,
    ) -> Result<(), Rejected> {
        self.gate.admit_over(&sample, interval_s.hi + interval_s.lo)?;
        let before = state.intervals;
        let excess = state.intervals.over(interval_s, self.timing.interval);
        let taken = self.room(state).map_or(Ok(()), |room| room.take(sample, excess, read));
        if taken.is_err() {
            state.intervals = before;
        }
        taken
    }

    fn end(&self, state: &mut SelectedState<F>, read: &mut dyn Read<F>) {
        if let Some(room) = self.room(state) {
            room.finish(read);
        }
    }
}

impl<R: Real, F: Frame<Real = R>> Mechanization for Selected<F> {
    type Real = R;
    type Frame = F;
    type State = SelectedState<F>;
    type Output = F::Output;
    type Body = BodyMotion<R>;

    fn start(&self, initial: &Solution<R>) -> Result<SelectedState<F>, StartError> {
        let frame = F::start(&admit_start(initial)?);
        frame.check_place()?;
        Ok(SelectedState {
            frame,
            samples: [Increment::ZERO; MOST_STORED],
            intervals: Kept::nominal(),
            progress: Progress::none(),
        })
    }
    fn push(&self, state: &mut SelectedState<F>, sample: Increment<R>) -> Result<(), Rejected> {
        self.take(state, sample, &mut Unread)
    }
    fn push_rows(
        &self,
        state: &mut SelectedState<F>,
        sample: Increment<R>,
        read: impl FnMut(u64, F::Output),
    ) -> Result<(), Rejected> {
        self.take(state, sample, &mut Every(read))
    }
    fn push_blocks(
        &self,
        state: &mut SelectedState<F>,
        sample: Increment<R>,
        see: impl FnMut(u64, &BodyMotion<R>, &F),
    ) -> Result<(), Rejected> {
        self.take(state, sample, &mut Blocks(see))
    }
    fn finish(&self, state: &mut SelectedState<F>) {
        self.end(state, &mut Unread);
    }
    fn finish_rows(&self, state: &mut SelectedState<F>, read: impl FnMut(u64, F::Output)) {
        self.end(state, &mut Every(read));
    }
    fn finish_blocks(
        &self,
        state: &mut SelectedState<F>,
        see: impl FnMut(u64, &BodyMotion<R>, &F),
    ) {
        self.end(state, &mut Blocks(see));
    }
    fn hold_vertical(
        &self,
        state: &mut SelectedState<F>,
        altitude: R,
        down: R,
    ) -> Result<(), Rejected> {
        admit_held(altitude, down)?;
        state.frame.hold_vertical(altitude, down);
        Ok(())
    }
    fn correct(
        &self,
        state: &mut SelectedState<F>,
        correction: &Correction<R>,
    ) -> Result<(), CorrectionError> {
        correct::apply(correction, &mut state.frame, &mut state.progress, &mut state.intervals)
    }
    fn check(&self, state: &SelectedState<F>) -> Result<(), Damaged> {
        check(&state.frame, &state.samples, &state.progress, &self.gate, self.window.numbers())
    }
    fn frame(state: &SelectedState<F>) -> &F {
        &state.frame
    }
    fn integrated(state: &SelectedState<F>) -> u64 {
        state.progress.integrated
    }
    fn edges(state: &SelectedState<F>) -> Option<Edges<R>> {
        Some(state.progress.edges)
    }
    fn output(&self, state: &SelectedState<F>) -> F::Output {
        state.frame.output()
    }
}

impl<R: Real, F: Frame<Real = R>> UnequalIntervals for Selected<F> {
    fn push_over(
        &self,
        state: &mut SelectedState<F>,
        sample: Increment<R>,
        interval_s: Pair<R>,
    ) -> Result<(), Rejected> {
        self.take_over(state, sample, interval_s, &mut Unread)
    }
    fn push_rows_over(
        &self,
        state: &mut SelectedState<F>,
        sample: Increment<R>,
        interval_s: Pair<R>,
        read: impl FnMut(u64, F::Output),
    ) -> Result<(), Rejected> {
        self.take_over(state, sample, interval_s, &mut Every(read))
    }
    fn push_blocks_over(
        &self,
        state: &mut SelectedState<F>,
        sample: Increment<R>,
        interval_s: Pair<R>,
        see: impl FnMut(u64, &BodyMotion<R>, &F),
    ) -> Result<(), Rejected> {
        self.take_over(state, sample, interval_s, &mut Blocks(see))
    }
}

impl<F: Frame<Real: Record> + Record> Record for SelectedState<F> {
    fn record(&self, name: &'static str, read: &mut impl FnMut(&'static str, u64)) {
        self.frame.record(name, read);
        self.samples.record("samples", read);
        self.progress.record(name, read);
        self.intervals.record_kept(read);
        self.progress.edges.record("edges", read);
    }
    fn restore(&mut self, name: &'static str, write: &mut impl FnMut(&'static str, u64) -> u64) {
        self.frame.restore(name, write);
        self.samples.restore("samples", write);
        self.progress.restore(name, write);
        self.intervals.restore_kept(write);
        self.progress.edges.restore("edges", write);
    }
}
