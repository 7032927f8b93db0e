//! Four numbers, one of each run, that go through the same operations side by side.
//!
//! Every lane computes what a lone `f64` would, to the bit: IEEE 754 fixes the operations, and functions
//! are `f64`'s own. [`Four`] is what any machine has, `Avx2` a vector register.

use super::sealed::Sealed;
use schuler::math::real::Real;
use schuler::math::twin::Both;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// How many runs go side by side.
pub const RUNS: usize = 4;

/// A number of each run. Nobody else can have lanes: `AVX2` vouches for the processor.
pub trait Lanes: Real + Send + Sealed {
    /// From a number of each run.
    fn from_lanes(lanes: [f64; RUNS]) -> Self;
    /// The numbers of all runs.
    fn lanes(self) -> [f64; RUNS];
    /// Whether it is compiled for AVX2.
    const AVX2: bool;
}

/// Four numbers in memory.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Four([f64; RUNS]);

impl Four {
    const fn all(x: f64) -> Self {
        Self([x; RUNS])
    }

    #[inline(always)]
    fn each(self, b: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        let ([a0, a1, a2, a3], [b0, b1, b2, b3]) = (self.0, b.0);
        Self([f(a0, b0), f(a1, b1), f(a2, b2), f(a3, b3)])
    }
}

impl Sealed for Four {}

impl Lanes for Four {
    const AVX2: bool = false;
    #[inline(always)]
    fn from_lanes(lanes: [f64; RUNS]) -> Self {
        Self(lanes)
    }
    #[inline(always)]
    fn lanes(self) -> [f64; RUNS] {
        self.0
    }
}

macro_rules! operators {
    ($($op:ident $f:ident),+) => {
        $(impl $op for Four {
            type Output = Self;
            #[inline(always)]
            fn $f(self, b: Self) -> Self {
                self.each(b, $op::$f)
            }
        })+
    };
}

operators!(Add add, Sub sub, Mul mul, Div div);

impl Neg for Four {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.each(self, |x, _| -x)
    }
}

/// What both kinds do lane by lane in `f64`.
macro_rules! functions {
    () => {
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
        fn sin_cos(self) -> (Self, Self) {
            let both = self.lanes().map(Real::sin_cos);
            let part = |f: fn((f64, f64)) -> f64| Self::from_lanes(both.map(f));
            (part(|(sine, _)| sine), part(|(_, cosine)| cosine))
        }
        fn atan2(self, x: Self) -> Self {
            let (y, x) = (self.lanes(), x.lanes());
            Self::from_lanes(std::array::from_fn(|run| Real::atan2(y[run], x[run])))
        }
        fn exp_m1(self) -> Self {
            Self::from_lanes(self.lanes().map(Real::exp_m1))
        }
        fn ln(self) -> Self {
            Self::from_lanes(self.lanes().map(Real::ln))
        }
        fn round(self) -> Self {
            Self::from_lanes(self.lanes().map(Real::round))
        }
    };
}

#[cfg(target_arch = "x86_64")]
pub(super) use functions;

impl Real for Four {
    type Mask = [bool; RUNS];
    type Twin = Both<Self>;
    schuler::wrapped_constants!(f64, Self::all);

    functions!();

    #[inline(always)]
    fn of(literal: f64) -> Self {
        Self::all(literal)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        self.each(self, |x, _| x.sqrt())
    }
    #[inline(always)]
    fn abs(self) -> Self {
        self.each(self, |x, _| x.abs())
    }
    #[inline(always)]
    fn upper_half(self) -> Self {
        self.each(self, |x, _| x.upper_half())
    }
    #[inline(always)]
    fn less(self, other: Self) -> [bool; RUNS] {
        std::array::from_fn(|run| self.0[run] < other.0[run])
    }
    #[inline(always)]
    fn select(mask: [bool; RUNS], yes: Self, no: Self) -> Self {
        Self(std::array::from_fn(|run| if mask[run] { yes.0[run] } else { no.0[run] }))
    }
    #[inline(always)]
    fn any(mask: [bool; RUNS]) -> bool {
        mask.contains(&true)
    }
    #[inline(always)]
    fn is_within(self, bound: Self) -> bool {
        (0..RUNS).all(|run| self.0[run].abs() <= bound.0[run])
    }
}
