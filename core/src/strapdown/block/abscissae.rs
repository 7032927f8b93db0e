//! Fit of a window whose samples differ in length, at their true abscissae.
//!
//! σ ∈ [−1, 1] spans the block of duration T, and sample j is [σⱼ, σⱼ₊₁], 2/T times its interval long.
//! F(σ) = ∫ w dσ is known at the edges σⱼ, up to a constant: Newton's polynomial through them has
//! w(σ) = F′(σ). Its divided differences begin with the samples' mean rates, so that nothing cancels
//! if the rate is steady, and its nodes are taken from the block's middle outwards.

use super::fit::{Fit, MOST_SAMPLES, each};
use crate::math::compensated::{Pair, two_product};
use crate::math::real::Real;
use crate::math::real::Twin as _;
use crate::math::vector::Vector;
use crate::sample::Increment;

/// Samples with their own intervals about a block.
#[derive(Clone, Copy)]
pub(crate) struct Spaced<'a, R: Real> {
    /// The window's samples.
    pub samples: &'a [Increment<R>],
    /// Their intervals less the nominal one, s.
    pub excess: &'a [R],
    /// The nominal interval, s.
    pub interval_s: Pair<R>,
    /// Samples before the block.
    pub history: usize,
    /// Samples of the block.
    pub block: usize,
    /// T, s.
    pub time_s: Pair<R>,
}

