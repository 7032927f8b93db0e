//! The cheapest window that loses nothing: from the motion's bandwidth and the sampling interval.
//!
//! A window that follows x = Λh (the bandwidth Λ, rad/s, times the interval h) too coarsely leaves a
//! residual drift; each limit below is where that falls under the rounding floor of double precision,
//! found on the built-in scenes (`paper` has x = 1.2e-4, `hard` 0.3, `coning` 0.6, `vibration` 1.4).

/// A window's shape: history, block, look-ahead.
pub type Shape = (usize, usize, usize);

/// A straight line over twenty samples, where nothing changes.
const STILL: Shape = (0, 20, 0);
/// A straight line over eight: x at most.
const SLOW: (f64, Shape) = (2e-4, (0, 8, 0));
/// Four samples: x at most.
const GENTLE: (f64, Shape) = (0.03, (0, 4, 0));
/// Eight samples about the block: x at most.
const LIVELY: (f64, Shape) = (0.4, (2, 4, 2));
/// Twelve samples, the widest.
const VIOLENT: Shape = (4, 4, 4);

/// The window for a motion of this bandwidth, rad/s, sampled at this interval, s.
///
/// In single precision no straight line is planned: over its longer block more is rounded at once.
pub fn window(bandwidth: f64, interval_s: f64, single_precision: bool) -> Shape {
    let x = bandwidth * interval_s;
    if x == 0.0 && !single_precision {
        STILL
    } else if x <= SLOW.0 && !single_precision {
        SLOW.1
    } else if x <= GENTLE.0 {
        GENTLE.1
    } else if x <= LIVELY.0 {
        LIVELY.1
    } else {
        VIOLENT
    }
}

/// The window for a motion of which nothing is known.
pub const UNKNOWN: Shape = LIVELY.1;

/// An order that no window's series exceeds.
pub const HIGHEST_ORDER: usize = 20;

/// The order at which the series of a block of a duration in seconds reaches the rounding floor, for a
/// motion that turns by at most this rate, rad/s.
pub fn order(angular_rate: f64, block_s: f64) -> usize {
    // The rest is about wᵐ/m!, w the largest rotation over half the block.
    let w = 0.5 * angular_rate * block_s;
    let mut rest = 1.0;
    let mut order = 0;
    while rest > 1e-16 && order < HIGHEST_ORDER {
        order += 1;
        rest *= w / order as f64;
    }
    order
}
