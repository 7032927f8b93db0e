//! `Coarse`: single precision with micromath's fast, rough functions.
//!
//! A sine is accurate to about 1e-3 and a square root to a few per cent: for comparison with the other types, not
//! for navigation. Sums, products and quotients are those of `f32`.
//!
//! ```
//! use schuler::math::coarse::Coarse;
//! use schuler::math::real::Real;
//!
//! let (sine, cosine) = Coarse(0.5).sin_cos();
//! assert!((sine.0 - 0.479_425_5).abs() < 2e-3 && (cosine.0 - 0.877_582_6).abs() < 2e-3);
//! assert_eq!(Coarse(0.5) + Coarse(0.25), Coarse(0.75));
//! ```

use super::real::{Real, Scalar};
use super::twin::Both;
use crate::{one_number, wrapped_constants, wrapped_operators};
use micromath::F32Ext;

/// A single-precision number whose functions are micromath's.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Coarse(pub f32);

wrapped_operators!(Coarse);

impl Real for Coarse {
    one_number!();
    type Twin = Both<Self>;
    wrapped_constants!(f32, Self);

    #[inline(always)]
    fn of(literal: f64) -> Self {
        Self(literal as f32)
    }
    #[inline(always)]
    fn residual(literal: f64) -> Self {
        Self(<f32 as Real>::residual(literal))
    }
    #[inline(always)]
    fn entry(single: f32, _: f64) -> Self {
        Self(single)
    }
    #[inline(always)]
    fn count(n: u32) -> Self {
        Self(n as f32)
    }
    fn ratio(numerator: i128, denominator: i128) -> Self {
        Self(<f32 as Real>::ratio(numerator, denominator))
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(F32Ext::sqrt(self.0))
    }
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        (Self(F32Ext::sin(self.0)), Self(F32Ext::cos(self.0)))
    }
    #[inline]
    fn atan2(self, x: Self) -> Self {
        Self(F32Ext::atan2(self.0, x.0))
    }
    #[inline]
    fn exp_m1(self) -> Self {
        Self(F32Ext::exp(self.0) - 1.0)
    }
    #[inline]
    fn ln(self) -> Self {
        Self(F32Ext::ln(self.0))
    }
    #[inline]
    fn round(self) -> Self {
        Self(F32Ext::round(self.0))
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self(f32::abs(self.0))
    }
    #[inline(always)]
    fn upper_half(self) -> Self {
        Self(Real::upper_half(self.0))
    }
    #[inline(always)]
    fn is_within(self, bound: Self) -> bool {
        f32::abs(self.0) <= bound.0
    }
}

impl Scalar for Coarse {
    #[inline(always)]
    fn to_bits(self) -> u64 {
        self.0.to_bits().into()
    }
    #[inline(always)]
    fn from_bits(bits: u64) -> Self {
        Self(f32::from_bits(bits as u32))
    }
    #[inline(always)]
    fn widen(self) -> f64 {
        self.0.into()
    }
    #[inline(always)]
    fn narrow(x: f64) -> Self {
        Self(x as f32)
    }
}
