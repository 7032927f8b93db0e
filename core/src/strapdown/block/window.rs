//! The named windows: which samples a block is integrated from.
//!
//! A window is H samples of history, the block of B samples that is integrated, and A samples of
//! look-ahead, which delay the output. Wider windows resolve faster motion; a straight line or a
//! parabola over a long block is the cheapest for slow motion.
//!
//! ```
//! use schuler::strapdown::block::shape::WindowShape;
//! use schuler::strapdown::block::window::{H2B4A2, NAMED, Window};
//!
//! assert_eq!(H2B4A2::SHAPE, WindowShape::new(2, 4, 2));
//! assert_eq!(H2B4A2::SAMPLES, 8);
//! assert!(NAMED.contains(&WindowShape::new(0, 4, 0)));
//! ```
#![doc = include_str!("WINDOWS.md")]

use super::body::{BodyMotion, Sum, integrate};
use super::fit::{Fit, LINE_LAST_SAMPLES, MOST_SAMPLES, table_f32, table_f64};
use super::inside::BlockSeries;
use super::least_squares::least_squares;
use super::newton::Used;
use super::series::Series;
use super::shape::WindowShape;
use super::{alike, behind};
use crate::math::real::Real;
use crate::sample::Increment;
use crate::strapdown::block::intervals::{Intervals, Kept, Nominal};

/// The least number of samples in the window of the first block, if the window has history.
const FIRST_SAMPLES: usize = 14;

/// A block's motion, its series, and the number of samples that it was fitted to.
pub type Behind<R, S> = (BodyMotion<R>, S, Used<R>);

/// A shape of window with its fit, its series and its storage.
pub trait Window: Copy + Default + Send + 'static {
    /// Samples before the block.
    const HISTORY: usize;
    /// Samples integrated at once.
    const BLOCK: usize;
    /// Samples after the block.
    const LOOKAHEAD: usize;
    /// All three.
    const SHAPE: WindowShape = WindowShape::new(Self::HISTORY, Self::BLOCK, Self::LOOKAHEAD);
    /// Samples of all three.
    const SAMPLES: usize = Self::HISTORY + Self::BLOCK + Self::LOOKAHEAD;
    /// Samples before the window that are used if they are there.
    const BESIDE: usize;
    /// Samples in the window of the first block.
    const FIRST: usize = if Self::SAMPLES < FIRST_SAMPLES { FIRST_SAMPLES } else { Self::SAMPLES };
    /// Coefficients of the fit: as many as samples, or 2 for a line and 3 for a parabola.
    const COEFFICIENTS: usize;
    /// Order of the series at most: for the fastest motion.
    const TERMS: usize;
    /// Samples that there is room for.
    const STORED: usize;

    /// Room for the samples that a block, or the end of a stream, can need.
    type Samples<T: Copy + Send>: Copy + Send + AsRef<[T]> + AsMut<[T]>;
    /// The series of a block.
    type Series<R: Real>: BlockSeries<R>;
    /// Whether samples may differ in length.
    const UNEQUAL: bool = false;
    /// How the samples' intervals are kept.
    type Intervals<R: Real>: Intervals<R>;
    /// The same with room for samples of any length.
    type KeptIntervals<R: Real>: Intervals<R>;

    /// The room, filled.
    fn samples<T: Copy + Send>(fill: T) -> Self::Samples<T>;

    /// Integrates the block of the window at the end of the samples, by a series up to σ^`order`; `None` if
    /// there are too few samples. With `two_float` the motion includes the parts that rounding drops.
    fn integrate<R: Real>(
        samples: &[Increment<R>],
        half_time_s: R,
        order: usize,
        two_float: bool,
    ) -> Option<(BodyMotion<R>, Self::Series<R>)>;

    /// The same for a window without look-ahead, through as many samples as the motion supports; `None` if
    /// there are too few samples to decide.
    fn integrate_behind<R: Real>(
        seen: &[Increment<R>],
        half_time_s: R,
        order: usize,
        two_float: bool,
    ) -> Option<Behind<R, Self::Series<R>>>;
}

/// The fit of a window's samples: the polynomial through all of them, or a line or parabola.
macro_rules! fit {
    (near, $k:literal, $h:literal, $b:literal, $a:literal, $samples:ident) => {
        least_squares::<R, $k>($samples)
    };
    ($through:ident, $k:literal, $h:literal, $b:literal, $a:literal, $samples:ident) => {{
        const SINGLE: &[[f32; $k]; $k] = &table_f32::<$k>($h, $b);
        const DOUBLE: &[[f64; $k]; $k] = &table_f64::<$k>($h, $b);
        Fit::from_samples($samples, $h, $b, SINGLE, DOUBLE)
    }};
}

