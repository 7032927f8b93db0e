//! Four numbers in a 256-bit register, or eight in one of 512 bits.

use super::drawn::{Deviates, Generator};
use super::pack::{LANE, Lanes, Task};
use super::{circle, logarithm, normal::Fill, sealed::Sealed, stream::LaneStream};
use schuler::math::real::Real;
use schuler::math::twin::Both;
use schuler::noise::Streams;
use schuler::noise::random::Random;
use schuler::record::Record;
use std::arch::x86_64::*;
use std::fmt;
use std::ops::{Add, BitOr, Div, Mul, Neg, Sub};

/// What `upper_half` keeps of an f64.
const UPPER_HALF: u64 = 0xffff_ffff_f800_0000;

/// Calls an intrinsic.
macro_rules! call {
    ($f:ident $(::<$c:ident>)? ($($x:expr),*)) => {
        // SAFETY: needs the registers of its type, which `in_registers` asked the processor for: no other
        // way leads here.
        unsafe { $f$(::<$c>)?($($x),*) }
    };
}

macro_rules! operators {
    ($name:ident: $($op:ident $f:ident $intrinsic:ident),+) => {
        $(impl $op for $name {
            type Output = Self;
            #[inline(always)]
            fn $f(self, b: Self) -> Self {
                Self(call!($intrinsic(self.0, b.0)))
            }
        })+
    };
}

mod words;

/// A register of so many numbers, with the processor's features and intrinsics for it; what compares
/// stands apart, since masks differ.
macro_rules! register {
    ($(#[$doc:meta])* $name:ident, $register:ty, $mask:ty, $words:path, $n:literal, $features:literal,
     $add:ident $sub:ident $mul:ident $div:ident $sqrt:ident $xor:ident $and:ident $and_not:ident
     $round:ident $to_words:ident $from_words:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy)]
        pub(super) struct $name($register);

        impl $name {
            /// Also at compile time; an array has the register's bytes.
            #[inline(always)]
            const fn all(x: f64) -> Self {
                // SAFETY: so many f64 and their register have the same size, and any bits are valid.
                Self(unsafe { std::mem::transmute::<[f64; $n], $register>([x; $n]) })
            }
        }

        impl Sealed for $name {}

        impl Lanes<$n> for $name {
            type Words = $words;

            #[inline(always)]
            fn from_lanes(lanes: [f64; $n]) -> Self {
                // SAFETY: as in `all`.
                Self(unsafe { std::mem::transmute::<[f64; $n], $register>(lanes) })
            }
            #[inline(always)]
            fn lanes(self) -> [f64; $n] {
                // SAFETY: as in `all`.
                unsafe { std::mem::transmute::<$register, [f64; $n]>(self.0) }
            }
            #[inline(always)]
            fn from_bits(bits: $words) -> Self {
                Self(call!($from_words(bits.0)))
            }
            #[inline(always)]
            fn to_bits(self) -> $words {
                $words(call!($to_words(self.0)))
            }
            #[inline(always)]
            fn nearest(words: $words) -> Self {
                Self(words.nearest())
            }
            #[inline(always)]
            fn beyond(words: $words, bound: i64) -> $mask {
                words.beyond(bound)
            }
            #[inline(always)]
            fn marks(mask: $mask) -> u32 {
                Self::bits(mask) as u32
            }
            fn fill(generator: &mut Generator<$n>, deviates: &mut Deviates) {
                Self::compiled(Fill::<Self, $n>::new(generator, deviates));
            }
            #[inline(always)]
            fn compiled<T: Task>(task: T) -> T::Output {
                #[target_feature(enable = $features)]
                fn here<T: Task>(task: T) -> T::Output {
                    task.run()
                }
                // SAFETY: it needs these features alone, which `Registers::are_there` asked for.
                unsafe { here(task) }
            }
        }

        impl Random for $name {
            type Stream = LaneStream<$n>;

            fn open(place: Streams) -> Self::Stream {
                LaneStream::open(place)
            }
            #[inline(always)]
            fn deviate(stream: &mut Self::Stream) -> Self {
                stream.next()
            }
        }

        impl Record for $name {
            fn record(&self, _: &'static str, read: &mut impl FnMut(&'static str, u64)) {
                self.lanes().record(LANE, read);
            }
            fn restore(
                &mut self,
                _: &'static str,
                write: &mut impl FnMut(&'static str, u64) -> u64,
            ) {
                let mut lanes = self.lanes();
                lanes.restore(LANE, write);
                *self = Self::from_lanes(lanes);
            }
        }

        impl Default for $name {
            #[inline(always)]
            fn default() -> Self {
                Self::all(0.0)
            }
        }

        impl fmt::Debug for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                self.lanes().fmt(f)
            }
        }

        operators!($name: Add add $add, Sub sub $sub, Mul mul $mul, Div div $div);

        impl Neg for $name {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                Self(call!($xor(self.0, Self::all(-0.0).0)))
            }
        }

        impl Real for $name {
            type Mask = $mask;
            type Twin = Both<Self>;
            schuler::math::real::wrapped_constants!(f64, Self::all);

            #[inline(always)]
            fn residual(literal: f64) -> Self {
                Self::of(f64::residual(literal))
            }
            #[inline(always)]
            fn entry(single: f32, double: f64) -> Self {
                Self::of(f64::entry(single, double))
            }
            #[inline(always)]
            fn count(n: u32) -> Self {
                Self::of(f64::count(n))
            }
            fn ratio(numerator: i128, denominator: i128) -> Self {
                Self::of(f64::ratio(numerator, denominator))
            }
            #[inline(always)]
            fn sin_cos(self) -> (Self, Self) {
                circle::sin_cos(self)
            }
            fn atan2(self, x: Self) -> Self {
                let (y, x) = (self.lanes(), x.lanes());
                Self::from_lanes(std::array::from_fn(|run| Real::atan2(y[run], x[run])))
            }
            fn exp_m1(self) -> Self {
                Self::from_lanes(self.lanes().map(Real::exp_m1))
            }
            #[inline(always)]
            fn ln(self) -> Self {
                logarithm::ln(self)
            }
            #[inline(always)]
            fn round(self) -> Self {
                // To nearest, halves to even, no exception raised.
                const HOW: i32 = _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC;
                Self(call!($round::<HOW>(self.0)))
            }
            #[inline(always)]
            fn of(literal: f64) -> Self {
                Self::all(literal)
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                Self(call!($sqrt(self.0)))
            }
            #[inline(always)]
            fn abs(self) -> Self {
                Self(call!($and_not(Self::all(-0.0).0, self.0)))
            }
            #[inline(always)]
            fn upper_half(self) -> Self {
                let mask = Self::all(f64::from_bits(UPPER_HALF));
                Self(call!($and(self.0, mask.0)))
            }
            #[inline(always)]
            fn less(self, other: Self) -> $mask {
                self.compared::<_CMP_LT_OQ>(other)
            }
            #[inline(always)]
            fn select(mask: $mask, yes: Self, no: Self) -> Self {
                Self::blended(mask, yes, no)
            }
            #[inline(always)]
            fn any(mask: $mask) -> bool {
                Self::bits(mask) != 0
            }
            #[inline(always)]
            fn is_within(self, bound: Self) -> bool {
                Self::bits(self.abs().compared::<_CMP_LE_OQ>(bound)) == (1 << $n) - 1
            }
        }
    };
}

