//! The Allan variance by octaves of the averaging time: a sample is dealt with at once, and none is kept.
//!
//! With s the sum of the increments of a cluster of m samples, τ = mΔt, and M differences d = s₁ − s₀ of
//! neighbouring clusters, σ²(τ) = Σd²/(2Mτ²). For m = 1, 2 and 4 a difference ends with every sample
//! (fully overlapped). Each further octave keeps the last eight sums of quarter clusters, takes a difference
//! for each quarter, and passes the sums of two on to the next: two octaves' work per sample on average.
//! A stride of a quarter keeps 92 to 100 % of the degrees of freedom of full overlap.
//!
//! ```
//! use schuler::allan::octaves::Octaves;
//!
//! let mut axis: Octaves<f32> = Octaves::new(0.5)?;
//! for increment in [1.0, 3.0, 2.0, 2.0] {
//!     axis.add(increment)?;
//! }
//! // Differences 2, −1, 0 of neighbours: (4 + 1 + 0)/(2·3·0.5²); and of pairs, 0.
//! let points: Vec<_> = axis.points().map(|point| point.variance).collect();
//! assert_eq!(points, [5.0 / 1.5, 0.0]);
//! # Ok::<(), schuler::allan::octaves::Refused>(())
//! ```

use super::freedom;
use super::term::Term;
use crate::math::compensated::{Accumulate, Pair, two_sum};
use crate::math::real::{Number, Real, Scalar};
use crate::record::Record;

/// Octaves from m = 4 on, with which the longest cluster is 2²⁹ samples: two months at 100 Hz.
pub const RINGS: usize = 28;

/// A scalar with sums of increments that keep its digits.
pub trait Sums: Scalar {
    /// Such a sum; of the size of two single-precision numbers.
    type Sum: Number + Record + core::fmt::Debug + PartialEq + Send;
    /// a − b.
    fn difference(a: Self, b: Self) -> Self::Sum;
    /// The sums' difference, rounded: its error is that of the result, however large both are.
    fn between(a: Self::Sum, b: Self::Sum) -> Self;
    /// Whether its size is within a bound; not a number never is.
    fn is_within(sum: Self::Sum, bound: Self) -> bool;
}

impl Sums for f64 {
    type Sum = f64;
    #[inline(always)]
    fn difference(a: f64, b: f64) -> f64 {
        a - b
    }
    #[inline(always)]
    fn between(a: f64, b: f64) -> f64 {
        a - b
    }
    fn is_within(sum: f64, bound: f64) -> bool {
        Real::is_within(sum, bound)
    }
}

impl Sums for f32 {
    type Sum = Pair<f32>;
    #[inline(always)]
    fn difference(a: f32, b: f32) -> Pair<f32> {
        let (hi, lo) = two_sum(a, -b);
        Pair { hi, lo }
    }
    #[inline(always)]
    fn between(a: Pair<f32>, b: Pair<f32>) -> f32 {
        (a.hi - b.hi) + (a.lo - b.lo)
    }
    fn is_within(sum: Pair<f32>, bound: f32) -> bool {
        Real::is_within(sum.hi, bound) && Real::is_within(sum.lo, bound)
    }
}

/// Why a number was not taken; nothing is changed then.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Refused {
    /// The sample interval is not positive and finite.
    Interval,
    /// The increment is not finite, or too large to be squared.
    Increment,
}

impl core::fmt::Display for Refused {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(match self {
            Self::Interval => "the sample interval is not positive and finite",
            Self::Increment => "the increment is not finite, or too large to be squared",
        })
    }
}

impl core::error::Error for Refused {}

/// The octave of one length of clusters.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Ring<R: Sums> {
    /// Of the last eight quarters of a cluster, the newest last.
    pub(super) quarters: [R::Sum; 8],
    /// Σd².
    pub(super) squares: Pair<R>,
}

impl<R: Sums> Ring<R> {
    /// Takes the sum of the next quarter. Returns that of the last two, and the differences of neighbouring
    /// clusters of one, two and four quarters.
    #[inline(always)]
    fn push(&mut self, sum: R::Sum) -> (R::Sum, [R; 3]) {
        let [_, a, b, c, d, e, f, g] = self.quarters;
        self.quarters = [a, b, c, d, e, f, g, sum];
        let two = R::between(sum, f) + R::between(g, e);
        let four = (R::between(sum, d) + R::between(g, c)) + (R::between(f, b) + R::between(e, a));
        (g + sum, [R::between(sum, g), two, four])
    }
}

/// The Allan variance of one axis. `OCTAVES` of them besides m = 1 and 2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Octaves<R: Sums, const OCTAVES: usize = RINGS> {
    interval_s: R,
    pub(super) samples: u64,
    /// What is taken off each sample, so that the mean costs no digits.
    pub(super) first: R,
    /// Σd² of m = 1 and 2.
    pub(super) squares: [Pair<R>; 2],
    pub(super) rings: [Ring<R>; OCTAVES],
}

