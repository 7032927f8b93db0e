//! The error of a window in pure coning and sculling, to second order in the amplitude, from its
//! interpolation and the truncation of its series alone, without code of the navigator.
//!
//! A window passes on the integral over every sample exactly, so the first order is exact, too. To
//! second order a rotation F = e^{iβt} (one sample is 1 in t) drifts by ½Im∫F*F′ about the third axis. A
//! window replaces F by the polynomial P through its values at the samples' edges, and a series of order
//! M about the block's centre, σ = 0, drops what P*P′ adds beyond σᴹ.

use schuler::strapdown::block::window::*;

/// A window's samples and the order of its series.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shape {
    /// Samples before the block.
    pub history: usize,
    /// Samples integrated at once.
    pub block: usize,
    /// Samples after the block.
    pub lookahead: usize,
    /// Order of the series.
    pub terms: usize,
}

/// The series of a stream's first and last blocks is longer than any window's own.
const EDGE_TERMS: usize = 26;

impl Shape {
    /// Of a named window.
    pub const fn of<W: Window>() -> Self {
        let (history, block) = (W::HISTORY, W::BLOCK);
        Self { history, block, lookahead: W::LOOKAHEAD, terms: W::TERMS }
    }

    /// Of a stream's first block, which looks ahead where it has no history: ten samples or more.
    pub fn first(self) -> Self {
        let samples = self.history + self.block + self.lookahead;
        let lookahead = if self.history > 0 { samples.max(10) } else { samples } - self.block;
        Self { history: 0, block: self.block, lookahead, terms: EDGE_TERMS }
    }

    /// Of its last block, which looks back instead of ahead.
    pub fn last(self) -> Self {
        let history = self.history + self.lookahead;
        Self { history, block: self.block, lookahead: 0, terms: EDGE_TERMS }
    }
}

/// A complex number.
type Complex = [f64; 2];

fn add(a: Complex, b: Complex) -> Complex {
    [a[0] + b[0], a[1] + b[1]]
}

fn less(a: Complex, b: Complex) -> Complex {
    [a[0] - b[0], a[1] - b[1]]
}

fn times(a: Complex, k: f64) -> Complex {
    [a[0] * k, a[1] * k]
}

/// a*·b.
fn conjugate_product(a: Complex, b: Complex) -> Complex {
    [a[0] * b[0] + a[1] * b[1], a[0] * b[1] - a[1] * b[0]]
}

fn size(a: Complex) -> f64 {
    a[0].hypot(a[1])
}

/// e^{ix}.
fn turn(x: f64) -> Complex {
    [x.cos(), x.sin()]
}

/// A window's polynomial in σ, which is ±1 at the block's ends, through e^{iβt} at its edges.
struct Interpolation(Vec<Complex>);

impl Interpolation {
    fn new(shape: Shape, beta: f64) -> Self {
        let Shape { history, block, lookahead, .. } = shape;
        let samples = history + block + lookahead;
        let sigma = |m: usize| 2.0 * (m as f64 - history as f64) / block as f64 - 1.0;
        let mut sum = vec![[0.0; 2]; samples + 1];
        for m in 0..=samples {
            // ℓ_m(σ) = Π_{i≠m}(σ − σᵢ)/(σ_m − σᵢ)
            let mut basis = vec![1.0];
            for i in (0..=samples).filter(|&i| i != m) {
                let scale = 1.0 / (sigma(m) - sigma(i));
                let shifted = basis.iter().map(|c| -c * sigma(i) * scale).chain([0.0]);
                let raised = [0.0].into_iter().chain(basis.iter().map(|c| c * scale));
                basis = shifted.zip(raised).map(|(a, b)| a + b).collect();
            }
            let value = turn(beta * (m as f64 - history as f64));
            for (sum, c) in sum.iter_mut().zip(basis) {
                *sum = add(*sum, times(value, c));
            }
        }
        Self(sum)
    }

    fn at(&self, sigma: f64) -> Complex {
        self.0.iter().rev().fold([0.0; 2], |sum, &c| add(times(sum, sigma), c))
    }

    /// ∫(P − P(−1)) dσ over the block.
    fn mean_rise(&self) -> Complex {
        let terms = self.0.iter().enumerate().step_by(2);
        let integral = terms.fold([0.0; 2], |s, (n, &c)| add(s, times(c, 2.0 / (n + 1) as f64)));
        less(integral, times(self.at(-1.0), 2.0))
    }
}

