//! Ready-made navigators: the combinations of frame, arithmetic and window that most programs want.
//!
//! Each alias is generic over the scalar, `f32` or `f64`. The number in a name is the number of samples that a
//! block is fitted to.
//!
//! | alias | frame | window | delay behind the newest sample | cost per sample |
//! |---|---|---|---|---|
//! | [`Navigator4`] | local-level | 4 samples | up to 3 samples | 0.88 |
//! | [`Navigator8`] | local-level | 2 before, 4, 2 after | 2 to 5 samples | 1.35 |
//! | [`PromptNavigator8`] | local-level | 4 before, 4 | up to 3 samples | as `Navigator8` |
//! | [`PreciseNavigator4`] | local-level, two-float products | 4 samples | up to 3 samples | 1.55 |
//! | [`EarthFixedNavigator4`] | Earth-fixed | 4 samples | up to 3 samples | 0.69 |
//! | [`EarthFixedNavigator8`] | Earth-fixed | 2 before, 4, 2 after | 2 to 5 samples | 1.15 |
//! | [`EarthFixedNavigator40`] | Earth-fixed | a parabola over 40 samples | up to 39 samples | 0.12 |
//! | [`TextbookNavigator`] | local-level | sample by sample | none | 1 |
//! | [`EarthFixedTextbookNavigator`] | Earth-fixed | sample by sample | none | about 1 |
//!
//! The cost is in units of the crate's own textbook step, with a series of the order that the motion needs. The
//! README has the accuracy of each. [`Strapdown::predict`] gives the navigation at the newest
//! sample, without the delay.
//!
//! Local-level axes end 640 m from a pole. Earth-fixed axes work everywhere. In single precision the local-level
//! frame is more accurate, because none of its numbers is as large as the Earth.
//!
//! ```
//! use schuler::prelude::*;
//!
//! let navigator = Navigator4::<f32>::from_rate_hz(100.0)?;
//! let level = Euler { roll: 0.0, pitch: 0.0, yaw: 0.0 };
//! let start = Solution::new(Geodetic::default(), Vector::ZERO, level);
//! let mut state: StateOf<Navigator4<f32>> = navigator.start(&start)?;
//! navigator.push(&mut state, Increment::ZERO)?;
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```

use crate::math::compensated::{Pair, TwoFloat};
use crate::strapdown::block::window::{H0B4A0, H2B4A2, H4B4A0, Parabola40};
use crate::strapdown::frame::earth_fixed::EarthFixed;
use crate::strapdown::frame::local_level::LocalLevel;
use crate::strapdown::mechanization::Mechanization;
use crate::strapdown::navigator::Strapdown;
use crate::strapdown::reference::textbook::{EarthFixedTextbook, LocalLevelTextbook, Textbook};

/// Local-level, blocks of four samples, no look-ahead. It is cheap, suits motion that is slow compared with the
/// sampling, and is the usual choice for a microcontroller.
pub type Navigator4<R> = Strapdown<LocalLevel<Pair<R>>, H0B4A0>;

/// Local-level, eight samples about a block of four, two of them look-ahead: for fast motion.
pub type Navigator8<R> = Strapdown<LocalLevel<Pair<R>>, H2B4A2>;

/// Local-level, eight samples up to the end of a block of four: the most accurate one without look-ahead.
pub type PromptNavigator8<R> = Strapdown<LocalLevel<Pair<R>>, H4B4A0>;

/// Local-level with two-float products: accurate to about a millimetre in half an hour in single precision, at
/// twice the cost of [`Navigator4`]. In `f64` it adds little.
pub type PreciseNavigator4<R> = Strapdown<LocalLevel<TwoFloat<R>>, H0B4A0>;

/// Earth-fixed, blocks of four samples, no look-ahead: cheap, and valid at the poles too.
pub type EarthFixedNavigator4<R> = Strapdown<EarthFixed<Pair<R>>, H0B4A0>;

/// Earth-fixed, eight samples about a block of four, two of them look-ahead: for fast motion.
pub type EarthFixedNavigator8<R> = Strapdown<EarthFixed<Pair<R>>, H2B4A2>;

/// Earth-fixed, a parabola over forty samples: the cheapest, only for slow and smooth motion.
pub type EarthFixedNavigator40<R> = Strapdown<EarthFixed<Pair<R>>, Parabola40>;

/// The textbook's algorithm in local-level axes, for comparison: one step per sample, no delay.
pub type TextbookNavigator<R> = Textbook<LocalLevelTextbook<R>>;

/// The textbook's algorithm in Earth-fixed axes.
pub type EarthFixedTextbookNavigator<R> = Textbook<EarthFixedTextbook<R>>;

/// The state type of a navigator, for use in a struct: `StateOf<Navigator4<f32>>`.
pub type StateOf<M> = <M as Mechanization>::State;