#[cfg(feature = "defmt")]
impl<R: Sums + defmt::Format, const OCTAVES: usize> defmt::Format for Octaves<R, OCTAVES> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(
            f,
            "Octaves {{ interval_s: {}, samples: {} }}",
            self.interval_s,
            self.samples
        );
    }
}

/// The Allan variance at one averaging time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Point<R> {
    /// Samples in a cluster, m.
    pub samples: u64,
    /// Averaging time τ, s.
    pub tau_s: R,
    /// σ²(τ), of rates: (angle/s)², where the increments are angles.
    pub variance: R,
    /// Differences that it is the mean of, M.
    pub differences: u64,
}

impl<R: Sums> Point<R> {
    /// σ(τ), angle/s.
    pub fn deviation(&self) -> R {
        self.variance.sqrt()
    }

    /// Differences that end within a cluster's length: 1 for m = 1, 2 for m = 2, else 4.
    pub fn per_cluster(&self) -> u32 {
        match self.samples {
            1 => 1,
            2 => 2,
            _ => 4,
        }
    }

    /// Equivalent degrees of freedom where a term dominates: σ² is distributed as χ² of so many, over them.
    pub fn freedom(&self, term: Term<R>) -> R {
        freedom::of(term, self.tau_s, self.differences, self.per_cluster())
    }
}

impl<R: Sums, const OCTAVES: usize> Octaves<R, OCTAVES> {
    /// For samples of an interval, s.
    ///
    /// # Errors
    ///
    /// [`Refused::Interval`] if that is not positive and finite.
    pub fn new(interval_s: R) -> Result<Self, Refused> {
        if !(interval_s > R::ZERO && Real::is_within(interval_s, R::of(1e9))) {
            return Err(Refused::Interval);
        }
        let ring = Ring { quarters: [R::Sum::default(); 8], squares: Pair::new(R::ZERO) };
        Ok(Self {
            interval_s,
            samples: 0,
            first: R::ZERO,
            squares: [Pair::new(R::ZERO); 2],
            rings: [ring; OCTAVES],
        })
    }

    /// Samples so far.
    pub fn samples(&self) -> u64 {
        self.samples
    }

    /// Whether an increment is taken: a finite one within ±1e15.
    #[inline]
    pub fn takes(increment: R) -> bool {
        Real::is_within(increment, R::of(1e15))
    }

    /// Takes the increment of the next sample: the integral of the rate over it, angle.
    ///
    /// # Errors
    ///
    /// [`Refused::Increment`] if it is not finite, or beyond ±1e15.
    #[inline]
    pub fn add(&mut self, increment: R) -> Result<(), Refused> {
        if !Self::takes(increment) {
            return Err(Refused::Increment);
        }
        if self.samples == 0 {
            self.first = increment;
        }
        self.samples = self.samples.saturating_add(1);
        let mut sum = R::difference(increment, self.first);
        // So many quarters there are in the ring's octave by now.
        let mut quarters = self.samples;
        for (ring, m) in self.rings.iter_mut().zip(0_u32..) {
            let (two, [d1, d2, d4]) = ring.push(sum);
            let square = |sum: &mut Pair<R>, d: R, first: u64| {
                if quarters >= first {
                    sum.add(d * d);
                }
            };
            if m == 0 {
                let [one, pair] = &mut self.squares;
                square(one, d1, 2);
                square(pair, d2, 4);
            }
            square(&mut ring.squares, d4, 8);
            if quarters % 2 == 1 {
                break;
            }
            sum = two;
            quarters /= 2;
        }
        Ok(())
    }

    /// The points there are so far, from τ = Δt on, each at twice the τ of the one before.
    pub fn points(&self) -> impl Iterator<Item = Point<R>> {
        let [one, two] = self.squares;
        let short = [(one, self.samples.saturating_sub(1)), (two, self.samples.saturating_sub(3))];
        let long = self.rings.iter().zip(0_u32..).map(|(ring, octave)| {
            let quarters = self.samples.checked_shr(octave).unwrap_or(0);
            (ring.squares, quarters.saturating_sub(7))
        });
        let all = short.into_iter().chain(long).zip(0_u32..);
        all.take_while(|((_, differences), _)| *differences > 0).map(
            |((squares, differences), octave)| {
                let samples = 1_u64.checked_shl(octave).unwrap_or(u64::MAX);
                let tau_s = self.interval_s * R::ratio(samples.into(), 1);
                // σ² = Σd²/(2Mτ²)
                let twice = R::TWO * R::ratio(differences.into(), 1);
                let variance = squares.value() / (twice * tau_s * tau_s);
                Point { samples, tau_s, variance, differences }
            },
        )
    }
}
