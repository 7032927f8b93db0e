//! The cheapest window that loses nothing: from the motion's bandwidth and the sampling interval.
//!
//! A window that follows x = Λh (the bandwidth Λ, rad/s, times the interval h) too coarsely leaves a
//! residual drift; each limit below is where that falls under the rounding floor, found on the built-in
//! scenes (`paper` has x = 1.2e-4, `hard` 0.3, `coning` 0.6, `vibration` 1.4). A spin is bounded by what the
//! series leaves of it, and a local-level block by the distance that it flies. Where the truth is at hand, as
//! in a simulation, trial flights choose better.

use super::configuration::{Axes, Precision};
use crate::strapdown::block::shape::WindowShape;
use crate::strapdown::block::window::{H0B2A0, H0B4A0, H2B4A2, H4B4A4, Line8, Parabola20, Window};
use crate::strapdown::limits::MOST_TURN;

/// What a window is planned for.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Demand {
    /// The motion's bandwidth, rad/s.
    pub bandwidth: f64,
    /// What it turns by at most, rad/s.
    pub angular_rate: f64,
    /// Its speed over the Earth at most, m/s.
    pub speed: f64,
    /// Seconds between samples.
    pub interval_s: f64,
    /// How many digits the navigator has.
    pub precision: Precision,
    /// Its axes: an Earth-fixed step stays exact for longer blocks.
    pub axes: Axes,
}

/// A window with the largest x = Λh and the longest block, s, that it is planned for.
struct Candidate(WindowShape, f64, f64);

/// In double precision, the cheapest first: gravity's third difference is the last that counts in blocks
/// of up to two seconds at rest, of one second in motion.
const EARTH_FIXED: &[Candidate] = &[
    Candidate(WindowShape::new(0, 40, 0), 0.0, 2.0),
    Candidate(WindowShape::new(0, 20, 0), 1.3e-4, 1.0),
    LINE,
    FOUR,
    TWO,
];
const LOCAL_LEVEL: &[Candidate] =
    &[Candidate(WindowShape::new(0, 20, 0), 0.0, 2.0), LINE, FOUR, TWO];
/// In single precision a long block rounds more at once, always the same way where nothing changes.
const SINGLE: &[Candidate] = &[
    Candidate(WindowShape::new(0, 4, 0), 0.0, 2.0),
    Candidate(WindowShape::new(0, 12, 0), 2e-4, 1.0),
    FOUR,
];
const TWO_FLOAT: &[Candidate] = &[];
/// In any precision, where none of those suits.
const LONG: [Candidate; 2] = [
    Candidate(WindowShape::new(0, 4, 0), 0.03, f64::INFINITY),
    Candidate(UNKNOWN, 0.4, f64::INFINITY),
];

const LINE: Candidate = Candidate(WindowShape::new(0, 8, 0), 2e-4, 2.0);
const FOUR: Candidate = Candidate(WindowShape::new(0, 4, 0), 0.03, 2.0);
const TWO: Candidate = Candidate(WindowShape::new(0, 2, 0), 2e-4, f64::INFINITY);
/// Twelve samples: for the rest.
const WIDEST: WindowShape = WindowShape::new(4, 4, 4);
/// Six samples about a block of two: for spins that a block of four turns too far on.
const SHORTEST: WindowShape = WindowShape::new(2, 2, 2);

/// What the series may leave of a block's turn about its own axis: a tenth of its rounding, as the rest
/// of a steady spin adds up.
const SPIN_REST: f64 = 1e-17;

/// Whether blocks of a window turn no further than its series is made for, in so many digits.
fn turns_within(demand: &Demand, WindowShape { block, .. }: WindowShape, terms: usize) -> bool {
    // A navigator refuses more than 2 rad; order m leaves 2x^{m+1}/(m + 1)! of a spin, x the half block.
    let turn = block as f64 * demand.interval_s * demand.angular_rate;
    let x = 0.5 * turn;
    let rest = (1..=terms).fold(x, |rest, m| rest * x / (m + 1) as f64);
    let digits = if demand.precision == Precision::F64 { 1.0 } else { 1e6 };
    turn <= MOST_TURN && rest + rest <= SPIN_REST * digits * turn
}

/// The longest way of a local-level block, m. Over a way of vT its step leaves up to 4e-10 m · (vT/300 m)³ in
/// half an hour, as flown at 300 m/s in blocks of 1.6 to 8 s and at 7.2 km/s in blocks of 0.2 to 0.8 s: over
/// this way less than a rounding. What an Earth-fixed step leaves is not seen in blocks of two seconds.
const LONGEST_WAY: f64 = 500.0;

/// Whether a block of a window is short enough for its nav step; there is none of fewer than two samples.
fn steps_within(demand: &Demand, WindowShape { block, .. }: WindowShape) -> bool {
    let way = block as f64 * demand.interval_s * demand.speed;
    demand.axes == Axes::EarthFixed
        || demand.precision != Precision::F64
        || block <= 2
        || way <= LONGEST_WAY
}

/// The window for a flight: among those whose blocks a navigator takes.
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
    // On a spin that no series follows the longest serves best, and a block of two is taken longest.
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

/// The window for a motion of which nothing is known.
pub const UNKNOWN: WindowShape = WindowShape::new(2, 4, 2);

/// An order that no window's series exceeds.
pub const HIGHEST_ORDER: usize = 26;

/// The order of a block's series that reaches the rounding floor, at most: a window may have fewer terms.
pub fn order(demand: &Demand, WindowShape { history, block, lookahead }: WindowShape) -> usize {
    // Of constant force, turned by w over half the block, order 3 leaves out 2w⁴/5!. Of a force that
    // changes, the products that an order m leaves out turn by w what is no more than xᵐ/(m + 1)! of it,
    // x the phase of the fastest motion.
    let half_s = 0.5 * block as f64 * demand.interval_s;
    let w = half_s * demand.angular_rate;
    let x = w.max(half_s * demand.bandwidth);
    let rest = |order: usize| (1..=order).fold(w, |rest, m| rest * x / (m + 1) as f64);
    let digits = if demand.precision == Precision::F32 { 1e6 } else { 1.0 };
    // The products with the fit's last coefficient are the last that count, unless motion is violent.
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
