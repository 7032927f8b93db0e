//! Two numbers side by side: what goes through the same operations shares a vector instruction.
//!
//! Only the grouping differs from two scalars; every operation and its bits are the same.

use super::real::Real;
use core::ops::{Add, Mul, Sub};

/// Two numbers side by side.
pub trait Twin<R>:
    Copy + core::fmt::Debug + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self>
{
    /// From the two.
    fn new(a: R, b: R) -> Self;
    /// The two.
    fn parts(self) -> (R, R);

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

/// Two scalars.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Both<R>(pub R, pub R);

impl<R: Real + core::fmt::Debug> Twin<R> for Both<R> {
    #[inline(always)]
    fn new(a: R, b: R) -> Self {
        Self(a, b)
    }
    #[inline(always)]
    fn parts(self) -> (R, R) {
        (self.0, self.1)
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

/// Two doubles: one register where the standard library vouches for a host's vector unit.
#[cfg(feature = "std")]
pub type DoubleTwin = wide::f64x2;
/// Two doubles.
#[cfg(not(feature = "std"))]
pub type DoubleTwin = Both<f64>;

#[cfg(feature = "std")]
impl Twin<f64> for wide::f64x2 {
    #[inline(always)]
    fn new(a: f64, b: f64) -> Self {
        Self::new([a, b])
    }
    #[inline(always)]
    fn parts(self) -> (f64, f64) {
        let [a, b] = self.to_array();
        (a, b)
    }
}

/// Two singles: half a register.
#[cfg(feature = "std")]
pub type SingleTwin = wide::f32x4;
/// Two singles.
#[cfg(not(feature = "std"))]
pub type SingleTwin = Both<f32>;

#[cfg(feature = "std")]
impl Twin<f32> for wide::f32x4 {
    #[inline(always)]
    fn new(a: f32, b: f32) -> Self {
        Self::new([a, b, 0.0, 0.0])
    }
    #[inline(always)]
    fn parts(self) -> (f32, f32) {
        let [a, b, ..] = self.to_array();
        (a, b)
    }
}
