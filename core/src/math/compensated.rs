//! Sums that carry what rounding drops, and two-float numbers.
//!
//! Knuth's two-sum and Dekker's product are exact in IEEE 754 arithmetic of any width:
//! a + b = s + e and a·b = p + e. A [`Pair`] holds such a result: about twice the digits.
//!
//! ```
//! use schuler::math::compensated::{Accumulate, Pair, Plain, two_sum};
//!
//! // A million steps of a tenth, in single precision.
//! let (mut plain, mut pair) = (Plain(0.0_f32), Pair::new(0.0_f32));
//! for _ in 0..1_000_000 {
//!     plain.add(0.1);
//!     pair.add(0.1);
//! }
//! assert!((plain.value() - 1e5).abs() > 900.0);
//! assert!((pair.value() - 1e5).abs() < 0.01);
//! assert_eq!(two_sum(1.0_f32, 1e-10), (1.0, 1e-10));
//! ```

mod accumulate;

pub use accumulate::{Accumulate, Plain, TwoFloat};

use super::real::{Real, Scalar};
use core::ops::{Add, Mul, Neg, Sub};

/// a + b = s + e, exactly.
#[inline(always)]
pub fn two_sum<R: Real>(a: R, b: R) -> (R, R) {
    let s = a + b;
    let z = s - a;
    (s, (a - (s - z)) + (b - z))
}

/// a·b = p + e, exactly for an even split of the significand; else, in double precision, to 2⁻¹⁰⁴ of p.
#[inline(always)]
pub fn two_product<R: Real>(a: R, b: R) -> (R, R) {
    let p = a * b;
    let (ah, bh) = (a.upper_half(), b.upper_half());
    let (al, bl) = (a - ah, b - bh);
    (p, ((ah * bh - p) + ah * bl + al * bh) + al * bl)
}

/// A number as the unevaluated sum of a leading and a trailing part.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Pair<R> {
    /// The number rounded.
    pub hi: R,
    /// The part that rounding dropped.
    pub lo: R,
}

impl<R: Real> Pair<R> {
    /// An exact number.
    #[inline(always)]
    pub const fn new(hi: R) -> Self {
        Self { hi, lo: R::ZERO }
    }

    /// A literal with the part that rounding drops.
    #[inline(always)]
    pub fn of(literal: f64) -> Self {
        Self { hi: R::of(literal), lo: R::residual(literal) }
    }

    /// The sum of two numbers, exactly.
    #[inline(always)]
    pub fn sum(a: R, b: R) -> Self {
        let (hi, lo) = two_sum(a, b);
        Self { hi, lo }
    }

    /// 1/x, to about twice the digits.
    #[inline(always)]
    pub fn reciprocal(self) -> Self {
        let hi = R::ONE / self.hi;
        let (p, e) = two_product(hi, self.hi);
        Self { hi, lo: (((R::ONE - p) - e) - hi * self.lo) / self.hi }
    }

    /// √x, to about twice the digits; x must be positive.
    pub fn sqrt(self) -> Self {
        // √(s² + r) = s + r/2s
        let s = self.hi.sqrt();
        let (p, e) = two_product(s, s);
        Self::sum(s, (((self.hi - p) - e) + self.lo) / (s + s))
    }

    /// Sine and cosine of an angle in radians, |x| ≤ π, to about twice the digits, by their series.
    pub fn sin_cos(self) -> (Self, Self) {
        // sin x = Σ (−1)ᵏ x²ᵏ⁺¹/(2k+1)!,  cos x = Σ (−1)ᵏ x²ᵏ/(2k)!
        let square = self * self;
        let (mut sine, mut cosine) = (self, Self::new(R::ONE));
        let (mut odd, mut even) = (sine, cosine);
        let mut n = 1;
        while n < 40 {
            even = -(even * square * Self::new(R::count(n * (n + 1))).reciprocal());
            odd = -(odd * square * Self::new(R::count((n + 1) * (n + 2))).reciprocal());
            cosine = cosine + even;
            sine = sine + odd;
            n += 2;
        }
        (sine, cosine)
    }
}

impl<R: Scalar> Pair<R> {
    /// In double precision, rounded once.
    pub fn widen(self) -> f64 {
        self.hi.widen() + self.lo.widen()
    }

    /// In double precision, as a pair, exactly.
    pub fn widen_pair(self) -> Pair<f64> {
        Pair::sum(self.hi.widen(), self.lo.widen())
    }

    /// From a pair in double precision.
    pub fn narrow(x: Pair<f64>) -> Self {
        let hi = R::narrow(x.hi);
        Self { hi, lo: R::narrow((x.hi - hi.widen()) + x.lo) }
    }
}

impl<R: Real> Neg for Pair<R> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }
}

impl<R: Real> Add for Pair<R> {
    type Output = Self;
    #[inline(always)]
    fn add(self, b: Self) -> Self {
        let (s, e) = two_sum(self.hi, b.hi);
        Self::sum(s, e + (self.lo + b.lo))
    }
}

impl<R: Real> Sub for Pair<R> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, b: Self) -> Self {
        self + -b
    }
}

impl<R: Real> Mul for Pair<R> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, b: Self) -> Self {
        let (p, e) = two_product(self.hi, b.hi);
        Self::sum(p, e + (self.hi * b.lo + self.lo * b.hi))
    }
}
