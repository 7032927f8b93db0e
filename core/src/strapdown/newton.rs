//! Fit of a window at an edge: as many samples on its longer side as the samples themselves support.
//!
//! A window is the block, `near` samples on the one side, which are all taken, and up to `far` on the
//! other. With t in samples, 0 at the outer edge of the near side, B/2·σ − near − B/2 in the block, the
//! polynomial through the P samples next to it is w(σ) = Σ_m ∇ᵐx₀ d/dσ [t(t + 1)…(t + m)/(m + 1)!], m < P,
//! the differences taken at the sample that t = 0 ends: a longer window only adds terms. Which P errs
//! least is estimated as in `support`, for gyros and accelerometers each.

use super::fit::{Fit, MOST_SAMPLES};
use super::gain::by_history;
use super::support::Differences;
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::sample::Increment;

/// A block in a window, whose near side stands at the end of the samples.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Edge {
    /// Samples between the block and the end.
    pub near: usize,
    /// Samples of the block.
    pub block: usize,
    /// Samples beyond the block at most.
    pub far: usize,
}

/// Samples that a block was fitted through.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Used<R> {
    /// Of the gyros.
    pub gyro: R,
    /// Of the accelerometers.
    pub accelerometer: R,
}

impl<R: Real> Used<R> {
    /// The same number of both.
    #[inline(always)]
    pub fn both(samples: usize) -> Self {
        let samples = R::count(samples as u32);
        Self { gyro: samples, accelerometer: samples }
    }
}

/// gain² at [block − 1][near][far]: a weight, for which single precision is enough.
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
    let Edge { near, block, far } = edge;
    let gains = block.checked_sub(1).and_then(|b| GAINS.get(b)?.get(near)).into_iter().flatten();
    let least = near + block;
    let infinite = R::ONE / R::ZERO;
    let (mut used, mut best) = ([R::count(least as u32); 2], [infinite; 2]);
    for (samples, &gain) in (least..=least + far).zip(gains) {
        let Some(powers) = power(differences, samples) else { break };
        let gain = R::entry(gain, f64::from(gain));
        for ((used, best), power) in used.iter_mut().zip(&mut best).zip(powers) {
            let error = gain * power;
            let better = error.less(*best);
            *used = R::select(better, R::count(samples as u32), *used);
            *best = R::select(better, error, *best);
        }
    }
    let [gyro, accelerometer] = used;
    Used { gyro, accelerometer }
}

/// Mean of |∇ᵏx|² over C(2k, k), where there are only k samples by how it falls from the orders before.
fn power<R: Real>(differences: &Differences<R>, k: usize) -> Option<[R; 2]> {
    if differences.count() as usize > k {
        return differences.power(k);
    }
    let last = differences.power(k.checked_sub(1)?)?;
    let Some([a, b]) = k.checked_sub(2).and_then(|k| differences.power(k)) else {
        return Some(last);
    };
    let [c, d] = last;
    Some([c * (c / a), d * (d / b)])
}

/// The fit through the samples used. Towards the far side σ falls; `reversed` turns it round.
pub fn fit<R: Real>(
    differences: &Differences<R>,
    edge: Edge,
    used: &Used<R>,
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
        let kept = |x: Vector<R>, used: R| x.map(|c| R::select(order.less(used), c, R::ZERO));
        let angle = kept(difference.angle_b, used.gyro);
        let velocity = kept(difference.velocity_b, used.accelerometer);
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

/// The fit of a block after `history` samples within a window, with the samples used. `after` samples
/// that follow the window, and `before` that precede it, help to judge it.
pub fn at_edge<R: Real>(
    samples: &[Increment<R>],
    (history, block, lookahead): super::window::Shape,
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
    (fit(&differences, edge, &used, reversed), used)
}
