//! Fit of a window at an edge of the stream, with as many samples on its longer side as the motion supports.
//!
//! A window is the block, `near` samples on one side, which are all used, and up to `far` on the
//! other. With t in samples, 0 at the outer edge of the near side, B/2·σ − near − B/2 in the block, the
//! polynomial through the P samples next to it is w(σ) = Σ_m ∇ᵐx₀ d/dσ [t(t + 1)…(t + m)/(m + 1)!], m < P,
//! the differences taken at the sample that t = 0 ends: a longer window only adds terms. The P with
//! the least error is estimated as in [`support`](super::support), for gyros and accelerometers separately. If the
//! stream is long enough, it is then estimated for each axis, up to that P: a cone has its second harmonic on its
//! third axis.
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::sample::Increment;
//! use schuler::strapdown::block::newton::{Edge, supported};
//! use schuler::strapdown::block::support::Differences;
//!
//! // A slow oscillation supports a long window, one of 2.5 samples per cycle a short one.
//! let samples = |per_cycle: f64| {
//!     let mut differences = Differences::<f64>::new();
//!     for k in 0..14 {
//!         let phase = core::f64::consts::TAU * f64::from(k) / per_cycle;
//!         let angle_b = Vector::new(phase.cos(), phase.sin(), 0.0);
//!         differences.add(&Increment { angle_b, velocity_b: Vector::ZERO });
//!     }
//!     supported(&differences, Edge { near: 0, block: 4, far: 10 }).gyro
//! };
//! assert!(samples(50.0) > samples(2.5));
//! ```

use super::fit::{Fit, MOST_SAMPLES};
use super::gain::by_history;
use super::shape::WindowShape;
use super::support::Differences;
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::sample::Increment;

/// A block in a window whose near side is at the end of the samples.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Edge {
    /// Samples between the block and the end.
    pub near: usize,
    /// Samples of the block.
    pub block: usize,
    /// Largest number of samples beyond the block.
    pub far: usize,
}

/// The largest number of samples that a block was fitted to.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Used<R> {
    /// For the gyros, from all axes together.
    pub gyro: R,
    /// For the accelerometers, likewise.
    pub accelerometer: R,
}

impl<R: Real> Used<R> {
    /// The same number for both.
    #[inline(always)]
    pub fn both(samples: usize) -> Self {
        let samples = R::count(samples as u32);
        Self { gyro: samples, accelerometer: samples }
    }
}

/// The number of samples that gyros and accelerometers were fitted to at the edges of a stream; 0 before the
/// first such block.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Edges<R> {
    /// In the first block, if its window has history.
    pub first: Used<R>,
    /// In the latest block at the end of a stream, or of a window without look-ahead.
    pub last: Used<R>,
}

impl<R: Real> Edges<R> {
    /// Before any.
    pub(crate) fn none() -> Self {
        Self { first: Used::both(0), last: Used::both(0) }
    }
}

/// gain² at [block − 1][near][far]: a weight, so single precision is enough.
#[expect(
    clippy::indexing_slicing,
    reason = "the compiler alone evaluates it, and stops at an index out of range"
)]
const GAINS: [[[f32; MOST_SAMPLES]; MOST_NEAR + 1]; MOST_BLOCK] = {
    let mut gains = [[[f32::INFINITY; MOST_SAMPLES]; MOST_NEAR + 1]; MOST_BLOCK];
    let mut block = 1;
    while block <= MOST_BLOCK {
        let mut near = 0;
        while near <= MOST_NEAR {
            let exact = by_history(block, near);
            let mut far = 0;
            while far < MOST_SAMPLES {
                gains[block - 1][near][far] = exact[far] as f32;
                far += 1;
            }
            near += 1;
        }
        block += 1;
    }
    gains
};

/// Samples of a block at an edge, and of the shorter side of its window, at most.
const MOST_BLOCK: usize = 4;
const MOST_NEAR: usize = 4;

/// The window, among those through at least the block and its near side, whose estimated error is least.
pub fn supported<R: Real>(differences: &Differences<R>, edge: Edge) -> Used<R> {
    let all = Vector::new(R::ONE, R::ONE, R::ONE);
    let any = R::count(MOST_SAMPLES as u32);
    let used = least(differences, edge, [any; 2], |power| all * (power.x + power.y + power.z));
    Used { gyro: used.angle_b.x, accelerometer: used.velocity_b.x }
}

/// The same for each axis, among the windows of no more samples than all axes together support.
fn supported_by_axis<R: Real>(
    differences: &Differences<R>,
    edge: Edge,
    most: &Used<R>,
) -> Increment<R> {
    least(differences, edge, [most.gyro, most.accelerometer], |power| power)
}

