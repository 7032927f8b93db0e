//! Blocks of samples that differ in length: rare, hence out of line, and linked only if used.

use super::rows::{Blocks, Chosen, Every, Read, Unread};
use super::stream::{Place, Stream};
use super::{State, Strapdown};
use crate::math::compensated::Pair;
use crate::math::real::Real;
use crate::sample::Increment;
use crate::strapdown::block::abscissae::Spaced;
use crate::strapdown::block::any_window::{Layout, Numbers};
use crate::strapdown::block::body::{self, BodyMotion, Sum};
use crate::strapdown::block::fit::{Fit, MOST_SAMPLES};
use crate::strapdown::block::intervals::Intervals as _;
use crate::strapdown::block::series::Series;
use crate::strapdown::block::shape::WindowShape;
use crate::strapdown::block::unequal::Unequal;
use crate::strapdown::block::window::Window;
use crate::strapdown::frame::Frame;
use crate::strapdown::frame::block_time::BlockTime;
use crate::strapdown::limits::Rejected;
use crate::strapdown::mechanization::UnequalIntervals;

/// Terms of the series where the planned order may be too low.
const MOST_TERMS: usize = 16;
/// Samples before and after a block at an edge: few, because their intervals may differ much.
const BESIDE_AT_EDGE: usize = 4;
/// Up to this factor of the nominal duration a block uses the planned order.
const PLANNED: f64 = 1.25;
/// Up to this factor of the duration of the block before it a block takes over its gravity history.
const MOST_STRETCH: f64 = 2.0;

/// Integrates a block: one copy of the code for all frames, windows and readers.
#[inline(never)]
fn integrate<R: Real>(
    fit: &Fit<R, MOST_SAMPLES>,
    sum: &Sum<R>,
    half_time_s: R,
    order: usize,
) -> (BodyMotion<R>, Series<R, { MOST_TERMS + 1 }>) {
    body::integrate(fit, sum, half_time_s, order)
}

/// The sum of a block's increments.
fn sum<R: Real>(samples: &[Increment<R>], two_float: bool) -> Sum<R> {
    if two_float {
        return Sum::exact(samples);
    }
    let add = |sum: Increment<R>, sample: &Increment<R>| Increment {
        angle_b: sum.angle_b + sample.angle_b,
        velocity_b: sum.velocity_b + sample.velocity_b,
    };
    Sum::rounded(samples.iter().fold(Increment::ZERO, add))
}

impl<R, F, K, const UNEQUAL: bool> Stream<'_, F, K, UNEQUAL>
where
    R: Real,
    F: Frame<Real = R>,
    K: Layout<R>,
{
    /// Whether the `all` samples from the `history`-th before the block on last the nominal interval.
    #[inline]
    pub fn is_nominal(&self, history: usize, all: usize) -> bool {
        let progress = &self.place.progress;
        let begin = progress.filled.saturating_sub(progress.pending + history);
        let excess = self.excess.iter().skip(begin).take(all);
        excess.fold(true, |nominal, x| nominal & x.is_within(R::ZERO))
    }

    /// A block of `block` samples with `history` before it and `lookahead` after it; `edge` at the first
    /// and the last ones.
    #[inline(never)]
    pub fn unequal_block<Q: Chosen<F> + ?Sized>(
        &mut self,
        WindowShape { history, block, lookahead }: WindowShape,
        edge: bool,
        read: &mut Q,
    ) {
        let most = if edge { BESIDE_AT_EDGE } else { MOST_SAMPLES };
        let lookahead = lookahead.min(most);
        let history = history.min(most - lookahead);
        let progress = &self.place.progress;
        let begin = progress.filled.saturating_sub(progress.pending + history);
        let (samples, excess) = (self.samples, self.excess);
        let all = begin..begin + history + block + lookahead;
        let own = begin + history..begin + history + block;
        let own_excess = excess.get(own.clone()).unwrap_or(&[]);
        let interval_s = self.timing.interval;
        let nominal = interval_s * Pair::new(R::count(block as u32));
        let time = own_excess.iter().fold(nominal, |time, &excess| time + Pair::new(excess));
        let time = BlockTime::lasting(time);
        let spaced = Spaced {
            samples: samples.get(all.clone()).unwrap_or(&[]),
            excess: excess.get(all).unwrap_or(&[]),
            interval_s,
            history,
            block,
            time_s: time.time,
        };
        let &Numbers { shape, coefficients, .. } = self.window.numbers();
        let near = (!edge && coefficients < shape.samples()).then_some(coefficients);
        let fit = spaced.fit(near);
        let sum = sum(samples.get(own).unwrap_or(&[]), F::TWO_FLOAT);
        let planned = !edge & !R::any((nominal.hi * R::of(PLANNED)).less(time.time.hi));
        let order = if planned { self.timing.order } else { MOST_TERMS };
        let (body, series) = integrate(&fit, &sum, time.half, order);
        self.place.step::<true, _>((&time, own_excess), interval_s.hi, block, &body, &series, read);
    }
}

