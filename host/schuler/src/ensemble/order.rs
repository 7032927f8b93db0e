//! Order statistics: quantiles, and intervals for them that hold for any distribution.

use statrs::distribution::{Binomial, DiscreteCDF};

/// The probability that an interval holds the true quantile, at least.
pub const CONFIDENCE: f64 = 0.95;

/// Values in increasing order.
#[derive(Clone, Debug, PartialEq)]
pub struct Ordered(Vec<f64>);

/// A quantile of the values, and an interval for that of what they were drawn from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantile {
    /// Of the values.
    pub value: f64,
    /// Its interval; absent where there are too few values for one.
    pub interval: Option<[f64; 2]>,
}

impl Ordered {
    /// Of values that are numbers.
    pub fn new(mut values: Vec<f64>) -> Self {
        values.sort_unstable_by(f64::total_cmp);
        Self(values)
    }

    /// The value that a share p of the distribution lies below: linear between the values, of which the k-th of n
    /// stands at p = (k − 1)/(n − 1). (Hyndman and Fan, The American Statistician 50, 1996: type 7.)
    pub fn quantile(&self, p: f64) -> f64 {
        let Some(last) = self.0.len().checked_sub(1) else { return f64::NAN };
        let place = p.clamp(0.0, 1.0) * last as f64;
        let below = place.floor() as usize;
        let (a, b) = (self.0[below.min(last)], self.0[(below + 1).min(last)]);
        a + (place - below as f64) * (b - a)
    }

    /// The same with its interval.
    pub fn with_interval(&self, p: f64) -> Quantile {
        let interval = ranks(self.0.len() as u64, p);
        let at = |rank: u64| self.0[rank as usize - 1];
        Quantile { value: self.quantile(p), interval: interval.map(|ranks| ranks.map(at)) }
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.0.len()
    }
}

/// The ranks, from 1, between which the quantile p lies with [`CONFIDENCE`] at least; `None` where the least and the
/// greatest of n are not enough.
///
/// As many values lie below the quantile as a binomial B(n, p) says: P(x₍ₗ₎ ≤ quantile < x₍ᵤ₎) = P(l ≤ B < u).
pub fn ranks(n: u64, p: f64) -> Option<[u64; 2]> {
    let law = Binomial::new(p, n).ok()?;
    let tail = 0.5 * (1.0 - CONFIDENCE);
    // The largest l with P(B < l) ≤ tail, the least u with P(B ≥ u) ≤ tail.
    let lower = last(1..=n, |l| law.cdf(l - 1) <= tail)?;
    let upper = n + 1 - last(1..=n, |above| law.sf(n - above) <= tail)?;
    Some([lower, upper])
}

/// The last number of a range for which something holds that holds up to a number and not beyond.
fn last(range: std::ops::RangeInclusive<u64>, holds: impl Fn(u64) -> bool) -> Option<u64> {
    let (mut from, mut to) = range.into_inner();
    if from > to || !holds(from) {
        return None;
    }
    while from < to {
        let middle = from + (to - from).div_ceil(2);
        if holds(middle) { from = middle } else { to = middle - 1 }
    }
    Some(from)
}
