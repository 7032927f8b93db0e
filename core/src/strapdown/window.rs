//! The named windows: which samples a block is integrated from.
//!
//! A window is H samples of history, the block of B samples that is integrated, and A samples of
//! look-ahead, which delay the output. Wider windows follow faster motion; a straight line over a
//! long block is the cheapest for slow motion.

use super::body::{BodyMotion, Series, Sum, integrate};
use super::fit::{Fit, MOST_SAMPLES, table_f32, table_f64};
use crate::math::real::Real;
use crate::sample::Increment;

/// Samples at least in the window of the first block, where history is wanted and there is none.
const FIRST_SAMPLES: usize = 10;

/// Samples in the windows of the last blocks of a stream that straight lines were fitted to.
pub const LINE_LAST_SAMPLES: usize = 8;

/// A shape of window with its fit, its series and its storage.
pub trait Window: Copy + Default + 'static {
    /// Samples before the block.
    const HISTORY: usize;
    /// Samples integrated at once.
    const BLOCK: usize;
    /// Samples after the block.
    const LOOKAHEAD: usize;
    /// All of them.
    const SAMPLES: usize = Self::HISTORY + Self::BLOCK + Self::LOOKAHEAD;
    /// Samples in the window of the first block.
    const FIRST: usize = if Self::SAMPLES < FIRST_SAMPLES { FIRST_SAMPLES } else { Self::SAMPLES };
    /// Coefficients of the fit: as many as samples, or 2 for a straight line.
    const COEFFICIENTS: usize;
    /// Order of the series at most: for the fastest motion.
    const TERMS: usize;

    /// Room for the samples that a block, or the end of a stream, can need.
    type Samples<T: Copy + Default>: Copy + Default + AsRef<[T]> + AsMut<[T]>;
    /// The series of a block.
    type Series<R: Real>: BlockSeries<R>;

    /// Integrates the block within the window's samples by a series up to σ^`order`; `None` if the
    /// samples are too few. With `two_float` the motion comes with what rounding drops from it.
    fn integrate<R: Real>(
        samples: &[Increment<R>],
        half_time_s: R,
        order: usize,
        two_float: bool,
    ) -> Option<(BodyMotion<R>, Self::Series<R>)>;
}

/// A series that can be evaluated inside its block.
pub trait BlockSeries<R: Real>: Copy {
    /// The motion from the block's start to σ in (−1, 1).
    fn until(&self, sigma: R, half_time_s: R) -> BodyMotion<R>;
}

impl<R: Real, const N: usize> BlockSeries<R> for Series<R, N> {
    #[inline]
    fn until(&self, sigma: R, half_time_s: R) -> BodyMotion<R> {
        Series::until(self, sigma, half_time_s)
    }
}

macro_rules! windows {
    ($($(#[$doc:meta])* $name:ident = $h:literal, $b:literal, $a:literal, $k:literal, $m:literal;)+) => {
        $(
            $(#[$doc])*
            #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
            #[cfg_attr(feature = "defmt", derive(defmt::Format))]
            pub struct $name;

            impl Window for $name {
                const HISTORY: usize = $h;
                const BLOCK: usize = $b;
                const LOOKAHEAD: usize = $a;
                const COEFFICIENTS: usize = $k;
                const TERMS: usize = $m;
                type Samples<T: Copy + Default> = [T; capacity($h, $b, $a)];
                type Series<R: Real> = Series<R, { $m + 1 }>;

                #[inline(always)]
                fn integrate<R: Real>(
                    samples: &[Increment<R>],
                    half_time_s: R,
                    order: usize,
                    two_float: bool,
                ) -> Option<(BodyMotion<R>, Self::Series<R>)> {
                    const P: usize = $h + $b + $a;
                    const SINGLE: &[[f32; P]; $k] = &table_f32::<P, $k>($h, $b);
                    const DOUBLE: &[[f64; P]; $k] = &table_f64::<P, $k>($h, $b);
                    let samples = samples.first_chunk::<P>()?;
                    let fit = Fit::of(samples, SINGLE, DOUBLE);
                    let block = samples.get($h..$h + $b)?;
                    let sum = Sum::of(block, two_float);
                    Some(integrate::<R, $k, { $m + 1 }>(&fit, &sum, half_time_s, order))
                }
            }
        )+

        /// Every named window as (history, block, look-ahead).
        pub const NAMED: &[(usize, usize, usize)] = &[$(($h, $b, $a)),+];
    };
}

/// Samples to keep: the newest block, and before it what a stream's last windows look back on.
const fn capacity(h: usize, b: usize, a: usize) -> usize {
    let window = h + b + a;
    let sliding = b + if window > MOST_SAMPLES { LINE_LAST_SAMPLES } else { window } - 1;
    if h > 0 && sliding < FIRST_SAMPLES { FIRST_SAMPLES } else { sliding }
}

windows! {
    // name       H  B  A  coefficients, terms
    /// Two samples, no delay beyond the block.
    H0B2A0 = 0, 2, 0, 2, 6;
    /// Three samples.
    H0B3A0 = 0, 3, 0, 3, 7;
    /// Four samples: cheap, for motion that is slow against the sampling; the microcontroller's.
    H0B4A0 = 0, 4, 0, 4, 8;
    /// Six samples.
    H0B6A0 = 0, 6, 0, 6, 9;
    /// Two of history: output every two samples without look-ahead.
    H2B2A0 = 2, 2, 0, 4, 7;
    /// Six samples about a block of two.
    H2B2A2 = 2, 2, 2, 6, 8;
    /// Six samples without look-ahead.
    H2B4A0 = 2, 4, 0, 6, 9;
    /// Eight samples without look-ahead: the most accurate that does not delay.
    H4B4A0 = 4, 4, 0, 8, 10;
    /// Eight samples about the block, two of delay: for hard motion.
    H2B4A2 = 2, 4, 2, 8, 10;
    /// Twelve samples about the block: for vibration at a low rate.
    H4B4A4 = 4, 4, 4, 12, 14;
    /// A straight line over eight samples: slow motion at a fraction of the cost.
    Line8 = 0, 8, 0, 2, 3;
    /// A straight line over twenty samples.
    Line20 = 0, 20, 0, 2, 3;
}
