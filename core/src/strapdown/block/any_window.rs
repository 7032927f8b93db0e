//! A window as a value, for a navigator whose window is chosen at run time.
//!
//! ```
//! use schuler::strapdown::block::any_window::AnyWindow;
//! use schuler::strapdown::block::window::{H2B4A2, Window};
//!
//! let window = AnyWindow::<f64>::of::<H2B4A2>();
//! assert_eq!(window.numbers().shape, H2B4A2::SHAPE);
//! ```

use super::body::BodyMotion;
use super::inside::BlockSeries;
use super::newton::Used;
use super::shape::WindowShape;
use super::unequal::Unequal;
use super::window::Window;
use crate::math::real::Real;
use crate::sample::Increment;

/// The numbers of a window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Numbers {
    /// Samples before, in and after the block.
    pub shape: WindowShape,
    /// Samples before the window that are used if they are there.
    pub beside: usize,
    /// Samples in the window of the first block.
    pub first: usize,
    /// Coefficients of the fit.
    pub coefficients: usize,
    /// Order of the series at most.
    pub terms: usize,
    /// Samples that there is room for.
    pub stored: usize,
}

impl Numbers {
    /// Those of a window.
    pub const fn of<W: Window>() -> Self {
        Self {
            shape: W::SHAPE,
            beside: W::BESIDE,
            first: W::FIRST,
            coefficients: W::COEFFICIENTS,
            terms: W::TERMS,
            stored: W::STORED,
        }
    }
}

/// How a block is integrated.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Integration<R> {
    /// Half of its duration, s.
    pub half_time_s: R,
    /// Order of the series.
    pub order: usize,
    /// Whether the motion includes the parts that rounding drops.
    pub two_float: bool,
}

/// What takes a block's motion, its series and, of a window without look-ahead, the samples that it was fitted to.
type Take<'a, R> = dyn FnMut(&BodyMotion<R>, &dyn BlockSeries<R>, Option<Used<R>>) + 'a;

type Whole<R> = fn(&[Increment<R>], usize, &Integration<R>, &mut Take<'_, R>) -> bool;

/// A window: its numbers, and its block's motion in the type `R`.
#[derive(Clone, Copy, Debug)]
pub struct AnyWindow<R: Real> {
    numbers: Numbers,
    whole: Whole<R>,
}

#[cfg(feature = "defmt")]
impl<R: Real> defmt::Format for AnyWindow<R> {
    fn format(&self, f: defmt::Formatter<'_>) {
        self.numbers.format(f);
    }
}

impl<R: Real> AnyWindow<R> {
    /// From its type.
    pub const fn of<W: Window>() -> Self {
        Self { numbers: Numbers::of::<W>(), whole: whole::<R, Unequal<W>> }
    }

    /// Its numbers.
    pub const fn numbers(&self) -> &Numbers {
        &self.numbers
    }
}

/// A window, known to the compiler or chosen at run time.
pub(crate) trait Layout<R: Real>: Copy {
    /// Its numbers.
    fn numbers(&self) -> &Numbers;
    /// Integrates the block of the window at the end of the samples, which begins at `begin`; false if there are
    /// too few samples to decide how.
    fn integrate(
        &self,
        seen: &[Increment<R>],
        begin: usize,
        how: &Integration<R>,
        take: impl FnMut(&BodyMotion<R>, &dyn BlockSeries<R>, Option<Used<R>>),
    ) -> bool;
}

impl<R: Real> Layout<R> for &AnyWindow<R> {
    #[inline(always)]
    fn numbers(&self) -> &Numbers {
        &self.numbers
    }
    #[inline(always)]
    fn integrate(
        &self,
        seen: &[Increment<R>],
        begin: usize,
        how: &Integration<R>,
        mut take: impl FnMut(&BodyMotion<R>, &dyn BlockSeries<R>, Option<Used<R>>),
    ) -> bool {
        (self.whole)(seen, begin, how, &mut take)
    }
}

/// A window known to the compiler: code for other windows is left out.
#[derive(Clone, Copy)]
pub(crate) struct Known<W>(pub W);

impl<R: Real, W: Window> Layout<R> for Known<W> {
    #[inline(always)]
    fn numbers(&self) -> &Numbers {
        const { &Numbers::of::<W>() }
    }
    #[inline(always)]
    fn integrate(
        &self,
        seen: &[Increment<R>],
        begin: usize,
        &Integration { half_time_s, order, two_float }: &Integration<R>,
        mut take: impl FnMut(&BodyMotion<R>, &dyn BlockSeries<R>, Option<Used<R>>),
    ) -> bool {
        if W::LOOKAHEAD == 0 && W::HISTORY > 0 {
            let integrated = W::integrate_behind(seen, half_time_s, order, two_float);
            integrated.map(|(body, series, used)| take(&body, &series, Some(used))).is_some()
        } else {
            let seen = seen.get(begin..).unwrap_or(&[]);
            let integrated = W::integrate(seen, half_time_s, order, two_float);
            integrated.map(|(body, series)| take(&body, &series, None)).is_some()
        }
    }
}

/// As [`Known`] does.
fn whole<R: Real, W: Window>(
    seen: &[Increment<R>],
    begin: usize,
    how: &Integration<R>,
    take: &mut Take<'_, R>,
) -> bool {
    Known(W::default()).integrate(seen, begin, how, take)
}
