//! Four words in a 256-bit register, or eight in one of 512 bits.

use super::Mask;
use crate::lanes::words::Words;
use std::arch::x86_64::*;
use std::ops::{Add, BitAnd, BitOr, BitXor};

/// A register of so many words, with its intrinsics.
macro_rules! register {
    ($(#[$doc:meta])* $name:ident, $register:ty, $n:literal,
     $up:ident $down:ident, $($op:ident $f:ident $intrinsic:ident),+) => {
        $(#[$doc])*
        #[derive(Clone, Copy)]
        pub struct $name(pub(super) $register);

        operators!($name: $($op $f $intrinsic),+);

        impl Words<$n> for $name {
            #[inline(always)]
            fn from_lanes(lanes: [u64; $n]) -> Self {
                // SAFETY: so many words and their register have the same size, and any bits are valid.
                Self(unsafe { std::mem::transmute::<[u64; $n], $register>(lanes) })
            }
            #[inline(always)]
            fn lanes(self) -> [u64; $n] {
                // SAFETY: as in `from_lanes`.
                unsafe { std::mem::transmute::<$register, [u64; $n]>(self.0) }
            }
            #[inline(always)]
            fn up(self, places: u64) -> Self {
                Self(call!($up(self.0, Self::all(places).0)))
            }
            #[inline(always)]
            fn down(self, places: u64) -> Self {
                Self(call!($down(self.0, Self::all(places).0)))
            }
        }
    };
}

register! {
    /// Four words.
    Avx2, __m256i, 4, _mm256_sllv_epi64 _mm256_srlv_epi64,
    Add add _mm256_add_epi64, BitAnd bitand _mm256_and_si256, BitOr bitor _mm256_or_si256,
    BitXor bitxor _mm256_xor_si256
}

register! {
    /// Eight words.
    Avx512, __m512i, 8, _mm512_sllv_epi64 _mm512_srlv_epi64,
    Add add _mm512_add_epi64, BitAnd bitand _mm512_and_si512, BitOr bitor _mm512_or_si512,
    BitXor bitxor _mm512_xor_si512
}

impl Avx2 {
    /// The nearest numbers to words below 2⁶³.
    #[inline(always)]
    pub(super) fn nearest(self) -> __m256d {
        // 2⁸⁴ + 2³²h and 2⁵² + l, with the halves h and l in place of their last digits: exact but for the
        // last sum.
        const HIGH: f64 = (1u128 << 84) as f64;
        const LOW: f64 = (1u64 << 52) as f64;
        let high = self.down(32) | Self::all(HIGH.to_bits());
        let low = (self & Self::all(0xffff_ffff)) | Self::all(LOW.to_bits());
        let both = Self::all((HIGH + LOW).to_bits());
        let high = call!(_mm256_castsi256_pd(high.0));
        let high = call!(_mm256_sub_pd(high, _mm256_castsi256_pd(both.0)));
        call!(_mm256_add_pd(high, _mm256_castsi256_pd(low.0)))
    }

    /// Which words, all below 2⁶³, exceed a bound.
    #[inline(always)]
    pub(super) fn beyond(self, bound: i64) -> Mask {
        let beyond = call!(_mm256_cmpgt_epi64(self.0, Self::all(bound as u64).0));
        Mask(call!(_mm256_castsi256_pd(beyond)))
    }
}

impl Avx512 {
    /// The nearest numbers to words below 2⁶³.
    #[inline(always)]
    pub(super) fn nearest(self) -> __m512d {
        call!(_mm512_cvtepi64_pd(self.0))
    }

    /// Which words, all below 2⁶³, exceed a bound.
    #[inline(always)]
    pub(super) fn beyond(self, bound: i64) -> __mmask8 {
        let bound = Self::all(bound as u64);
        call!(_mm512_cmpgt_epi64_mask(self.0, bound.0))
    }
}