/// The correction that makes all samples count alike, if there are enough of them.
macro_rules! lacking {
    (alike, $k:literal, $seen:ident) => {{
        const PAIRS: usize = ($k + alike::BLOCK) / 2;
        const SINGLE: &alike::Weights<f32, PAIRS> = &alike::weights_f32();
        const DOUBLE: &alike::Weights<f64, PAIRS> = &alike::weights_f64();
        let seen = $seen.last_chunk::<{ 2 * PAIRS }>();
        seen.map(|seen| alike::lacking::<R, { 2 * PAIRS }, PAIRS>(seen, SINGLE, DOUBLE))
    }};
    ($other:ident, $k:literal, $seen:ident) => {
        None::<Increment<R>>
    };
}

/// Samples before the window that are used.
macro_rules! beside {
    (alike, $b:literal) => {
        $b
    };
    ($other:ident, $b:literal) => {
        0
    };
}

/// The fit of a window without look-ahead: through as many samples as the motion supports.
macro_rules! supported {
    (behind, $k:literal, $b:literal, $seen:ident) => {{
        const SINGLE: &[[f32; $k]; $k] = &behind::table_f32::<$k>($b);
        const DOUBLE: &[[f64; $k]; $k] = &behind::table_f64::<$k>($b);
        const WEIGHTS: &[f32; $k] = &behind::weights::<$k>($b);
        let seen = $seen.last_chunk::<{ behind::SEEN }>()?;
        Some((behind::behind::<R, $k>(seen, $b, SINGLE, DOUBLE, WEIGHTS), seen.last_chunk::<$b>()?))
    }};
    ($other:ident, $k:literal, $b:literal, $seen:ident) => {{
        let _ = $seen;
        None::<((Fit<R, $k>, Used<R>), &[Increment<R>; $b])>
    }};
}

