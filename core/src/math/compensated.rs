//! Sums that carry what rounding drops, and two-float numbers.
//!
//! Knuth's two-sum and Dekker's product are exact in IEEE 754 arithmetic of any width:
//! a + b = s + e and a·b = p + e. A [`Pair`] holds such a result: about twice the digits.

use super::quaternion::Quaternion;
use super::real::{Real, Scalar};
use super::vector::Vector;
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
    /// What the rounding dropped.
    pub lo: R,
}

impl<R: Real> Pair<R> {
    /// An exact number.
    #[inline(always)]
    pub const fn new(hi: R) -> Self {
        Self { hi, lo: R::ZERO }
    }

    /// A literal with what its rounding drops.
    #[inline(always)]
    pub fn of(literal: f64) -> Self {
        Self { hi: R::of(literal), lo: R::residual(literal) }
    }

    /// The sum of two numbers, neither rounded away.
    #[inline(always)]
    pub fn sum(a: R, b: R) -> Self {
        let (hi, lo) = two_sum(a, b);
        Self { hi, lo }
    }

    /// 1/x, to about twice the digits.
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

/// How a state variable is summed up: compensation is a type.
pub trait Accumulate: Copy {
    /// The scalar that it sums.
    type Real: Real;
    /// From a number and its remainder.
    fn from_pair(x: Pair<Self::Real>) -> Self;
    /// With what is known of the remainder.
    fn pair(self) -> Pair<Self::Real>;
    /// The leading part: what products read.
    fn value(self) -> Self::Real;
    /// The trailing part.
    fn remainder(self) -> Self::Real;
    /// Whether the products that matter are carried to twice the digits, too.
    const TWO_FLOAT: bool = false;
    /// Adds an increment.
    fn add(&mut self, d: Self::Real);
    /// Adds an increment with its own remainder, as far as this sum keeps one.
    #[inline(always)]
    fn add_pair(&mut self, d: Pair<Self::Real>) {
        self.add(d.hi);
    }
}

/// A sum without compensation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Plain<R>(pub R);

impl<R: Real> Accumulate for Plain<R> {
    type Real = R;
    #[inline(always)]
    fn from_pair(x: Pair<R>) -> Self {
        Self(x.hi)
    }
    #[inline(always)]
    fn pair(self) -> Pair<R> {
        Pair::new(self.0)
    }
    #[inline(always)]
    fn value(self) -> R {
        self.0
    }
    #[inline(always)]
    fn remainder(self) -> R {
        R::ZERO
    }
    #[inline(always)]
    fn add(&mut self, d: R) {
        self.0 = self.0 + d;
    }
}

impl<R: Real> Accumulate for Pair<R> {
    type Real = R;
    #[inline(always)]
    fn from_pair(x: Pair<R>) -> Self {
        x
    }
    #[inline(always)]
    fn pair(self) -> Pair<R> {
        self
    }
    #[inline(always)]
    fn value(self) -> R {
        self.hi
    }
    #[inline(always)]
    fn remainder(self) -> R {
        self.lo
    }
    #[inline(always)]
    fn add(&mut self, d: R) {
        *self = Self::sum(self.hi, d + self.lo);
    }
}

/// A compensated sum whose increments come with their own remainders: f32 that is good to millimetres.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TwoFloat<R>(pub Pair<R>);

impl<R: Real> Accumulate for TwoFloat<R> {
    type Real = R;
    const TWO_FLOAT: bool = true;
    #[inline(always)]
    fn from_pair(x: Pair<R>) -> Self {
        Self(x)
    }
    #[inline(always)]
    fn pair(self) -> Pair<R> {
        self.0
    }
    #[inline(always)]
    fn value(self) -> R {
        self.0.hi
    }
    #[inline(always)]
    fn remainder(self) -> R {
        self.0.lo
    }
    #[inline(always)]
    fn add(&mut self, d: R) {
        Accumulate::add(&mut self.0, d);
    }
    #[inline(always)]
    fn add_pair(&mut self, d: Pair<R>) {
        // (y, ε) = TwoSum(d, lo): a plain sum would lose half an ulp of d each time
        let (y, rest) = two_sum(d.hi, self.0.lo);
        let (hi, lo) = two_sum(self.0.hi, y);
        self.0 = Pair { hi, lo: lo + (rest + d.lo) };
    }
}

impl<S: Accumulate> Vector<S> {
    /// Adds an increment.
    #[inline(always)]
    pub fn accumulate(&mut self, d: Vector<S::Real>) {
        self.x.add(d.x);
        self.y.add(d.y);
        self.z.add(d.z);
    }

    /// Adds an increment with its remainder.
    #[inline(always)]
    pub fn accumulate_pair(&mut self, d: Vector<Pair<S::Real>>) {
        self.x.add_pair(d.x);
        self.y.add_pair(d.y);
        self.z.add_pair(d.z);
    }

    /// What a product with a fraction of a pair owes to the remainders of both.
    #[inline(always)]
    pub fn low_product(&self, factor: Pair<S::Real>, fraction: S::Real) -> Vector<S::Real> {
        let (hi, lo) = (factor.hi * fraction, factor.lo * fraction);
        let low = |s: S| s.remainder() * hi + s.value() * lo;
        Vector { x: low(self.x), y: low(self.y), z: low(self.z) }
    }

    /// With what is known of the remainders.
    #[inline(always)]
    pub fn pair(&self) -> Vector<Pair<S::Real>> {
        Vector { x: self.x.pair(), y: self.y.pair(), z: self.z.pair() }
    }

    /// The leading parts.
    #[inline(always)]
    pub fn value(&self) -> Vector<S::Real> {
        Vector::new(self.x.value(), self.y.value(), self.z.value())
    }
}

impl<S: Accumulate> Quaternion<S> {
    /// Adds an increment.
    #[inline(always)]
    pub fn accumulate(&mut self, d: Quaternion<S::Real>) {
        self.w.add(d.w);
        self.v.accumulate(d.v);
    }

    /// Adds an increment with its remainder.
    #[inline(always)]
    pub fn accumulate_pair(&mut self, d: Quaternion<Pair<S::Real>>) {
        self.w.add_pair(d.w);
        self.v.accumulate_pair(d.v);
    }

    /// With what is known of the remainders.
    #[inline(always)]
    pub fn pair(&self) -> Quaternion<Pair<S::Real>> {
        Quaternion { w: self.w.pair(), v: self.v.pair() }
    }

    /// The leading parts.
    #[inline(always)]
    pub fn value(&self) -> Quaternion<S::Real> {
        Quaternion::new(self.w.value(), self.v.value())
    }
}
