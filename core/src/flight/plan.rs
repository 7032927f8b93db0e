//! The cheapest window without loss of accuracy, from the motion's bandwidth and the sampling interval.
//!
//! Let x = Λh, the bandwidth Λ in rad/s times the interval h. A window that is too coarse for x leaves a
//! residual drift. Each limit below is the x at which this falls below the rounding floor, found on the built-in
//! scenes (`paper` has x = 1.2e-4, `hard` 0.3, `coning` 0.6, `vibration` 1.4). A spin is limited by the
//! truncation of the series, and a local-level block by the distance that it covers. If the truth is known, as
//! in a simulation, trial flights make a better choice.
//!
//! ```
//! use schuler::flight::configuration::{Axes, Precision};
//! use schuler::flight::plan::{Demand, UNKNOWN, order, window};
//! use schuler::strapdown::block::shape::WindowShape;
//!
//! let cruise = Demand {
//!     bandwidth: 0.5,
//!     angular_rate: 0.1,
//!     speed: 200.0,
//!     interval_s: 0.01,
//!     precision: Precision::F64,
//!     axes: Axes::LocalLevel,
//! };
//! let four = WindowShape::new(0, 4, 0);
//! assert_eq!(window(&cruise), four);
//! assert_eq!(order(&cruise, four), 5);
//! assert_eq!(window(&Demand { bandwidth: 10.0, ..cruise }), UNKNOWN);
//! ```

use super::configuration::{Axes, Precision};
use crate::strapdown::block::shape::WindowShape;
use crate::strapdown::block::window::{H0B2A0, H0B4A0, H2B4A2, H4B4A4, Line8, Parabola20, Window};
use crate::strapdown::limits::MOST_TURN;

/// The flight that a window is planned for.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Demand {
    /// The motion's bandwidth, rad/s.
    pub bandwidth: f64,
    /// The largest angular rate, rad/s.
    pub angular_rate: f64,
    /// The largest speed relative to the Earth, m/s.
    pub speed: f64,
    /// Seconds between samples.
    pub interval_s: f64,
    /// The precision of the navigator.
    pub precision: Precision,
    /// Its axes: an Earth-fixed step is exact for longer blocks.
    pub axes: Axes,
}

/// A window with the largest x = Λh and the longest block, s, that it is planned for.
struct Candidate(WindowShape, f64, f64);

/// In double precision, the cheapest first. Gravity's third difference is the last that matters in blocks
/// of up to two seconds at rest, or one second in motion.
const EARTH_FIXED: &[Candidate] = &[
    Candidate(WindowShape::new(0, 40, 0), 0.0, 2.0),
    Candidate(WindowShape::new(0, 20, 0), 1.3e-4, 1.0),
    LINE,
    FOUR,
    TWO,
];
const LOCAL_LEVEL: &[Candidate] =
    &[Candidate(WindowShape::new(0, 20, 0), 0.0, 2.0), LINE, FOUR, TWO];
/// In single precision a long block has larger roundings, which always have the same sign if nothing changes.
const SINGLE: &[Candidate] = &[
    Candidate(WindowShape::new(0, 4, 0), 0.0, 2.0),
    Candidate(WindowShape::new(0, 12, 0), 2e-4, 1.0),
    FOUR,
];
const TWO_FLOAT: &[Candidate] = &[];
/// In any precision, if none of those suits.
const LONG: [Candidate; 2] = [
    Candidate(WindowShape::new(0, 4, 0), 0.03, f64::INFINITY),
    Candidate(UNKNOWN, 0.4, f64::INFINITY),
];

const LINE: Candidate = Candidate(WindowShape::new(0, 8, 0), 2e-4, 2.0);
const FOUR: Candidate = Candidate(WindowShape::new(0, 4, 0), 0.03, 2.0);
const TWO: Candidate = Candidate(WindowShape::new(0, 2, 0), 2e-4, f64::INFINITY);
/// Twelve samples: for the rest.
const WIDEST: WindowShape = WindowShape::new(4, 4, 4);
/// Six samples about a block of two: for spins that are too fast for a block of four.
const SHORTEST: WindowShape = WindowShape::new(2, 2, 2);

/// The fraction of a block's rotation about its own axis that the series may leave out: a tenth of its
/// rounding, because the error of a steady spin accumulates.
const SPIN_REST: f64 = 1e-17;

