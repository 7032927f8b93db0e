//! One run as a pack: the bits of `f64`, and random numbers that are made many at a time in lanes.

use super::drawn::{Deviates, Generator};
use super::normal::{draw, transform_any};
use super::pack::{Lanes, Task};
use super::sealed::Sealed;
use super::stream::LaneStream;
use super::words::Words;
use schuler::math::real::{Real, one_number, wrapped_constants, wrapped_operators};
use schuler::math::twin::Both;
use schuler::noise::Streams;
use schuler::noise::random::Random;
use schuler::record::Record;
use std::ops::{Add, BitAnd, BitOr, BitXor};

/// A number of one run.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct One(pub f64);

wrapped_operators!(One);

impl Real for One {
    one_number!();
    type Twin = Both<Self>;
    wrapped_constants!(f64, Self);

    #[inline(always)]
    fn of(literal: f64) -> Self {
        Self(literal)
    }
    #[inline(always)]
    fn residual(literal: f64) -> Self {
        Self(f64::residual(literal))
    }
    #[inline(always)]
    fn entry(single: f32, double: f64) -> Self {
        Self(f64::entry(single, double))
    }
    #[inline(always)]
    fn count(n: u32) -> Self {
        Self(f64::count(n))
    }
    fn ratio(numerator: i128, denominator: i128) -> Self {
        Self(f64::ratio(numerator, denominator))
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(Real::sqrt(self.0))
    }
    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = Real::sin_cos(self.0);
        (Self(sine), Self(cosine))
    }
    fn atan2(self, x: Self) -> Self {
        Self(Real::atan2(self.0, x.0))
    }
    fn exp_m1(self) -> Self {
        Self(Real::exp_m1(self.0))
    }
    fn ln(self) -> Self {
        Self(Real::ln(self.0))
    }
    #[inline]
    fn round(self) -> Self {
        Self(Real::round(self.0))
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self(Real::abs(self.0))
    }
    #[inline(always)]
    fn upper_half(self) -> Self {
        Self(Real::upper_half(self.0))
    }
    #[inline(always)]
    fn is_within(self, bound: Self) -> bool {
        Real::is_within(self.0, bound.0)
    }
}

impl Record for One {
    fn record(&self, name: &'static str, read: &mut impl FnMut(&'static str, u64)) {
        self.0.record(name, read);
    }
    fn restore(&mut self, name: &'static str, write: &mut impl FnMut(&'static str, u64) -> u64) {
        self.0.restore(name, write);
    }
}

impl Random for One {
    type Stream = LaneStream<1>;

    fn open(place: Streams) -> Self::Stream {
        LaneStream::open(place)
    }
    #[inline(always)]
    fn deviate(stream: &mut Self::Stream) -> Self {
        stream.next()
    }
}

impl Sealed for One {}

impl Lanes<1> for One {
    type Words = Word;

    #[inline(always)]
    fn from_lanes([x]: [f64; 1]) -> Self {
        Self(x)
    }
    #[inline(always)]
    fn lanes(self) -> [f64; 1] {
        [self.0]
    }
    #[inline(always)]
    fn from_bits(Word(bits): Word) -> Self {
        Self(f64::from_bits(bits))
    }
    #[inline(always)]
    fn to_bits(self) -> Word {
        Word(self.0.to_bits())
    }
    #[inline(always)]
    fn nearest(Word(word): Word) -> Self {
        Self(word as i64 as f64)
    }
    #[inline(always)]
    fn beyond(Word(word): Word, bound: i64) -> bool {
        word as i64 > bound
    }
    #[inline(always)]
    fn marks(mask: bool) -> u32 {
        mask.into()
    }
    #[inline(always)]
    fn compiled<T: Task>(task: T) -> T::Output {
        task.run()
    }
    fn fill(generator: &mut Generator<1>, deviates: &mut Deviates) {
        transform_any(&draw::<Self, 1>(generator), deviates);
    }
}

/// A word of one run.
#[derive(Clone, Copy)]
pub struct Word(u64);

macro_rules! on_words {
    ($($op:ident $f:ident $wrapping:path),+) => {
        $(impl $op for Word {
            type Output = Self;
            #[inline(always)]
            fn $f(self, b: Self) -> Self {
                Self($wrapping(self.0, b.0))
            }
        })+
    };
}

on_words!(
    Add add u64::wrapping_add,
    BitAnd bitand BitAnd::bitand,
    BitOr bitor BitOr::bitor,
    BitXor bitxor BitXor::bitxor
);

impl Words<1> for Word {
    #[inline(always)]
    fn from_lanes([word]: [u64; 1]) -> Self {
        Self(word)
    }
    #[inline(always)]
    fn lanes(self) -> [u64; 1] {
        [self.0]
    }
    #[inline(always)]
    fn up(self, places: u64) -> Self {
        Self(self.0 << places)
    }
    #[inline(always)]
    fn down(self, places: u64) -> Self {
        Self(self.0 >> places)
    }
}
