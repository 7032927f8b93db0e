//! Constants of a block's duration, computed once per configuration.
//!
//! ```
//! use schuler::math::compensated::Pair;
//! use schuler::strapdown::frame::block_time::BlockTime;
//!
//! let block = BlockTime::new(Pair::<f64>::of(0.01), 4);
//! assert_eq!((block.time.hi, block.half), (0.04, 0.02));
//! ```

use crate::earth::{EQUATORIAL_GRAVITY, ROTATION_RATE};
use crate::math::compensated::Pair;
use crate::math::real::Real;

/// A block's duration T and constants that follow from it.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BlockTime<R> {
    /// T, s.
    pub time: Pair<R>,
    /// T/2, s.
    pub half: R,
    /// T², s².
    pub square: R,
    /// γ_e T, m/s.
    pub gravity: Pair<R>,
    /// γ_e T²/2, m.
    pub half_gravity_square: Pair<R>,
    /// ω_ie T, rad.
    pub turn: Pair<R>,
    /// sin ω_ie T.
    pub turn_sine: R,
    /// cos ω_ie T − 1.
    pub turn_cosine_less_one: R,
    /// sin ½ω_ie T.
    pub half_turn_sine: R,
    /// cos ½ω_ie T − 1.
    pub half_turn_cosine_less_one: R,
}

impl<R: Real> BlockTime<R> {
    /// Of a number of samples at an interval in seconds.
    pub fn new(interval_s: Pair<R>, samples: usize) -> Self {
        Self::lasting(interval_s * Pair::new(R::count(samples as u32)))
    }

    /// Of a duration in seconds.
    pub fn lasting(time: Pair<R>) -> Self {
        let gravity = Pair::of(EQUATORIAL_GRAVITY) * time;
        let turn = Pair::of(ROTATION_RATE) * time;
        let (turn_sine, turn_cosine_less_one) = small_turn(turn.hi);
        let (half_turn_sine, half_turn_cosine_less_one) = small_turn(turn.hi * R::HALF);
        Self {
            time,
            half: time.hi * R::HALF,
            square: time.hi * time.hi,
            gravity,
            half_gravity_square: gravity * time * Pair::new(R::HALF),
            turn,
            turn_sine,
            turn_cosine_less_one,
            half_turn_sine,
            half_turn_cosine_less_one,
        }
    }
}

/// sin x and cos x − 1 of an angle below 0.01 rad.
#[inline(always)]
pub(crate) fn small_turn<R: Real>(x: R) -> (R, R) {
    // sin x = x − x³/6 + x⁵/120,  cos x − 1 = −x²/2 + x⁴/24 − x⁶/720
    let x2 = x * x;
    let sine = x - x * x2 * (R::of(1.0 / 6.0) - x2 * R::of(1.0 / 120.0));
    let cosine = -(x2 * (R::HALF - x2 * (R::of(1.0 / 24.0) - x2 * R::of(1.0 / 720.0))));
    (sine, cosine)
}
