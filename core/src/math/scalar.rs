//! `f32` and `f64` as scalars.
//!
//! This file is the only one that calls a transcendental function: libm's, so that the bits do not depend
//! on the platform.

use super::real::{Real, Scalar};
use super::twin::{DoubleTwin, SingleTwin};
use crate::one_number;

#[cfg(feature = "std")]
extern crate std;

macro_rules! inverse {
    ($t:ty) => {{
        let mut table = [0.0 as $t; 28];
        let mut n = 1;
        while n < 28 {
            table[n] = 1.0 / n as $t;
            n += 1;
        }
        table
    }};
}

macro_rules! scalar {
    ($t:ident, $mask:expr, $sin_cos:path, $atan2:path, $expm1:path, $ln:path, $rint:path, $sqrt:path,
     $residual:expr, $entry:expr, $twin:ty) => {
        impl Real for $t {
            one_number!();
            type Twin = $twin;
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const TWO: Self = 2.0;
            const HALF: Self = 0.5;
            #[expect(
                clippy::indexing_slicing,
                reason = "the compiler alone evaluates it, and stops at an index out of range"
            )]
            const INVERSE: [Self; 28] = inverse!($t);

            #[inline(always)]
            fn of(literal: f64) -> Self {
                literal as $t
            }
            #[inline(always)]
            fn residual(literal: f64) -> Self {
                $residual(literal)
            }
            #[inline(always)]
            fn entry(single: f32, double: f64) -> Self {
                $entry(single, double)
            }
            #[inline(always)]
            fn count(n: u32) -> Self {
                n as $t
            }
            fn ratio(numerator: i128, denominator: i128) -> Self {
                numerator as $t / denominator as $t
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                // Both are correctly rounded; that of the standard library is one instruction.
                #[cfg(feature = "std")]
                return $t::sqrt(self);
                #[cfg(not(feature = "std"))]
                return $sqrt(self);
            }
            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                $sin_cos(self)
            }
            #[inline]
            fn atan2(self, x: Self) -> Self {
                $atan2(self, x)
            }
            #[inline]
            fn exp_m1(self) -> Self {
                $expm1(self)
            }
            #[inline]
            fn ln(self) -> Self {
                $ln(self)
            }
            #[inline]
            fn round(self) -> Self {
                $rint(self)
            }
            #[inline(always)]
            fn abs(self) -> Self {
                $t::abs(self)
            }
            #[inline(always)]
            fn upper_half(self) -> Self {
                $t::from_bits($t::to_bits(self) & $mask)
            }
            #[inline(always)]
            fn is_within(self, bound: Self) -> bool {
                self.abs() <= bound
            }
        }

        impl Scalar for $t {
            #[inline(always)]
            fn to_bits(self) -> u64 {
                $t::to_bits(self).into()
            }
            #[inline(always)]
            fn from_bits(bits: u64) -> Self {
                $t::from_bits(bits as _)
            }
            #[inline(always)]
            fn widen(self) -> f64 {
                self.into()
            }
            #[inline(always)]
            fn narrow(x: f64) -> Self {
                x as $t
            }
        }
    };
}

scalar!(
    f64,
    0xffff_ffff_f800_0000,
    libm::sincos,
    libm::atan2,
    libm::expm1,
    libm::log,
    libm::rint,
    libm::sqrt,
    |_: f64| 0.0,
    |_: f32, double: f64| double,
    DoubleTwin
);
scalar!(
    f32,
    0xffff_f000,
    libm::sincosf,
    libm::atan2f,
    libm::expm1f,
    libm::logf,
    libm::rintf,
    libm::sqrtf,
    |literal: f64| (literal - literal as f32 as f64) as f32,
    |single: f32, _: f64| single,
    SingleTwin
);