register! {
    /// Four numbers in an AVX register. Nobody gets one but by `in_registers`, which asks the processor.
    Avx2, __m256d, Mask, words::Avx2, 4, "avx2",
    _mm256_add_pd _mm256_sub_pd _mm256_mul_pd _mm256_div_pd _mm256_sqrt_pd
    _mm256_xor_pd _mm256_and_pd _mm256_andnot_pd
    _mm256_round_pd _mm256_castpd_si256 _mm256_castsi256_pd
}

/// All bits of a lane, or none.
#[derive(Clone, Copy)]
pub(super) struct Mask(__m256d);

impl BitOr for Mask {
    type Output = Self;
    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        Self(call!(_mm256_or_pd(self.0, other.0)))
    }
}

impl Avx2 {
    /// Compares lane by lane.
    #[inline(always)]
    fn compared<const HOW: i32>(self, other: Self) -> Mask {
        Mask(call!(_mm256_cmp_pd::<HOW>(self.0, other.0)))
    }
    /// `yes` where the mask holds, else `no`.
    #[inline(always)]
    fn blended(mask: Mask, yes: Self, no: Self) -> Self {
        Self(call!(_mm256_blendv_pd(no.0, yes.0, mask.0)))
    }
    /// A bit for each lane.
    #[inline(always)]
    fn bits(mask: Mask) -> i32 {
        call!(_mm256_movemask_pd(mask.0))
    }
}

register! {
    /// Eight numbers in an AVX-512 register. Nobody gets one but by `in_registers`, which asks the processor.
    Avx512, __m512d, __mmask8, words::Avx512, 8, "avx512f,avx512dq,avx512vl",
    _mm512_add_pd _mm512_sub_pd _mm512_mul_pd _mm512_div_pd _mm512_sqrt_pd
    _mm512_xor_pd _mm512_and_pd _mm512_andnot_pd
    _mm512_roundscale_pd _mm512_castpd_si512 _mm512_castsi512_pd
}

impl Avx512 {
    /// Compares lane by lane.
    #[inline(always)]
    fn compared<const HOW: i32>(self, other: Self) -> __mmask8 {
        call!(_mm512_cmp_pd_mask::<HOW>(self.0, other.0))
    }
    /// `yes` where the mask holds, else `no`.
    #[inline(always)]
    fn blended(mask: __mmask8, yes: Self, no: Self) -> Self {
        Self(call!(_mm512_mask_blend_pd(mask, no.0, yes.0)))
    }
    /// A bit for each lane.
    #[inline(always)]
    fn bits(mask: __mmask8) -> i32 {
        mask.into()
    }
}