impl<R: Real, F: Frame<Real = R>, const UNEQUAL: bool> Place<'_, F, UNEQUAL> {
    /// Brings the gravity history to a block of this duration, or sets it up anew.
    #[inline(never)]
    pub fn adapt_history(&mut self, interval: R, time: &BlockTime<R>, body: &BodyMotion<R>) {
        let kept = *self.history_s;
        let counted = interval * R::count(self.progress.seeded as u32);
        let known = R::ZERO.less(kept);
        let before = R::select(known, kept, counted);
        let most = before * R::of(MOST_STRETCH);
        if R::any(most.less(time.time.hi)) {
            self.frame.seed(time, body);
        } else {
            self.frame.stretch(time.time.hi / before);
        }
    }
}

impl<R: Real, F: Frame<Real = R>, W: Window> Strapdown<F, Unequal<W>> {
    /// Takes a sample with its own interval in seconds, above 0 s and at most 1 s; the state moves on
    /// whenever a block is complete. At the nominal interval the result is that of `push`, bit for bit, and the
    /// two may be mixed.
    ///
    /// ```
    /// use schuler::math::compensated::Pair;
    /// use schuler::sample::Increment;
    /// use schuler::strapdown::frame::local_level::LocalLevel;
    /// use schuler::strapdown::navigator::Strapdown;
    /// use schuler::strapdown::block::unequal::Unequal;
    /// use schuler::strapdown::block::window::H2B4A2;
    ///
    /// # fn main() -> Result<(), Box<dyn core::error::Error>> {
    /// # use schuler::solution::{Euler, Solution};
    /// # let level = Euler { roll: 0.0, pitch: 0.0, yaw: 0.0 };
    /// # let initial = Solution::new(Default::default(), Default::default(), level);
    /// # let sample = Increment::ZERO;
    /// // 100 Hz; a counter of microseconds has the interval of each sample.
    /// let navigator = Strapdown::<LocalLevel<Pair<f32>>, Unequal<H2B4A2>>::new(Pair::of(0.01))?;
    /// let mut state = navigator.start(&initial)?;
    /// let microseconds = 10_013_u16;
    /// let interval_s = Pair::new(microseconds.into()) * Pair::of(1e-6);
    /// navigator.push_over(&mut state, sample, interval_s)?;
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    ///
    /// [`Rejected`] if the sample or its interval is refused. The state is then unchanged.
    #[inline(always)]
    pub fn push_over(
        &self,
        state: &mut State<F, Unequal<W>>,
        sample: Increment<R>,
        interval_s: Pair<R>,
    ) -> Result<(), Rejected> {
        self.take_over(state, sample, interval_s, &mut Unread)
    }

    /// The same, reading every row that the sample completes.
    ///
    /// # Errors
    ///
    /// [`Rejected`] if the sample or its interval is refused. The state is then unchanged.
    #[inline(always)]
    pub fn push_rows_over(
        &self,
        state: &mut State<F, Unequal<W>>,
        sample: Increment<R>,
        interval_s: Pair<R>,
        read: impl FnMut(u64, F::Output),
    ) -> Result<(), Rejected> {
        self.take_over(state, sample, interval_s, &mut Every(read))
    }

    /// The same, showing every block that it completes, step by step.
    ///
    /// # Errors
    ///
    /// [`Rejected`] if the sample or its interval is refused. The state is then unchanged.
    pub fn push_blocks_over(
        &self,
        state: &mut State<F, Unequal<W>>,
        sample: Increment<R>,
        interval_s: Pair<R>,
        see: impl FnMut(u64, &BodyMotion<R>, &F),
    ) -> Result<(), Rejected> {
        self.take_over(state, sample, interval_s, &mut Blocks(see))
    }

    #[inline(always)]
    fn take_over(
        &self,
        state: &mut State<F, Unequal<W>>,
        sample: Increment<R>,
        interval_s: Pair<R>,
        read: &mut impl Read<F>,
    ) -> Result<(), Rejected> {
        self.gate.admit_over(&sample, interval_s.hi + interval_s.lo)?;
        let before = state.intervals;
        let excess = state.intervals.over(interval_s, self.timing.interval);
        let taken = self.take::<true>(state, sample, excess, read);
        if taken.is_err() {
            state.intervals = before;
        }
        taken
    }
}

impl<F: Frame, W: Window> UnequalIntervals for Strapdown<F, Unequal<W>> {
    #[inline]
    fn push_over(
        &self,
        state: &mut State<F, Unequal<W>>,
        sample: Increment<F::Real>,
        interval_s: Pair<F::Real>,
    ) -> Result<(), Rejected> {
        Strapdown::push_over(self, state, sample, interval_s)
    }
    #[inline]
    fn push_rows_over(
        &self,
        state: &mut State<F, Unequal<W>>,
        sample: Increment<F::Real>,
        interval_s: Pair<F::Real>,
        read: impl FnMut(u64, F::Output),
    ) -> Result<(), Rejected> {
        Strapdown::push_rows_over(self, state, sample, interval_s, read)
    }
    fn push_blocks_over(
        &self,
        state: &mut State<F, Unequal<W>>,
        sample: Increment<F::Real>,
        interval_s: Pair<F::Real>,
        see: impl FnMut(u64, &BodyMotion<F::Real>, &F),
    ) -> Result<(), Rejected> {
        Strapdown::push_blocks_over(self, state, sample, interval_s, see)
    }
}
