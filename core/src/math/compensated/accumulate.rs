//! How state variables are summed: plainly, with compensation, or with two-float increments.

use super::super::quaternion::Quaternion;
use super::super::real::Real;
use super::super::vector::Vector;
use super::{Pair, two_sum};

/// How a state variable is summed: the type decides about compensation.
pub trait Accumulate: Send + Copy {
    /// The scalar that it sums.
    type Real: Real;
    /// From a number and its remainder.
    fn from_pair(x: Pair<Self::Real>) -> Self;
    /// With the remainder, as far as it is known.
    fn pair(self) -> Pair<Self::Real>;
    /// The leading part: what products read.
    fn value(self) -> Self::Real;
    /// The trailing part.
    fn remainder(self) -> Self::Real;
    /// Whether the products that matter are carried to twice the digits as well.
    const TWO_FLOAT: bool = false;
    /// `yes` where the mask holds, else `no`, to the last bit.
    #[inline(always)]
    fn select(mask: <Self::Real as Real>::Mask, yes: Self, no: Self) -> Self {
        let (yes, no) = (yes.pair(), no.pair());
        Self::from_pair(Pair {
            hi: Real::select(mask, yes.hi, no.hi),
            lo: Real::select(mask, yes.lo, no.lo),
        })
    }
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

/// A compensated sum whose increments have remainders of their own: `f32` navigation to millimetres.
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

    /// What the remainders of both factors contribute to the product with a fraction of a pair.
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

/// By how much |q|² may differ from 1 before an attitude is normalised: some ulps, so that rounding alone
/// does not count, and a flight that hardly turns keeps its bits.
fn longest_excess<R: Real>() -> R {
    R::entry(2e-6, 4e-15)
}

impl<S: Accumulate> Quaternion<S> {
    /// Brings an attitude back to unit length when the rounding of many turns has accumulated.
    #[inline(always)]
    pub fn keep_unit(&mut self) {
        let q = self.value();
        let excess = q.dot(q) - S::Real::ONE;
        let long = longest_excess::<S::Real>().less(excess.abs());
        if S::Real::any(long) {
            // q ← q − ½q(|q|² − 1) where the mask holds
            let mut unit = *self;
            if S::TWO_FLOAT {
                unit.shorten();
            } else {
                unit.accumulate(q * (excess * -S::Real::HALF));
            }
            self.w = S::select(long, unit.w, self.w);
            self.v = unit.v.zip(self.v, |unit, q| S::select(long, unit, q));
        }
    }

    /// q ← q + ½q(1 − |q|²), |q|² to twice the digits.
    #[inline(never)]
    fn shorten(&mut self) {
        let q = self.pair();
        let square = q.w * q.w + q.v.dot(q.v);
        let half = (Pair::new(S::Real::ONE) - square) * Pair::new(S::Real::HALF);
        self.accumulate_pair(q * half);
    }

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
