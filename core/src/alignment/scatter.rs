//! The scatter of pieces of a stretch of samples, and the variance of their mean.
//!
//! The integral of the deviations from the mean starts and ends at 0 (a bridge). White noise makes it a
//! Brownian bridge of mean square N²T/6, and the variance of the mean is N²/T: 6/T² times that. A vehicle
//! that rocks returns to where it was, so its bridge does not grow with T, and its mean is better in
//! proportion; a bias that wanders makes both larger. So 6/T² times the mean square of the bridge is right
//! in all three cases, whereas scatter from second to second says little about the mean of a minute.
//! Source: Revuz & Yor, *Continuous Martingales and Brownian Motion*, ch. I §3 (t(T − t)/T, mean T/6).

use crate::math::real::Scalar;
use crate::math::vector::Vector;

/// Sums over the pieces of one triad, relative to the first piece, to keep digits.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct Scatter<R> {
    count: u32,
    first: Vector<R>,
    last: Vector<R>,
    sum: Vector<R>,
    squares: Vector<R>,
    /// Squares of the steps from each piece to the next.
    steps: Vector<R>,
    /// Σ S_k² and Σ k·S_k of the sums S_k of the first k pieces, k from 1.
    sum_squares: Vector<R>,
    sum_moment: Vector<R>,
    /// Σ S_k.
    sum_of_sums: Vector<R>,
}

impl<R: Scalar> Scatter<R> {
    /// Adds the mean of the next piece.
    pub fn add(&mut self, value: Vector<R>) {
        let square = |v: Vector<R>| v.map(|c| c * c);
        if self.count == 0 {
            self.first = value;
        }
        let value = value - self.first;
        self.squares = self.squares + square(value);
        self.steps = self.steps + square(value - self.last);
        self.last = value;
        self.sum = self.sum + value;
        self.count = self.count.saturating_add(1);
        self.sum_squares = self.sum_squares + square(self.sum);
        self.sum_of_sums = self.sum_of_sums + self.sum;
        self.sum_moment = self.sum_moment + self.sum * R::count(self.count);
    }

    /// Pieces so far.
    pub fn count(&self) -> u32 {
        self.count
    }

    /// Variance of the pieces about their mean.
    pub fn variance(&self) -> Vector<R> {
        if self.count < 2 {
            return Vector::ZERO;
        }
        let n = R::count(self.count);
        let mean = self.sum * (R::ONE / n);
        let about = self.squares - mean.zip(self.sum, |mean, sum| mean * sum);
        about.map(|c| if c > R::ZERO { c / (n - R::ONE) } else { R::ZERO })
    }

    /// Half the mean square of a step: the Allan variance at the length of a piece.
    pub fn step_variance(&self) -> Vector<R> {
        if self.count < 2 {
            return Vector::ZERO;
        }
        self.steps * (R::HALF / R::count(self.count - 1))
    }

    /// Variance of the mean of all pieces, from the bridge.
    pub fn variance_of_mean(&self) -> Vector<R> {
        if self.count < 2 {
            return Vector::ZERO;
        }
        // Σ(S_k − k m)² = ΣS_k² − 2m ΣkS_k + m² Σk²,  Σk² = n(n + 1)(2n + 1)/6.
        // For n pieces of variance s² its mean is s²(n² − 1)/6, so the variance of the mean, s²/n, is 6/(n(n²
        // − 1)) of it.
        let n = R::count(self.count);
        let mean = self.sum * (R::ONE / n);
        let squares = n * (n + R::ONE) * (n + n + R::ONE) * R::ratio(1, 6);
        let cross = mean.zip(self.sum_moment, |m, moment| m * moment) * R::TWO;
        let bridge = self.sum_squares - cross + mean.map(|m| m * m * squares);
        let share = R::of(6.0) / (n * (n * n - R::ONE));
        bridge.map(|b| if b > R::ZERO { b * share } else { R::ZERO })
    }

    /// The slope of the straight line through the pieces, per piece.
    pub fn slope(&self) -> Vector<R> {
        if self.count < 2 {
            return Vector::ZERO;
        }
        // Σ(k − k̄)x_k / Σ(k − k̄)²,  Σ(k − k̄)² = n(n² − 1)/12,  Σ k·x_k = (n + 1)S_n − ΣS_k
        let n = R::count(self.count);
        let squares = n * (n * n - R::ONE) * R::ratio(1, 12);
        let sums = self.sum_of_sums;
        (self.sum * ((n + R::ONE) * R::HALF) - sums) * (R::ONE / squares)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Bridge and slope by their definitions, in two passes.
    fn by_definition(pieces: &[f64]) -> (f64, f64) {
        let n = pieces.len() as f64;
        let mean = pieces.iter().sum::<f64>() / n;
        let (mut sum, mut bridge, mut steep, mut spread) = (0.0, 0.0, 0.0, 0.0);
        for (k, x) in pieces.iter().enumerate() {
            sum += x - mean;
            bridge += sum * sum;
            let from_middle = k as f64 - 0.5 * (n - 1.0);
            steep += from_middle * x;
            spread += from_middle * from_middle;
        }
        (6.0 * bridge / (n * (n * n - 1.0)), steep / spread)
    }

    #[test]
    fn sums_give_what_two_passes_give() {
        let pieces = [0.3, -1.1, 2.7, 0.4, 0.9, -0.2, 5.1, 3.0];
        for count in 2..=pieces.len() {
            let mut scatter = Scatter::default();
            for &x in pieces.iter().take(count) {
                scatter.add(Vector::new(x, -2.0 * x, 7.0));
            }
            let (bridge, slope) = by_definition(pieces.get(..count).unwrap_or(&[]));
            let near = |a: f64, b: f64| (a - b).abs() <= 1e-13 * b.abs();
            let (variance, steep) = (scatter.variance_of_mean(), scatter.slope());
            assert!(near(variance.x, bridge) && near(variance.y, 4.0 * bridge), "{variance:?}");
            assert!(near(steep.x, slope) && near(steep.y, -2.0 * slope), "{count}: {steep:?}");
            assert!(variance.z == 0.0 && steep.z == 0.0);
        }
        let mut one = Scatter::default();
        one.add(Vector::new(1.0, 2.0, 3.0));
        assert_eq!((one.variance_of_mean(), one.slope()), (Vector::ZERO, Vector::ZERO));
    }
}
