//! Numbers of 320 bits to measure rounding against, `Copy` so that formulas read like formulas.

use astro_float_num::{BigFloat, Consts, Exponent, RoundingMode, Sign, WORD_BIT_SIZE, Word};
use std::cell::RefCell;
use std::ops::{Add, Div, Mul, Neg, Sub};

const BITS: usize = 320;
const NEAREST: RoundingMode = RoundingMode::ToEven;

thread_local! {
    static CONSTANTS: RefCell<Consts> = RefCell::new(Consts::new().unwrap());
}

const WORDS: usize = BITS / WORD_BIT_SIZE;

/// A number of high precision.
#[derive(Clone, Copy)]
pub struct Big {
    /// The significand, least significant word first; all 0 for 0.
    words: [Word; WORDS],
    sign: Sign,
    exponent: Exponent,
}

impl From<BigFloat> for Big {
    fn from(x: BigFloat) -> Self {
        let (from, _, sign, exponent, _) = x.as_raw_parts().expect("finite");
        let mut words = [0; WORDS];
        for (to, from) in words.iter_mut().rev().zip(from.iter().rev()) {
            *to = *from;
        }
        Self { words, sign, exponent }
    }
}

impl From<Big> for BigFloat {
    fn from(x: Big) -> Self {
        if x.is_zero() {
            return Self::new(BITS);
        }
        Self::from_raw_parts(&x.words, BITS, x.sign, x.exponent, false)
    }
}

/// A double, exactly.
pub fn big(x: f64) -> Big {
    assert!(x.is_finite());
    BigFloat::from_f64(x, BITS).into()
}

impl Default for Big {
    fn default() -> Self {
        big(0.0)
    }
}

macro_rules! operator {
    ($($op:ident $f:ident),+) => {
        $(impl $op for Big {
            type Output = Self;
            fn $f(self, b: Self) -> Self {
                BigFloat::from(self).$f(&b.into(), BITS, NEAREST).into()
            }
        })+
    };
}

operator!(Add add, Sub sub, Mul mul, Div div);

impl Neg for Big {
    type Output = Self;
    fn neg(self) -> Self {
        BigFloat::from(self).neg().into()
    }
}

macro_rules! function {
    ($($name:ident),+) => {
        $(pub fn $name(self) -> Self {
            CONSTANTS.with_borrow_mut(|cc| BigFloat::from(self).$name(BITS, NEAREST, cc).into())
        })+
    };
}

impl Big {
    function!(sin, cos, atan, exp, ln);

    pub fn sqrt(self) -> Self {
        BigFloat::from(self).sqrt(BITS, NEAREST).into()
    }

    pub fn pi() -> Self {
        CONSTANTS.with_borrow_mut(|cc| cc.pi(BITS, NEAREST).into())
    }

    pub fn is_negative(self) -> bool {
        self.sign == Sign::Neg && !self.is_zero()
    }

    fn is_zero(self) -> bool {
        self.words == [0; WORDS]
    }

    /// The angle of the point (x, self), from 2 atan((r − x)/y) or from 2 atan(y/(r + x)).
    pub fn atan2(self, x: Self) -> Self {
        let r = (self * self + x * x).sqrt();
        let half = if x.is_negative() { (r - x) / self } else { self / (r + x) };
        big(2.0) * half.atan()
    }

    /// To a double, within an ulp or two.
    pub fn rough(self) -> f64 {
        let scale = 2.0_f64.powi(-(WORD_BIT_SIZE as i32));
        let fraction = self.words.iter().fold(0.0, |sum, &word| (sum + word as f64) * scale);
        let value = fraction * 2.0_f64.powi(self.exponent);
        if self.is_negative() { -value } else { value }
    }
}

/// Largest magnitude of some differences.
pub fn largest(differences: impl IntoIterator<Item = Big>) -> f64 {
    differences.into_iter().map(|x| x.rough().abs()).fold(0.0, f64::max)
}

#[test]
fn high_precision_is_what_it_says() {
    let third = big(1.0) / big(3.0);
    assert!((third * big(3.0) - big(1.0)).rough().abs() < 1e-95);
    assert!((big(2.0).sqrt() * big(2.0).sqrt() - big(2.0)).rough().abs() < 1e-94);
    let x = big(0.7);
    assert!((x.sin() * x.sin() + x.cos() * x.cos() - big(1.0)).rough().abs() < 1e-95);
    for (y, x) in [(1.0, -2.0), (-1.0, -2.0), (1e-9, 3.0), (5.0, 0.1)] {
        assert!((big(y).atan2(big(x)).rough() - f64::atan2(y, x)).abs() < 1e-15);
    }
    assert!((x.exp().ln() - x).rough().abs() < 1e-94);
    assert!((Big::pi().rough() - std::f64::consts::PI).abs() < 1e-15);
    assert_eq!(big(-1234.5678).rough(), -1234.5678);
}