macro_rules! windows {
    ($d:tt $($(#[$doc:meta])* $name:ident = $h:literal, $b:literal, $a:literal, $fit:ident $k:literal, $m:literal, $($of:ident)*;)+) => {
        $(
            $(#[$doc])*
            #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
            #[cfg_attr(feature = "defmt", derive(defmt::Format))]
            pub struct $name;

            impl Window for $name {
                const HISTORY: usize = $h;
                const BLOCK: usize = $b;
                const LOOKAHEAD: usize = $a;
                const BESIDE: usize = beside!($fit, $b);
                const COEFFICIENTS: usize = $k;
                const TERMS: usize = $m;
                const STORED: usize = capacity($h, $b, $a, beside!($fit, $b));
                type Samples<T: Copy + Send> = [T; Self::STORED];
                type Series<R: Real> = Series<R, { $m + 1 }>;
                type Intervals<R: Real> = Nominal;
                type KeptIntervals<R: Real> = Kept<R, [R; Self::STORED]>;

                #[inline]
                fn samples<T: Copy + Send>(fill: T) -> Self::Samples<T> {
                    [fill; Self::STORED]
                }

                #[inline(always)]
                fn integrate<R: Real>(
                    seen: &[Increment<R>],
                    half_time_s: R,
                    order: usize,
                    two_float: bool,
                ) -> Option<(BodyMotion<R>, Self::Series<R>)> {
                    let samples = seen.last_chunk::<{ $h + $b + $a }>()?;
                    let block = samples.get($h..$h + $b)?;
                    let (fit, sum) = fit!($fit, $k, $h, $b, $a, samples);
                    let mut sum = if two_float { Sum::exact(block) } else { Sum::rounded(sum) };
                    if let Some(lacking) = lacking!($fit, $k, seen) {
                        sum = sum.and(&lacking);
                    }
                    Some(integrate::<R, $k, { $m + 1 }>(&fit, &sum, half_time_s, order))
                }

                #[inline(always)]
                fn integrate_behind<R: Real>(
                    seen: &[Increment<R>],
                    half_time_s: R,
                    order: usize,
                    two_float: bool,
                ) -> Option<Behind<R, Self::Series<R>>> {
                    let ((fit, used), block) = supported!($fit, $k, $b, seen)?;
                    let sum = if two_float { Sum::exact(block) } else { Sum::plain(block) };
                    let (body, series) =
                        integrate::<R, $k, { $m + 1 }>(&fit, &sum, half_time_s, order);
                    Some((body, series, used))
                }
            }
        )+

        /// The shape of every named window.
        pub const NAMED: &[WindowShape] = &[$($name::SHAPE),+];

        #[doc(hidden)]
        #[macro_export]
        macro_rules! every_window {
            ($d each:ident! $d($d first:tt)*) => { $d each! { $d($d first)* $($name),+ } };
        }

        /// Calls a macro with the names of all windows, after the tokens given here:
        /// `every_window!(list! [frame])` is `list!([frame] H0B2A0, H0B3A0, …)`.
        #[doc(inline)]
        pub use every_window;

        /// The same for the windows of a use, as the table below has it:
        /// `windows_of!(lanes list! [frame])` is `list!([frame] H0B4A0, H2B4A2, …)`.
        #[doc(hidden)]
        #[macro_export]
        macro_rules! windows_of {
            ($d of:ident $d each:ident! $d($d first:tt)*) => {
                $crate::pick_windows! { $d of $d each! [$d($d first)*] [] $($name [$($of)*])+ }
            };
        }
    };
}

/// Gathers the windows whose list of uses has one: a list is searched from its front.
#[doc(hidden)]
#[macro_export]
macro_rules! pick_windows {
    ($of:ident $each:ident! [$($first:tt)*] [$($taken:ident)*]) => {
        $each! { $($first)* $($taken),* }
    };
    (two_float $each:ident! $first:tt [$($taken:ident)*] $name:ident [two_float $($other:ident)*] $($rest:tt)*) => {
        $crate::pick_windows! { two_float $each! $first [$($taken)* $name] $($rest)* }
    };
    (target $each:ident! $first:tt [$($taken:ident)*] $name:ident [target $($other:ident)*] $($rest:tt)*) => {
        $crate::pick_windows! { target $each! $first [$($taken)* $name] $($rest)* }
    };
    (audited $each:ident! $first:tt [$($taken:ident)*] $name:ident [audited $($other:ident)*] $($rest:tt)*) => {
        $crate::pick_windows! { audited $each! $first [$($taken)* $name] $($rest)* }
    };
    (audited_level $each:ident! $first:tt [$($taken:ident)*] $name:ident [audited_level $($other:ident)*] $($rest:tt)*) => {
        $crate::pick_windows! { audited_level $each! $first [$($taken)* $name] $($rest)* }
    };
    (lanes $each:ident! $first:tt [$($taken:ident)*] $name:ident [lanes $($other:ident)*] $($rest:tt)*) => {
        $crate::pick_windows! { lanes $each! $first [$($taken)* $name] $($rest)* }
    };
    (compared $each:ident! $first:tt [$($taken:ident)*] $name:ident [compared $($other:ident)*] $($rest:tt)*) => {
        $crate::pick_windows! { compared $each! $first [$($taken)* $name] $($rest)* }
    };
    ($of:ident $each:ident! $first:tt $taken:tt $name:ident [$other:ident $($others:ident)*] $($rest:tt)*) => {
        $crate::pick_windows! { $of $each! $first $taken $name [$($others)*] $($rest)* }
    };
    ($of:ident $each:ident! $first:tt $taken:tt $name:ident [] $($rest:tt)*) => {
        $crate::pick_windows! { $of $each! $first $taken $($rest)* }
    };
}

/// Samples to keep: the newest block, and those before it that the next window, or a stream's last blocks, use.
const fn capacity(h: usize, b: usize, a: usize, beside: usize) -> usize {
    let window = h + b + a;
    let sliding = b + if window > MOST_SAMPLES { LINE_LAST_SAMPLES } else { beside + window } - 1;
    if h > 0 && sliding < FIRST_SAMPLES { FIRST_SAMPLES } else { sliding }
}

windows! { $
    // Who has a window beside the host's navigators in f32 and f64, which have all: those in two-float products,
    // targets over the link, audits (in local-level axes alone), runs abreast in lanes, comparisons of
    // arithmetics.
    // name       H  B  A  fit and its coefficients, terms, who has it
    /// Two samples, no delay beyond the block.
    H0B2A0 = 0, 2, 0, through 2, 6,;
    /// Three samples.
    H0B3A0 = 0, 3, 0, through 3, 8,;
    /// Four samples: cheap, for motion that is slow against the sampling; the microcontroller's.
    H0B4A0 = 0, 4, 0, through 4, 10, two_float target audited lanes compared;
    /// Six samples.
    H0B6A0 = 0, 6, 0, through 6, 14,;
    /// Two of history: output every two samples without look-ahead.
    H2B2A0 = 2, 2, 0, behind 4, 10,;
    /// Six samples about a block of two.
    H2B2A2 = 2, 2, 2, through 6, 14,;
    /// Six samples without look-ahead.
    H2B4A0 = 2, 4, 0, behind 6, 14,;
    /// Eight samples without look-ahead: the most accurate that does not delay.
    H4B4A0 = 4, 4, 0, behind 8, 18, two_float;
    /// Eight samples about the block, two of delay: for hard motion.
    H2B4A2 = 2, 4, 2, alike 8, 22, two_float target audited lanes compared;
    /// Twelve samples about the block: for vibration at a low rate.
    H4B4A4 = 4, 4, 4, alike 12, 26, two_float lanes;
    /// A straight line over eight samples: slow motion at a fraction of the cost.
    Line8 = 0, 8, 0, near 2, 4, lanes compared;
    /// A parabola over twelve samples.
    Parabola12 = 0, 12, 0, near 3, 6,;
    /// A parabola over twenty samples.
    Parabola20 = 0, 20, 0, near 3, 6, audited_level lanes;
    /// A parabola over forty samples: the cheapest.
    Parabola40 = 0, 40, 0, near 3, 6,;
}
