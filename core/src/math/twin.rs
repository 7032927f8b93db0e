//! Two numbers side by side: what goes through the same operations shares a vector instruction.
//!
//! Only the grouping differs from two scalars; every operation and its bits are the same.

use super::real::Real;
use core::ops::{Add, Mul, Neg, Sub};

/// Two numbers side by side.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Twin<R>(pub R, pub R);

impl<R: Real> Twin<R> {
    /// Zeros.
    pub const ZERO: Self = Self(R::ZERO, R::ZERO);

    /// The same number twice.
    #[inline(always)]
    pub fn both(x: R) -> Self {
        Self(x, x)
    }

    /// (a, b) times i: (−b, a).
    #[inline(always)]
    pub fn quarter_turn(self) -> Self {
        Self(-self.1, self.0)
    }
}

impl<R: Real> Add for Twin<R> {
    type Output = Self;
    #[inline(always)]
    fn add(self, b: Self) -> Self {
        Self(self.0 + b.0, self.1 + b.1)
    }
}

impl<R: Real> Sub for Twin<R> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, b: Self) -> Self {
        Self(self.0 - b.0, self.1 - b.1)
    }
}

impl<R: Real> Mul for Twin<R> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, b: Self) -> Self {
        Self(self.0 * b.0, self.1 * b.1)
    }
}

impl<R: Real> Neg for Twin<R> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0, -self.1)
    }
}
