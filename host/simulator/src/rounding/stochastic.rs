//! A scalar that rounds at random: up or down, each with the probability that makes the mean exact.
//!
//! Runs with different draws differ in what rounding alone decides (Parker's Monte Carlo arithmetic;
//! Vignes' CESTAC). What is exact stays as it is, so the error-free transformations nearly keep their
//! meaning: x + y = s + e still holds for the s that was drawn, but where s is the farther neighbour its
//! e may take one bit more than fits, and is then itself rounded at random, at 2⁻⁵³ of an ulp. A
//! compensated sum is therefore a little noisier here than in nearest rounding, never better.
//!
//! sin, cos, atan2, exp and ln have no exact error at hand: they move by an ulp either way, each with a
//! probability of a quarter. Constants are what they are in the type itself.

use super::split_mix;
use schuler::math::real::{Real, Scalar};
use schuler::math::twin::Both;
use std::cell::Cell;
use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

thread_local! {
    static STATE: Cell<u64> = const { Cell::new(0) };
}

/// Starts a sequence of draws in this thread.
pub fn seed(seed: u64) {
    STATE.set(seed.wrapping_mul(split_mix::STEP) ^ 0x5851_f42d_4c95_7f2d);
}

/// Evenly in [0, 1).
fn draw() -> f64 {
    let mut state = STATE.get();
    let word = split_mix::word(&mut state);
    STATE.set(state);
    (word >> 11) as f64 * 2.0_f64.powi(-53)
}

/// A format that can be rounded to at random.
pub trait Format: Scalar + Debug {
    /// a + b.
    fn sum(a: Self, b: Self) -> Self;
    /// a·b.
    fn product(a: Self, b: Self) -> Self;
    /// a/b.
    fn quotient(a: Self, b: Self) -> Self;
    /// √a.
    fn root(a: Self) -> Self;
    /// One ulp up, or one ulp down.
    fn next(self, up: bool) -> Self;
}

/// A nearest result and what it lacks, rounded at random instead.
fn moved(nearest: f64, error: f64) -> f64 {
    if error == 0.0 || !error.is_finite() {
        return nearest;
    }
    let neighbour = if error > 0.0 { nearest.next_up() } else { nearest.next_down() };
    // The chance to leave for the neighbour is the part of the way that the exact result lies off.
    if draw() * (neighbour - nearest).abs() < error.abs() { neighbour } else { nearest }
}

/// p + e = a·b exactly, by Veltkamp's split into 26 bits each, where nothing over- or underflows.
fn exact_product(a: f64, b: f64) -> (f64, f64) {
    let split = |x: f64| {
        let c = 134_217_729.0 * x;
        let high = c - (c - x);
        (high, x - high)
    };
    let ((ah, al), (bh, bl)) = (split(a), split(b));
    let p = a * b;
    (p, al * bl - (((p - ah * bh) - al * bh) - ah * bl))
}

impl Format for f64 {
    fn sum(a: f64, b: f64) -> f64 {
        let s = a + b;
        let z = s - a;
        moved(s, (a - (s - z)) + (b - z))
    }
    fn product(a: f64, b: f64) -> f64 {
        let (p, e) = exact_product(a, b);
        // An error below the least number of the type says nothing any more.
        if p.abs() < 1e-290 { p } else { moved(p, e) }
    }
    fn quotient(a: f64, b: f64) -> f64 {
        let q = a / b;
        let (p, e) = exact_product(q, b);
        if q.abs() < 1e-290 { q } else { moved(q, ((a - p) - e) / b) }
    }
    fn root(a: f64) -> f64 {
        let s = a.sqrt();
        let (p, e) = exact_product(s, s);
        if s == 0.0 { s } else { moved(s, ((a - p) - e) / (s + s)) }
    }
    fn next(self, up: bool) -> f64 {
        if up { self.next_up() } else { self.next_down() }
    }
}