/// ∫(P − P(−1))*Q′ dσ from the block's start to σ, by a series of a given order, less the same of the true
/// functions; P and Q follow e^{iβt} of two β.
fn product(shape: Shape, [first, second]: [f64; 2], sigma: f64) -> Complex {
    let (p, q) = (Interpolation::new(shape, first), Interpolation::new(shape, second));
    // With P = P(0) + p the centre's part is exact, and p*Q′ is what the series ends in.
    let mut sum = [0.0; 2];
    for (n, &a) in p.0.iter().enumerate().skip(1) {
        for (m, &b) in q.0.iter().enumerate().skip(1) {
            let power = (n + m) as i32;
            if n + m <= shape.terms {
                let gain = sigma.powi(power) - (-1.0_f64).powi(power);
                sum = add(sum, times(conjugate_product(a, b), m as f64 * gain / f64::from(power)));
            }
        }
    }
    let rise = less(q.at(sigma), q.at(-1.0));
    let sum = add(sum, conjugate_product(less(p.at(0.0), p.at(-1.0)), rise));
    // ∫(e^{iβt} − 1)* iγ e^{iγt} dt = γ/(γ − β)·(e^{i(γ−β)t} − 1) − (e^{iγt} − 1)
    let t = shape.block as f64 * (sigma + 1.0) / 2.0;
    let one = [1.0, 0.0];
    let exact = if first == second {
        [0.0, second * t]
    } else {
        times(less(turn((second - first) * t), one), second / (second - first))
    };
    less(sum, less(exact, less(turn(second * t), one)))
}

/// Drift of pure coning over a block, rad per squared rad of the half-cone angle.
pub fn coning_block(shape: Shape, beta: f64) -> f64 {
    // ½Im∫F*F′
    0.5 * product(shape, [beta, beta], 1.0)[1].abs()
}

/// The same per sample.
pub fn coning(shape: Shape, beta: f64) -> f64 {
    coning_block(shape, beta) / shape.block as f64
}

/// The largest error at a row inside a block beyond that of the block's start, likewise.
pub fn coning_within(shape: Shape, beta: f64) -> f64 {
    let rows = 1..shape.block;
    let sigma = |row: usize| 2.0 * row as f64 / shape.block as f64 - 1.0;
    let error = |row| 0.5 * product(shape, [beta, beta], sigma(row))[1].abs();
    rows.map(error).fold(0.0, f64::max)
}

/// What a block leaves to third order, rad per cubed rad, about: a cone built from roll and pitch turns
/// about the third axis, too, by ½a²(t + ½sin 2βt), and the window fits the second harmonic worse.
pub fn third_order(shape: Shape, beta: f64) -> f64 {
    let both = [[2.0 * beta, beta], [-2.0 * beta, beta], [beta, 2.0 * beta], [beta, -2.0 * beta]];
    let mixed: f64 = both.iter().map(|&pair| size(product(shape, pair, 1.0))).sum();
    // ∫t(P′ − F′) dt = −∫(P − F) dt
    mixed / 8.0 + 0.5 * beta * first_order(shape, beta)
}

/// What a block leaves of the integral of an angle, in samples, for an amplitude of 1: to first order the
/// ends of a block are exact and what is between them is not.
pub fn first_order(shape: Shape, beta: f64) -> f64 {
    // ∫(e^{iβt} − 1) dt = (sin βt + i(1 − cos βt))/β − t
    let time = shape.block as f64;
    let [cosine, sine] = turn(beta * time);
    let exact = [sine / beta - time, (1.0 - cosine) / beta];
    let rise = times(Interpolation::new(shape, beta).mean_rise(), 0.5 * time);
    size(less(rise, exact))
}

/// Mean velocity error of sculling over a block at most, for an angle of amplitude 1 rad and a velocity of
/// amplitude 1 m/s.
pub fn sculling_block(shape: Shape, beta: f64) -> f64 {
    // Re x·Re y = ½Re(x*y) + ½Re(xy), of which the second averages out over the phases
    0.5 * size(product(shape, [beta, beta], 1.0))
}

/// The same per sample.
pub fn sculling(shape: Shape, beta: f64) -> f64 {
    sculling_block(shape, beta) / shape.block as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// Leading terms 8β⁷/189, .00142β⁹ and .00119β¹¹ per block, and the drift per sample at ten samples
    /// per cycle from arithmetic of high precision.
    #[test]
    fn windows_leave_what_their_leading_terms_say() {
        let near = |a: f64, b: f64, part: f64| assert!((a / b - 1.0).abs() < part, "{a:e} {b:e}");
        let beta = TAU / 40.0;
        // Without the series' end.
        let block = |shape: Shape, beta| coning_block(Shape { terms: 99, ..shape }, beta);
        near(block(Shape::of::<H0B4A0>(), beta), 8.0 * beta.powi(7) / 189.0, 0.05);
        near(block(Shape::of::<H2B2A2>(), beta), 0.00142 * beta.powi(9), 0.05);
        let beta = TAU / 24.0;
        near(block(Shape::of::<H2B4A2>(), beta), 0.00119 * beta.powi(11), 0.1);
        let whole = |shape: Shape| block(shape, TAU / 10.0) / shape.block as f64;
        for (shape, expected) in [
            (Shape::of::<H0B4A0>(), 3.4e-4),
            (Shape::of::<H2B2A2>(), 9.8e-6),
            (Shape::of::<H2B4A2>(), 1.4e-6),
            (Shape::of::<H4B4A4>(), 8.5e-9),
        ] {
            near(whole(shape), expected, 0.04);
        }
    }
}
