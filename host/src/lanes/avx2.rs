//! Four numbers in a 256-bit register.

use super::pack::{Lanes, RUNS, functions};
use super::sealed::Sealed;
use schuler::math::real::Real;
use schuler::math::twin::Both;
use std::arch::x86_64::*;
use std::fmt;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Four numbers in a 256-bit register. Nobody gets one but by `in_registers`, which asks the processor.
#[derive(Clone, Copy)]
pub(super) struct Avx2(__m256d);

/// What `upper_half` keeps of an f64.
const UPPER_HALF: u64 = 0xffff_ffff_f800_0000;

/// Calls an intrinsic.
macro_rules! call {
    ($f:ident $(::<$c:ident>)? ($($x:expr),*)) => {
        // SAFETY: needs AVX, which `in_registers` asked the processor for: no other way leads here.
        unsafe { $f$(::<$c>)?($($x),*) }
    };
}

impl Avx2 {
    /// At compile time; an array has the register's bytes.
    const fn all(x: f64) -> Self {
        // SAFETY: four f64 and a register of four f64 have the same size, and any bits are valid.
        Self(unsafe { std::mem::transmute::<[f64; RUNS], __m256d>([x; RUNS]) })
    }
}

impl Sealed for Avx2 {}

impl Lanes for Avx2 {
    const AVX2: bool = true;
    #[inline(always)]
    fn from_lanes(lanes: [f64; RUNS]) -> Self {
        // SAFETY: as in `all`.
        Self(unsafe { std::mem::transmute::<[f64; RUNS], __m256d>(lanes) })
    }
    #[inline(always)]
    fn lanes(self) -> [f64; RUNS] {
        // SAFETY: as in `all`.
        unsafe { std::mem::transmute::<__m256d, [f64; RUNS]>(self.0) }
    }
}

impl Default for Avx2 {
    #[inline(always)]
    fn default() -> Self {
        Self::all(0.0)
    }
}

impl fmt::Debug for Avx2 {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.lanes().fmt(f)
    }
}

macro_rules! operators {
    ($($op:ident $f:ident $intrinsic:ident),+) => {
        $(impl $op for Avx2 {
            type Output = Self;
            #[inline(always)]
            fn $f(self, b: Self) -> Self {
                Self(call!($intrinsic(self.0, b.0)))
            }
        })+
    };
}

operators!(Add add _mm256_add_pd, Sub sub _mm256_sub_pd, Mul mul _mm256_mul_pd, Div div _mm256_div_pd);

impl Neg for Avx2 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(call!(_mm256_xor_pd(self.0, Self::all(-0.0).0)))
    }
}

/// All bits of a lane, or none.
#[derive(Clone, Copy)]
pub(super) struct Mask(__m256d);

impl Real for Avx2 {
    type Mask = Mask;
    type Twin = Both<Self>;
    schuler::wrapped_constants!(f64, Self::all);

    functions!();

    #[inline(always)]
    fn of(literal: f64) -> Self {
        Self::all(literal)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(call!(_mm256_sqrt_pd(self.0)))
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self(call!(_mm256_andnot_pd(Self::all(-0.0).0, self.0)))
    }
    #[inline(always)]
    fn upper_half(self) -> Self {
        let mask = Self::all(f64::from_bits(UPPER_HALF));
        Self(call!(_mm256_and_pd(self.0, mask.0)))
    }
    #[inline(always)]
    fn less(self, other: Self) -> Mask {
        Mask(call!(_mm256_cmp_pd::<_CMP_LT_OQ>(self.0, other.0)))
    }
    #[inline(always)]
    fn select(mask: Mask, yes: Self, no: Self) -> Self {
        Self(call!(_mm256_blendv_pd(no.0, yes.0, mask.0)))
    }
    #[inline(always)]
    fn any(mask: Mask) -> bool {
        call!(_mm256_movemask_pd(mask.0)) != 0
    }
    #[inline(always)]
    fn is_within(self, bound: Self) -> bool {
        let within = call!(_mm256_cmp_pd::<_CMP_LE_OQ>(self.abs().0, bound.0));
        call!(_mm256_movemask_pd(within)) == 0b1111
    }
}