/// The number of samples, at most `most`, with the least error; `count` makes what is compared from the axes'
/// powers.
fn least<R: Real>(
    differences: &Differences<R>,
    edge: Edge,
    most: [R; 2],
    count: impl Fn(Vector<R>) -> Vector<R>,
) -> Increment<R> {
    let Edge { near, block, far } = edge;
    let gains = block.checked_sub(1).and_then(|b| GAINS.get(b)?.get(near)).into_iter().flatten();
    let least = near + block;
    let infinite = R::ONE / R::ZERO;
    let none = (R::count(least as u32), infinite);
    let mut best = [Vector::new(none, none, none); 2];
    for (samples, &gain) in (least..=least + far).zip(gains) {
        let Some(powers) = power(differences, samples, &count) else { break };
        let gain = R::entry(gain, f64::from(gain));
        let samples = R::count(samples as u32);
        for ((best, power), most) in best.iter_mut().zip(powers).zip(most) {
            *best = best.zip(power * gain, |(used, least), error| {
                let error = R::select(samples.less(most + R::HALF), error, infinite);
                let better = error.less(least);
                (R::select(better, samples, used), R::select(better, error, least))
            });
        }
    }
    let [angle_b, velocity_b] = best.map(|best| best.map(|(used, _)| used));
    Increment { angle_b, velocity_b }
}

/// Mean of (∇ᵏx)² over C(2k, k); with only k samples it is extrapolated from lower orders.
fn power<R: Real>(
    differences: &Differences<R>,
    k: usize,
    count: impl Fn(Vector<R>) -> Vector<R>,
) -> Option<[Vector<R>; 2]> {
    let power = |k: usize| {
        let Increment { angle_b, velocity_b } = differences.power_by_axis(k)?;
        Some([count(angle_b), count(velocity_b)])
    };
    if differences.count() as usize > k {
        return power(k);
    }
    let last = power(k.checked_sub(1)?)?;
    // Over two orders, because at one of them an oscillation may pass through 0; but not from order 0,
    // because the mean does not show how differences fall.
    let falling = |c: R, a: R| c * (c / a).sqrt();
    let falling_once = |c: R, a: R| c * (c / a);
    let [c, d] = last;
    if let Some([a, b]) = k.checked_sub(3).filter(|&order| order > 0).and_then(power) {
        return Some([c.zip(a, falling), d.zip(b, falling)]);
    }
    let Some([a, b]) = k.checked_sub(2).and_then(power) else { return Some(last) };
    Some([c.zip(a, falling_once), d.zip(b, falling_once)])
}

/// The fit through the samples that each axis uses. σ falls towards the far side; `reversed` changes its sign.
pub fn fit<R: Real>(
    differences: &Differences<R>,
    edge: Edge,
    used: &Increment<R>,
    reversed: bool,
) -> Fit<R, MOST_SAMPLES> {
    let Edge { near, block, far } = edge;
    let mut fit = Fit { rate: [Vector::ZERO; MOST_SAMPLES], force: [Vector::ZERO; MOST_SAMPLES] };
    let half = R::count(block as u32) * R::HALF;
    let middle = R::count(near as u32) + half;
    // t(t + 1)…(t + m)/(m + 1)!, by powers of σ
    let mut product = [R::ZERO; MOST_SAMPLES + 1];
    product[0] = R::ONE;
    let inverses = R::INVERSE.into_iter().skip(1);
    let terms = differences.newest().iter().zip(inverses).take(near + block + far);
    for (m, (difference, inverse)) in (0..).zip(terms) {
        let order = R::count(m);
        let kept = |x: R, used: R| R::select(order.less(used), x, R::ZERO);
        let angle = difference.angle_b.zip(used.angle_b, kept);
        let velocity = difference.velocity_b.zip(used.velocity_b, kept);
        let mut lower = R::ZERO;
        for c in &mut product {
            (*c, lower) = ((*c * (order - middle) + lower * half) * inverse, *c);
        }
        let rows = fit.rate.iter_mut().zip(fit.force.iter_mut()).zip(product.iter().skip(1));
        for ((k, ((rate, force), &c)), _) in (1..).zip(rows).zip(0..=m) {
            let even = k % 2 == 1;
            let slope = if even || !reversed { c * R::count(k) } else { -(c * R::count(k)) };
            *rate = *rate + angle * slope;
            *force = *force + velocity * slope;
        }
    }
    fit
}

/// The fit of a block after `history` samples within a window that begins at `begin`, with the number of samples
/// used. Samples beside the window contribute to the estimate of that number.
pub fn at_edge<R: Real>(
    samples: &[Increment<R>],
    WindowShape { history, block, lookahead }: WindowShape,
    begin: usize,
) -> (Fit<R, MOST_SAMPLES>, Used<R>) {
    let mut differences = Differences::new();
    let reversed = history < lookahead;
    let end = begin + history + block + lookahead;
    let edge = if reversed {
        let seen = samples.get(begin..).unwrap_or(&[]).iter().take(MOST_SAMPLES);
        seen.rev().for_each(|sample| differences.add(sample));
        Edge { near: history, block, far: lookahead }
    } else {
        let from = end.saturating_sub(MOST_SAMPLES);
        let seen = samples.get(from..end).unwrap_or(&[]);
        seen.iter().for_each(|sample| differences.add(sample));
        Edge { near: lookahead, block, far: history }
    };
    let used = supported(&differences, edge);
    // With fewer samples an axis alone is not reliable: a difference may pass through 0.
    let by_axis = if differences.count() as usize >= MOST_SAMPLES {
        supported_by_axis(&differences, edge, &used)
    } else {
        let alike = |used: R| Vector::new(used, used, used);
        Increment { angle_b: alike(used.gyro), velocity_b: alike(used.accelerometer) }
    };
    (fit(&differences, edge, &by_axis, reversed), used)
}