impl<'a, R: Real> Spaced<'a, R> {
    /// The samples' lengths in σ.
    fn widths(self) -> impl Iterator<Item = Pair<R>> + use<'a, R> {
        // 2/T
        let scale = (self.time_s * Pair::new(R::HALF)).reciprocal();
        let width = move |&excess: &R| (self.interval_s + Pair::new(excess)) * scale;
        self.excess.iter().take(MOST_SPACED).map(width)
    }

    /// The mean rate over the block, and for each sample its length and its increment less that rate times the
    /// length. In steady motion this is almost nothing, so there is nothing to round.
    fn varying(self) -> (Increment<R>, impl Iterator<Item = (R, [R::Twin; 3])> + use<'a, R>) {
        let mut sum = Increment::ZERO;
        for sample in self.samples.iter().skip(self.history).take(self.block) {
            sum.angle_b = sum.angle_b + sample.angle_b;
            sum.velocity_b = sum.velocity_b + sample.velocity_b;
        }
        let mean =
            Increment { angle_b: sum.angle_b * R::HALF, velocity_b: sum.velocity_b * R::HALF };
        let beyond = move |(width, sample): (Pair<R>, &Increment<R>)| {
            let less = |x: R, mean: R| {
                let (p, e) = two_product(width.hi, mean);
                (x - p) - (e + width.lo * mean)
            };
            let varying = Increment {
                angle_b: sample.angle_b.zip(mean.angle_b, less),
                velocity_b: sample.velocity_b.zip(mean.velocity_b, less),
            };
            (width.hi, varying.twins())
        };
        (mean, self.widths().zip(self.samples).map(beyond))
    }

    /// The block's own samples.
    fn own(self) -> Self {
        let own = self.history..self.history + self.block;
        Self {
            samples: self.samples.get(own.clone()).unwrap_or(&[]),
            excess: self.excess.get(own).unwrap_or(&[]),
            history: 0,
            ..self
        }
    }

    /// Whether no interval is over [`MOST_UNEVEN`] times another.
    fn is_even(self) -> bool {
        let (mut least, mut most) = (R::of(f32::MAX as f64), R::ZERO);
        for Pair { hi: width, .. } in self.widths() {
            least = R::select(width.less(least), width, least);
            most = R::select(most.less(width), width, most);
        }
        !R::any((least * R::of(MOST_UNEVEN)).less(most))
    }

    /// The polynomial through the samples. For `near`, and if their lengths differ too much, a straight line or
    /// parabola through the block's own samples by least squares.
    #[inline(never)]
    pub fn fit(self, near: Option<usize>) -> Fit<R, MOST_SAMPLES> {
        match near {
            Some(coefficients) => self.own().least_squares(coefficients),
            None if self.own().is_even() => self.interpolate(),
            None => self.own().least_squares(3),
        }
    }

    /// The polynomial through them all.
    fn interpolate(self) -> Fit<R, MOST_SAMPLES> {
        let none = [R::Twin::both(R::ZERO); 3];
        let mut edges = [R::ZERO; MOST_SAMPLES + 1];
        let mut differences = [none; MOST_SAMPLES];
        // The first edge, so that the block begins at −1; then F[σⱼ, σⱼ₊₁] = Δθⱼ/(σⱼ₊₁ − σⱼ).
        let (mean, varying) = self.varying();
        let before = self.widths().take(self.history);
        let mut edge = before.fold(-R::ONE, |edge, width| edge - width.hi);
        let mut count = 0;
        for (((width, sample), at), rate) in varying.zip(&mut edges).zip(&mut differences) {
            *at = edge;
            let inverse = R::Twin::both(R::ONE / width);
            *rate = sample.map(|x| x * inverse);
            edge = edge + width;
            count += 1;
        }
        if let Some(last) = edges.get_mut(count) {
            *last = edge;
        }
        let edge = |at: usize| edges.get(at).copied().unwrap_or(R::ZERO);

        // F[σᵢ … σᵢ₊ₙ] = (F[σᵢ₊₁ … σᵢ₊ₙ] − F[σᵢ … σᵢ₊ₙ₋₁])/(σᵢ₊ₙ − σᵢ): of each order, that of the edges
        // from `low` to `high`, which take in one more each time.
        let mut newton = [(none, R::ZERO); MOST_SAMPLES];
        let (mut low, mut high) = (self.history + self.block / 2, self.history + self.block / 2);
        let mut node = edge(low);
        for (n, term) in (1..=count).zip(&mut newton) {
            if n > 1 {
                for i in 0..=count - n {
                    let inverse = R::Twin::both(R::ONE / (edge(i + n) - edge(i)));
                    let next = differences.get(i + 1).copied().unwrap_or(none);
                    if let Some(this) = differences.get_mut(i) {
                        *this = each(next, *this, |next, this| (next - this) * inverse);
                    }
                }
            }
            let rightwards = high < count && (n % 2 == 1 || low == 0);
            let added = if rightwards { high + 1 } else { low.saturating_sub(1) };
            (low, high) = (low.min(added), high.max(added));
            *term = (differences.get(low).copied().unwrap_or(none), node);
            node = edge(added);
        }

        if let Some(newton) = newton.get_mut(..count) {
            self.drop_unsupported(newton);
        }

        // F = (σ − x₁)(c₁ + (σ − x₂)(c₂ + …)): powers of σ from the innermost bracket outwards.
        let mut powers = [none; MOST_SAMPLES + 1];
        for (c, node) in newton.iter().take(count).rev() {
            let node = R::Twin::both(*node);
            if let Some(constant) = powers.first_mut() {
                *constant = each(*constant, *c, |a, c| a + c);
            }
            let mut below = none;
            for power in powers.iter_mut().take(count + 1) {
                let this = *power;
                *power = each(below, this, |below, this| below - this * node);
                below = this;
            }
        }
        let rates = powers.iter().skip(1).zip(1..);
        fit_about(&mean, rates.map(|(power, k)| power.map(|x| x * R::Twin::both(R::count(k)))))
    }

    /// Drops terms from samples beside the block if they do not become smaller and smaller: the motion is then
    /// not resolved, and those samples would disturb the fit as noise does.
    fn drop_unsupported(self, newton: &mut [([R::Twin; 3], R)]) {
        // The n-th term's share of the rate, cₙ d/dσ Π(σ − xᵢ), is cₙ Π_{i≠m}(xₘ − xᵢ) at its edge xₘ.
        // The first share is the rest of the first sample beside the mean rate: it is no measure.
        let unknown = (R::of(1e30), R::of(1e30));
        let mut before = [unknown; 2];
        let mut dropped = (false, false);
        for n in 1..=newton.len() {
            let (nodes, _) = newton.split_at(n);
            let Some((c, _)) = nodes.last() else { return };
            let Increment::<R> { angle_b, velocity_b } = Increment::from_twins(*c);
            let mut steepest = R::ZERO;
            for (m, (_, at)) in nodes.iter().enumerate().take(self.block + 1) {
                let others = nodes.iter().enumerate().filter(|&(i, _)| i != m);
                let slope = others.fold(R::ONE, |product, (_, (_, node))| product * (*at - *node));
                let slope = slope * slope;
                steepest = R::select(steepest.less(slope), slope, steepest);
            }
            let share = (angle_b.dot(angle_b) * steepest, velocity_b.dot(velocity_b) * steepest);
            if n > self.block {
                // Odd and even terms may differ in size.
                let [last, last_but_one] = before;
                dropped.0 |= R::any(last.0.less(share.0)) & R::any(last_but_one.0.less(share.0));
                dropped.1 |= R::any(last.1.less(share.1)) & R::any(last_but_one.1.less(share.1));
            }
            before = [if n > 1 { share } else { unknown }, before[0]];
            if let Some((c, _)) = newton.get_mut(n - 1) {
                let angle_b = if dropped.0 { Vector::ZERO } else { angle_b };
                let velocity_b = if dropped.1 { Vector::ZERO } else { velocity_b };
                *c = Increment { angle_b, velocity_b }.twins();
            }
        }
    }

    /// The straight line or parabola by least squares, each sample weighted by 1/its length. It preserves
    /// their sum.
    fn least_squares(self, coefficients: usize) -> Fit<R, MOST_SAMPLES> {
        // In 1, σ and σ² − ⅓, whose integrals over the sample from −δ/2 to δ/2 about m are δ, δm and
        // δ(m² + δ²/12 − ⅓): the first is orthogonal to the others.
        let third = R::of(1.0 / 3.0);
        let none = [R::Twin::both(R::ZERO); 3];
        let (mut sum, mut slope, mut bend) = (none, none, none);
        let (mut g11, mut g12, mut g22) = (R::ZERO, R::ZERO, R::ZERO);
        let mut edge = -R::ONE;
        let (mean, varying) = self.varying();
        for (width, sample) in varying {
            let middle = edge + width * R::HALF;
            let curve = middle * middle + width * width * R::of(1.0 / 12.0) - third;
            g11 = g11 + width * middle * middle;
            g12 = g12 + width * middle * curve;
            g22 = g22 + width * curve * curve;
            let (p, q) = (R::Twin::both(middle), R::Twin::both(curve));
            sum = each(sum, sample, |sum, x| sum + x);
            slope = each(slope, sample, |sum, x| sum + x * p);
            bend = each(bend, sample, |sum, x| sum + x * q);
            edge = edge + width;
        }
        // With fewer samples than coefficients, the constant or the line through them.
        let lines = self.samples.len().min(coefficients);
        if lines < 3 {
            (g12, g22, bend) = (R::ZERO, R::ONE, none);
        }
        if lines < 2 {
            (g11, slope) = (R::ONE, none);
        }
        let inverse = R::ONE / (g11 * g22 - g12 * g12);
        let solved = |a: R, x, b: R, y| {
            let (a, b) = (R::Twin::both(a * inverse), R::Twin::both(b * inverse));
            each(x, y, |x, y| x * a - y * b)
        };
        let (w1, w2) = (solved(g22, slope, g12, bend), solved(g11, bend, g12, slope));
        let (half, third) = (R::Twin::both(R::HALF), R::Twin::both(third));
        let w0 = each(sum, w2, |sum, w2| sum * half - w2 * third);
        fit_about(&mean, [w0, w1, w2].into_iter())
    }
}

/// The fit of a mean rate and of coefficients beyond it.
fn fit_about<R: Real>(
    mean: &Increment<R>,
    coefficients: impl Iterator<Item = [R::Twin; 3]>,
) -> Fit<R, MOST_SAMPLES> {
    let mut fit = Fit { rate: [Vector::ZERO; MOST_SAMPLES], force: [Vector::ZERO; MOST_SAMPLES] };
    for (w, (rate, force)) in coefficients.zip(fit.rate.iter_mut().zip(&mut fit.force)) {
        let Increment { angle_b, velocity_b } = Increment::from_twins(w);
        (*rate, *force) = (angle_b, velocity_b);
    }
    let ([rate, ..], [force, ..]) = (&mut fit.rate, &mut fit.force);
    *rate = *rate + mean.angle_b;
    *force = *force + mean.velocity_b;
    fit
}

/// Most samples of a block, and of a window.
const MOST_SPACED: usize = 64;

/// The largest ratio of sample lengths in a block for which a polynomial through all samples is used: beyond
/// it, the short samples would be extrapolated far into the long one.
const MOST_UNEVEN: f64 = 8.0;
