//! `Real`: the one seam between the algorithms and a floating-point type.
//!
//! Every algorithm is written once, for `f32`, `f64`, a pack of independent runs or a test scalar.
//! None branches on a value: comparisons give a mask, and `select` chooses lane by lane.
//! IEEE 754 determines the bits of + − × ÷ √ everywhere; other functions are libm's (`scalar`).
//!
//! ```
//! use schuler::math::real::Real;
//!
//! fn hypotenuse<R: Real>(a: R, b: R) -> R {
//!     (a * a + b * b).sqrt()
//! }
//! assert_eq!(hypotenuse(3.0_f32, 4.0), 5.0);
//! assert_eq!(hypotenuse(3.0_f64, 4.0), 5.0);
//! ```

use core::ops::{Add, BitOr, Div, Mul, Neg, Sub};

/// Types with + − ×: enough for vectors and quaternions.
pub trait Number:
    Copy + Default + Neg<Output = Self> + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self>
{
}

impl<T> Number for T where
    T: Copy + Default + Neg<Output = T> + Add<Output = T> + Sub<Output = T> + Mul<Output = T>
{
}

/// A real scalar: one number, or a pack of numbers of independent runs that share instructions.
pub trait Real: Number + Div<Output = Self> + Send + 'static {
    /// The result of a comparison: `bool`, or one per lane.
    type Mask: Copy + BitOr<Output = Self::Mask>;
    /// Two numbers that go through the same operations side by side.
    type Twin: Twin<Self>;

    /// 0.
    const ZERO: Self;
    /// 1.
    const ONE: Self;
    /// 2.
    const TWO: Self;
    /// ½.
    const HALF: Self;
    /// 1/n at index n, so that no loop converts or divides at run time; entry 0 is 0.
    const INVERSE: [Self; 28];

    /// A literal of the source text, rounded to this type; the compiler folds it.
    fn of(literal: f64) -> Self;
    /// The part of `literal` that [`Real::of`] rounds away, itself rounded: 0 in double precision.
    fn residual(literal: f64) -> Self;
    /// One of two roundings of a table's entry.
    fn entry(single: f32, double: f64) -> Self;
    /// A small count, exactly.
    fn count(n: u32) -> Self;
    /// A ratio of two integers.
    fn ratio(numerator: i128, denominator: i128) -> Self;

    /// √x, correctly rounded.
    fn sqrt(self) -> Self;
    /// Sine and cosine of an angle in radians.
    fn sin_cos(self) -> (Self, Self);
    /// The angle of the point (x, self), in (−π, π].
    fn atan2(self, x: Self) -> Self;
    /// e^x − 1.
    fn exp_m1(self) -> Self;
    /// The natural logarithm.
    fn ln(self) -> Self;
    /// The nearest integer, halves to even.
    fn round(self) -> Self;
    /// |x|.
    fn abs(self) -> Self;
    /// The upper half of the significand: products of two such halves are exact.
    fn upper_half(self) -> Self;

    /// self < other.
    fn less(self, other: Self) -> Self::Mask;
    /// `yes` where the mask holds, else `no`.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
    /// Whether the mask holds anywhere.
    fn any(mask: Self::Mask) -> bool;
    /// Finite and |x| ≤ bound, in every lane.
    fn is_within(self, bound: Self) -> bool;
}

/// Two numbers side by side.
pub trait Twin<R>: Number + core::fmt::Debug {
    /// Whether they share a vector register; on such processors long code is no disadvantage.
    const IN_REGISTER: bool;

    /// From the two.
    fn new(a: R, b: R) -> Self;
    /// The two.
    fn parts(self) -> (R, R);

    /// Whether every number of three twins is finite and within ± its bound.
    fn all_within(values: [Self; 3], bounds: [Self; 3]) -> bool;

    /// The same number twice.
    #[inline(always)]
    fn both(x: R) -> Self
    where
        R: Copy,
    {
        Self::new(x, x)
    }

    /// (a, b) times i: (−b, a).
    #[inline(always)]
    fn quarter_turn(self) -> Self
    where
        R: Real,
    {
        let (a, b) = self.parts();
        Self::new(-b, a)
    }
}

/// A `Real` that is a single number, with a bit pattern.
pub trait Scalar: Real + PartialOrd {
    /// The bits, in the low end of a word.
    fn to_bits(self) -> u64;
    /// Back from [`Scalar::to_bits`].
    fn from_bits(bits: u64) -> Self;
    /// The same number in double precision: exact.
    fn widen(self) -> f64;
    /// The nearest number of this type.
    fn narrow(x: f64) -> Self;
}

#[doc(hidden)]
#[macro_export]
macro_rules! wrapped_constants {
    ($inner:ty, $wrap:path) => {
        const ZERO: Self = $wrap(<$inner as $crate::math::real::Real>::ZERO);
        const ONE: Self = $wrap(<$inner as $crate::math::real::Real>::ONE);
        const TWO: Self = $wrap(<$inner as $crate::math::real::Real>::TWO);
        const HALF: Self = $wrap(<$inner as $crate::math::real::Real>::HALF);
        #[allow(
            clippy::indexing_slicing,
            reason = "the compiler alone evaluates it, and stops at an index out of range"
        )]
        const INVERSE: [Self; 28] = {
            let mut table = [$wrap(<$inner as $crate::math::real::Real>::ZERO); 28];
            let mut n = 1;
            while n < 28 {
                table[n] = $wrap(<$inner as $crate::math::real::Real>::INVERSE[n]);
                n += 1;
            }
            table
        };
    };
}

/// The comparisons of a [`Real`] that is one number.
#[doc(hidden)]
#[macro_export]
macro_rules! one_number {
    () => {
        type Mask = bool;

        #[inline(always)]
        fn less(self, other: Self) -> bool {
            self < other
        }
        #[inline(always)]
        fn select(mask: bool, yes: Self, no: Self) -> Self {
            if mask { yes } else { no }
        }
        #[inline(always)]
        fn any(mask: bool) -> bool {
            mask
        }
    };
}

#[doc(hidden)]
#[macro_export]
macro_rules! wrapped_operators {
    ($wrap:ident) => {
        $crate::wrapped_operators!($wrap: Add add, Sub sub, Mul mul, Div div);
        impl core::ops::Neg for $wrap {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                Self(-self.0)
            }
        }
    };
    ($wrap:ident: $($op:ident $f:ident),+) => {
        $(impl core::ops::$op for $wrap {
            type Output = Self;
            #[inline(always)]
            fn $f(self, b: Self) -> Self {
                Self(core::ops::$op::$f(self.0, b.0))
            }
        })+
    };
}

/// The type of masks and the comparisons of a [`Real`] that is a single number: `one_number!()` within the
/// implementation.
#[doc(inline)]
pub use one_number;

/// The constants of a [`Real`] that is made of another one: `wrapped_constants!(f32, Self)` within the
/// implementation, with the type inside and the constant function or constructor that wraps it.
#[doc(inline)]
pub use wrapped_constants;

/// The arithmetic of a number that wraps another one: `wrapped_operators!(Coarse)` beside its type.
#[doc(inline)]
pub use wrapped_operators;
