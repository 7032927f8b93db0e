//! The natural logarithm in lanes, with the bits of libm's: the algorithm and the coefficients are those of
//! Sun's fdlibm, operation by operation.

use super::pack::Lanes;
use super::words::Words;
use schuler::math::real::Real;

/// ln 2 = the sum of both; products of the first with an exponent are exact.
const LN_2: [f64; 2] = [6.931_471_803_691_238e-1, 1.908_214_929_270_587_7e-10];

/// By rising powers of s².
const SERIES: [f64; 7] = [
    6.666_666_666_666_735e-1,
    3.999_999_999_940_942e-1,
    2.857_142_874_366_239e-1,
    2.222_219_843_214_978_4e-1,
    1.818_357_216_161_805e-1,
    1.531_383_769_920_937_3e-1,
    1.479_819_860_511_658_6e-1,
];

/// The upper half of √½, as the algorithm has it, and that of 1.
const ROOT_HALF: u64 = 0x3fe6_a09e_0000_0000;
const ONE: u64 = 0x3ff0_0000_0000_0000;
/// The digits of a number, without its sign and exponent.
const DIGITS: u64 = (1 << 52) - 1;
/// 2⁵², whose last digit is a unit.
const UNITS: f64 = (1u64 << 52) as f64;

/// ln x of every lane.
#[inline(always)]
pub fn ln<P: Lanes<N>, const N: usize>(x: P) -> P {
    let normal = x.is_within(P::of(f64::MAX));
    if !normal | P::any(x.less(P::of(f64::MIN_POSITIVE))) {
        let mut lanes = x.lanes();
        one_by_one(&mut lanes);
        return P::from_lanes(lanes);
    }
    // x = 2ᵏ(1 + f),  √½ ≤ 1 + f < √2
    let shifted = x.to_bits() + P::Words::all(ONE - ROOT_HALF);
    let k = P::from_bits(shifted.down(52) | P::Words::all(UNITS.to_bits()));
    let k = k - P::of(UNITS + 1023.0);
    let reduced = (shifted & P::Words::all(DIGITS)) + P::Words::all(ROOT_HALF);
    let f = P::from_bits(reduced) - P::ONE;
    // s = f/(2 + f),  ln(1 + f) = f − f²/2 + s(f²/2 + R(s²))
    let s = f / (P::TWO + f);
    let z = s * s;
    let w = z * z;
    let [c1, c2, c3, c4, c5, c6, c7] = SERIES;
    let even = w * (P::of(c2) + w * (P::of(c4) + w * P::of(c6)));
    let odd = z * (P::of(c1) + w * (P::of(c3) + w * (P::of(c5) + w * P::of(c7))));
    let half_square = P::HALF * f * f;
    let [high, low] = LN_2;
    s * (half_square + (odd + even)) + k * P::of(low) - half_square + f + k * P::of(high)
}

/// Zero, subnormal, negative or infinite numbers, or none at all.
#[cold]
#[inline(never)]
fn one_by_one(lanes: &mut [f64]) {
    for x in lanes {
        *x = Real::ln(*x);
    }
}