/// Whether the series of a window is accurate for the rotation of its blocks, in the given precision.
fn turns_within(demand: &Demand, WindowShape { block, .. }: WindowShape, terms: usize) -> bool {
    // A navigator refuses more than 2 rad; order m leaves 2x^{m+1}/(m + 1)! of a spin, x the half block.
    let turn = block as f64 * demand.interval_s * demand.angular_rate;
    let x = 0.5 * turn;
    let rest = (1..=terms).fold(x, |rest, m| rest * x / (m + 1) as f64);
    let digits = if demand.precision == Precision::F64 { 1.0 } else { 1e6 };
    turn <= MOST_TURN && rest + rest <= SPIN_REST * digits * turn
}

/// The longest distance of a local-level block, m. For a distance vT its step leaves up to 4e-10 m · (vT/300 m)³ in
/// half an hour, measured at 300 m/s in blocks of 1.6 to 8 s and at 7.2 km/s in blocks of 0.2 to 0.8 s: up to
/// this distance less than a rounding. The error of an Earth-fixed step is not visible in blocks of two seconds.
const LONGEST_WAY: f64 = 500.0;

/// Whether a block of a window is short enough for its navigation step; no block has fewer than two samples.
fn steps_within(demand: &Demand, WindowShape { block, .. }: WindowShape) -> bool {
    let way = block as f64 * demand.interval_s * demand.speed;
    demand.axes == Axes::EarthFixed
        || demand.precision != Precision::F64
        || block <= 2
        || way <= LONGEST_WAY
}

/// The window for a flight, among those whose blocks a navigator accepts.
pub fn window(demand: &Demand) -> WindowShape {
    let candidates: &[Candidate] = match (demand.precision, demand.axes) {
        (Precision::F64, Axes::EarthFixed) => EARTH_FIXED,
        (Precision::F64, Axes::LocalLevel) => LOCAL_LEVEL,
        (Precision::F32, _) => SINGLE,
        (Precision::F32x2, _) => TWO_FLOAT,
    };
    let x = demand.bandwidth * demand.interval_s;
    let suits = |&&Candidate(shape, most, longest_s): &&Candidate| {
        x <= most
            && shape.block as f64 * demand.interval_s <= longest_s
            && turns_within(demand, shape, terms(shape))
    };
    // For a spin that is too fast for any series the longest is best, and a block of two is accepted up to the
    // highest rate.
    let fastest = || {
        let [wide, narrow] = [WIDEST, SHORTEST];
        let turn = wide.block as f64 * demand.interval_s * demand.angular_rate;
        if turn <= MOST_TURN || demand.precision == Precision::F32x2 { wide } else { narrow }
    };
    let stepped = candidates.iter().filter(|&&Candidate(shape, ..)| steps_within(demand, shape));
    stepped.chain(&LONG).find(suits).map_or_else(fastest, |&Candidate(shape, ..)| shape)
}

/// The order of a planned window's series at most.
fn terms(WindowShape { history, block, lookahead }: WindowShape) -> usize {
    match (history + lookahead, block) {
        (0, 2) => H0B2A0::TERMS,
        (0, 4) => H0B4A0::TERMS,
        (0, 8) => Line8::TERMS,
        (0, _) => Parabola20::TERMS,
        (8, _) => H4B4A4::TERMS,
        (_, _) => H2B4A2::TERMS,
    }
}

/// The window for an unknown motion.
pub const UNKNOWN: WindowShape = WindowShape::new(2, 4, 2);

/// An order that no window's series exceeds.
pub const HIGHEST_ORDER: usize = 26;

/// The order of a block's series that reaches the rounding floor, at most: a window may have fewer terms.
pub fn order(demand: &Demand, WindowShape { history, block, lookahead }: WindowShape) -> usize {
    // For a constant force that turns by w over half the block, order 3 leaves out 2w⁴/5!. For a force that
    // changes, an order m leaves out at most w·xᵐ/(m + 1)! of it, x the phase of the fastest motion over
    // half the block.
    let half_s = 0.5 * block as f64 * demand.interval_s;
    let w = half_s * demand.angular_rate;
    let x = w.max(half_s * demand.bandwidth);
    let rest = |order: usize| (1..=order).fold(w, |rest, m| rest * x / (m + 1) as f64);
    let digits = if demand.precision == Precision::F32 { 1e6 } else { 1.0 };
    // The products with the fit's last coefficient are the last that matter, unless motion is violent.
    let whole =
        if history == 0 && block >= LINE.0.block { 4 } else { history + block + lookahead + 1 };
    if w * w * w * w / 60.0 <= 3e-16 * digits && rest(3) <= 3e-14 * digits {
        3
    } else if rest(whole) <= 1e-10 {
        whole
    } else {
        HIGHEST_ORDER
    }
}