/// A double rounded to single at random; the double is exact to 2⁻²⁹ of a single's ulp.
fn to_single(x: f64) -> f32 {
    let nearest = x as f32;
    let error = x - f64::from(nearest);
    if error == 0.0 || !error.is_finite() {
        return nearest;
    }
    let neighbour = if error > 0.0 { nearest.next_up() } else { nearest.next_down() };
    let gap = (f64::from(neighbour) - f64::from(nearest)).abs();
    if draw() * gap < error.abs() { neighbour } else { nearest }
}

impl Format for f32 {
    fn sum(a: f32, b: f32) -> f32 {
        to_single(f64::from(a) + f64::from(b))
    }
    fn product(a: f32, b: f32) -> f32 {
        to_single(f64::from(a) * f64::from(b))
    }
    fn quotient(a: f32, b: f32) -> f32 {
        to_single(f64::from(a) / f64::from(b))
    }
    fn root(a: f32) -> f32 {
        to_single(f64::from(a).sqrt())
    }
    fn next(self, up: bool) -> f32 {
        if up { self.next_up() } else { self.next_down() }
    }
}

/// A number of the format `T` whose operations round at random.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Stochastic<T>(pub T);

impl<T: Format> Stochastic<T> {
    /// A function's value, moved by an ulp now and then.
    fn shaken(x: T) -> Self {
        let r = draw();
        if x == T::ZERO || r >= 0.5 { Self(x) } else { Self(x.next(r < 0.25)) }
    }
}

macro_rules! operator {
    ($($op:ident $f:ident $how:ident),+) => {
        $(impl<T: Format> $op for Stochastic<T> {
            type Output = Self;
            #[inline(never)]
            fn $f(self, b: Self) -> Self {
                Self(T::$how(self.0, b.0))
            }
        })+
    };
}

operator!(Add add sum, Mul mul product, Div div quotient);

impl<T: Format> Sub for Stochastic<T> {
    type Output = Self;
    fn sub(self, b: Self) -> Self {
        self + -b
    }
}

impl<T: Format> Neg for Stochastic<T> {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<T: Format<Mask = bool>> Real for Stochastic<T> {
    schuler::math::real::one_number!();
    type Twin = Both<Self>;
    schuler::math::real::wrapped_constants!(T, Self);

    fn of(literal: f64) -> Self {
        Self(T::of(literal))
    }
    fn residual(literal: f64) -> Self {
        Self(T::residual(literal))
    }
    fn entry(single: f32, double: f64) -> Self {
        Self(T::entry(single, double))
    }
    fn count(n: u32) -> Self {
        Self(T::count(n))
    }
    fn ratio(numerator: i128, denominator: i128) -> Self {
        Self(T::ratio(numerator, denominator))
    }
    fn sqrt(self) -> Self {
        Self(T::root(self.0))
    }
    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.0.sin_cos();
        (Self::shaken(sine), Self::shaken(cosine))
    }
    fn atan2(self, x: Self) -> Self {
        Self::shaken(self.0.atan2(x.0))
    }
    fn exp_m1(self) -> Self {
        Self::shaken(self.0.exp_m1())
    }
    fn ln(self) -> Self {
        Self::shaken(self.0.ln())
    }
    fn round(self) -> Self {
        Self(self.0.round())
    }
    fn abs(self) -> Self {
        Self(self.0.abs())
    }
    fn upper_half(self) -> Self {
        Self(self.0.upper_half())
    }
    fn is_within(self, bound: Self) -> bool {
        self.0.is_within(bound.0)
    }
}

impl<T: Format<Mask = bool>> Scalar for Stochastic<T> {
    fn to_bits(self) -> u64 {
        self.0.to_bits()
    }
    fn from_bits(bits: u64) -> Self {
        Self(T::from_bits(bits))
    }
    fn widen(self) -> f64 {
        self.0.widen()
    }
    fn narrow(x: f64) -> Self {
        Self(T::narrow(x))
    }
}
