//! The noise gain of a window: from white noise in the samples to the fitted rate.
//!
//! With t in samples, 0 at the window's newest edge, the polynomial through P increments x₀ (the newest),
//! x₁, x₂ … is Newton's, w(t) = Σ_m ∇ᵐx₀ N_m(t), N_m = d/dt [t(t + 1)…(t + m)/(m + 1)!], m < P.
//! As ∇ᵐx₀ = Σⱼ (−1)ʲ C(m, j) xⱼ, sample j weighs r_j(t) = Σ_m (−1)ʲ C(m, j) N_m(t), and the gain is
//! gain² = (1/B) ∫ Σⱼ r_j² dt over the block. The gain is 1 for a single sample, 1.1 for a window with as much
//! history as look-ahead, and 3 to 72 for a block at the end of a long window.

use super::fit::MOST_SAMPLES;
use super::shape::WindowShape;

/// gain² of the window that interpolates `shape`'s samples; infinite if they are more than
/// [`MOST_SAMPLES`], or if there is no block.
///
/// ```
/// # use schuler::strapdown::block::{gain::gain_squared, shape::WindowShape};
/// let gain = |history, block, lookahead| {
///     f64::sqrt(gain_squared(WindowShape::new(history, block, lookahead)))
/// };
/// assert!((gain(0, 1, 0) - 1.0).abs() < 1e-12);
/// assert!((gain(2, 4, 2) - 1.14).abs() < 0.01);
/// assert!((gain(0, 4, 10) - 72.0).abs() < 1.0);
/// ```
#[expect(
    clippy::indexing_slicing,
    reason = "the compiler alone evaluates it, and stops at an index out of range"
)]
pub const fn gain_squared(WindowShape { history, block, lookahead }: WindowShape) -> f64 {
    if block == 0 || history + block + lookahead > MOST_SAMPLES {
        return f64::INFINITY;
    }
    by_history(block, lookahead)[history]
}

/// gain² of the windows with a block and a look-ahead, at the index of their history; infinite beyond
/// [`MOST_SAMPLES`].
#[expect(
    clippy::indexing_slicing,
    reason = "the compiler alone evaluates it, and stops at an index out of range"
)]
pub(crate) const fn by_history(block: usize, lookahead: usize) -> [f64; MOST_SAMPLES] {
    // Gauss and Legendre's five points on every sample.
    const PLACES: [f64; 5] =
        [0.046910077030668, 0.2307653449471585, 0.5, 0.7692346550528415, 0.953089922969332];
    const WEIGHTS: [f64; 5] = [
        0.11846344252809454,
        0.23931433524968324,
        0.28444444444444444,
        0.23931433524968324,
        0.11846344252809454,
    ];
    let first = block + lookahead;
    let mut gains = [f64::INFINITY; MOST_SAMPLES];
    let mut history = 0;
    while first + history <= MOST_SAMPLES {
        gains[history] = 0.0;
        history += 1;
    }
    let mut sample = lookahead;
    while sample < first {
        let mut point = 0;
        while point < PLACES.len() {
            let squares = weights_squared(-(sample as f64) - PLACES[point]);
            let mut samples = first;
            while samples <= MOST_SAMPLES {
                gains[samples - first] += WEIGHTS[point] / block as f64 * squares[samples - 1];
                samples += 1;
            }
            point += 1;
        }
        sample += 1;
    }
    gains
}

/// Σⱼ r_j(t)² of the polynomial through the newest P samples, at index P − 1.
#[expect(
    clippy::indexing_slicing,
    reason = "the compiler alone evaluates it, and stops at an index out of range"
)]
const fn weights_squared(t: f64) -> [f64; MOST_SAMPLES] {
    let mut squares = [0.0; MOST_SAMPLES];
    let (mut weights, mut binomials) = ([0.0; MOST_SAMPLES], [0.0; MOST_SAMPLES]);
    binomials[0] = 1.0;
    // t(t + 1)…(t + m)/(m + 1)! and its derivative N_m
    let (mut product, mut slope) = (t, 1.0);
    let mut m = 0;
    while m < MOST_SAMPLES {
        let mut j = m;
        while j > 0 {
            binomials[j] += binomials[j - 1];
            j -= 1;
        }
        while j <= m {
            let sign = if j % 2 == 0 { 1.0 } else { -1.0 };
            weights[j] += sign * binomials[j] * slope;
            squares[m] += weights[j] * weights[j];
            j += 1;
        }
        m += 1;
        let factor = (t + m as f64) / (m + 1) as f64;
        slope = slope * factor + product / (m + 1) as f64;
        product *= factor;
    }
    squares
}
