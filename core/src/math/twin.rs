//! Two numbers side by side: the same operation on both is one vector instruction.
//!
//! Only the grouping differs from two scalars; every operation and its result are the same, bit for bit.
//!
//! ```
//! use schuler::math::real::Twin;
//! use schuler::math::twin::Both;
//!
//! let sum = Both(1.0_f32, 2.0) + Both::both(0.5);
//! assert_eq!(sum.parts(), (1.5, 2.5));
//! ```

use super::real::{Real, Twin};
use core::ops::{Add, Mul, Neg, Sub};

/// Two scalars.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Both<R>(pub R, pub R);

impl<R: Real + core::fmt::Debug> Twin<R> for Both<R> {
    const IN_REGISTER: bool = false;

    #[inline(always)]
    fn new(a: R, b: R) -> Self {
        Self(a, b)
    }
    #[inline(always)]
    fn parts(self) -> (R, R) {
        (self.0, self.1)
    }
    #[inline(always)]
    fn all_within(values: [Self; 3], bounds: [Self; 3]) -> bool {
        let [a, b, c] = values;
        let [p, q, r] = bounds;
        a.is_within(p) & b.is_within(q) & c.is_within(r)
    }
}

impl<R: Real> Both<R> {
    #[inline(always)]
    fn is_within(self, bound: Self) -> bool {
        self.0.is_within(bound.0) & self.1.is_within(bound.1)
    }
}

macro_rules! by_parts {
    ($($op:ident $f:ident),+) => {
        $(impl<R: Real> $op for Both<R> {
            type Output = Self;
            #[inline(always)]
            fn $f(self, b: Self) -> Self {
                Self($op::$f(self.0, b.0), $op::$f(self.1, b.1))
            }
        })+
    };
}

by_parts!(Add add, Sub sub, Mul mul);

impl<R: Real> Neg for Both<R> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0, -self.1)
    }
}

/// Two doubles: one vector register on a host, with the standard library.
#[cfg(feature = "std")]
pub type DoubleTwin = wide::f64x2;
/// Two doubles.
#[cfg(not(feature = "std"))]
pub type DoubleTwin = Both<f64>;

/// Two singles: half a register.
#[cfg(feature = "std")]
pub type SingleTwin = wide::f32x4;
/// Two singles.
#[cfg(not(feature = "std"))]
pub type SingleTwin = Both<f32>;

/// Two numbers in a register, with values to fill the rest of it.
#[cfg(feature = "std")]
macro_rules! in_register {
    ($twin:ty, $real:ty $(, $rest:literal)*) => {
        impl Twin<$real> for $twin {
            const IN_REGISTER: bool = true;

            #[inline(always)]
            fn new(a: $real, b: $real) -> Self {
                Self::new([a, b $(, $rest)*])
            }
            #[inline(always)]
            fn parts(self) -> ($real, $real) {
                let [a, b, ..] = self.to_array();
                (a, b)
            }
            #[inline(always)]
            fn all_within(values: [Self; 3], bounds: [Self; 3]) -> bool {
                let [a, b, c] = values;
                let [p, q, r] = bounds;
                (a.abs().simd_le(p) & b.abs().simd_le(q) & c.abs().simd_le(r)).all()
            }
        }
    };
}

#[cfg(feature = "std")]
in_register!(DoubleTwin, f64);
#[cfg(feature = "std")]
in_register!(SingleTwin, f32, 0.0, 0.0);
