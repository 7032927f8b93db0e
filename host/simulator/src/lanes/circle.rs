//! Sine and cosine in lanes, with the bits of libm's: the algorithm and the coefficients are those of Sun's
//! fdlibm, operation by operation.

use super::pack::Lanes;
use super::words::Words;
use schuler::math::real::Real;
use std::f64::consts::{FRAC_2_PI, FRAC_PI_4};

/// π/2 = the sum of both; products of the first with a number of quarter turns are exact.
const QUARTER: [f64; 2] = [1.570_796_326_734_125_6, 6.077_100_506_506_192e-11];

/// 1.5·2⁵², whose last digit is a unit: a sum with it is rounded to a whole number, and ends in its bits.
const UNITS: f64 = (3u64 << 51) as f64;

/// Below it there is nothing to reduce: π/4 with zeros in the lower half of its bits, and the next such number.
const NEAR: f64 = f64::from_bits(0x3fe9_21fc_0000_0000);
/// Below it the sine is its angle: 2⁻²⁷√2.
const TINY: f64 = f64::from_bits(0x3e46_a09e_0000_0000);
/// The largest angle below 2²⁰·π/2, as the algorithm has it.
const FAR: f64 = f64::from_bits(0x4139_21fa_ffff_ffff);

/// A remainder so much smaller than its angle needs more digits of π.
const CANCELLED: f64 = 1.0 / (1u64 << 16) as f64;
/// With a larger remainder the nearest quarter turn is in doubt: the algorithm compares the upper half of the
/// bits alone.
const DOUBTFUL: f64 = FRAC_PI_4 - 1e-5;

/// By rising powers of z = y², from y³/y and y⁴.
const SINE: [f64; 6] = [
    -1.666_666_666_666_663_2e-1,
    8.333_333_333_322_49e-3,
    -1.984_126_982_985_795e-4,
    2.755_731_370_707_006_8e-6,
    -2.505_076_025_340_686_3e-8,
    1.589_690_995_211_55e-10,
];
const COSINE: [f64; 6] = [
    4.166_666_666_666_66e-2,
    -1.388_888_888_887_411e-3,
    2.480_158_728_947_673e-5,
    -2.755_731_435_139_066_3e-7,
    2.087_572_321_298_175e-9,
    -1.135_964_755_778_819_5e-11,
];

/// Sine and cosine of every lane.
#[inline(always)]
pub fn sin_cos<P: Lanes<N>, const N: usize>(x: P) -> (P, P) {
    let size = x.abs();
    let near = size.less(P::of(NEAR));
    // x = n·π/2 + y + z,  |y| ≤ π/4
    let [quarter, rest] = QUARTER;
    let counted = x * P::of(FRAC_2_PI) + P::of(UNITS);
    let n = counted - P::of(UNITS);
    let (high, low) = (x - n * P::of(quarter), n * P::of(rest));
    let reduced = high - low;
    let y = P::select(near, x, reduced);
    let z = P::select(near, P::ZERO, (high - reduced) - low);
    let left = y.abs();
    let hard = left.less(size * P::of(CANCELLED)) | P::of(DOUBTFUL).less(left);
    if !x.is_within(P::of(FAR)) | P::any(hard) {
        let [sine, cosine] = one_by_one(x.lanes());
        return (P::from_lanes(sine), P::from_lanes(cosine));
    }

    let [s1, s2, s3, s4, s5, s6] = SINE;
    let [c1, c2, c3, c4, c5, c6] = COSINE;
    let y2 = y * y;
    let y4 = y2 * y2;
    let late = P::of(s5) + y2 * P::of(s6);
    let series = P::of(s2) + y2 * (P::of(s3) + y2 * P::of(s4)) + y2 * y4 * late;
    let y3 = y2 * y;
    // Without a reduction the algorithm leaves z out, and rounds otherwise.
    let plain = y + y3 * (P::of(s1) + y2 * series);
    let full = y - ((y2 * (P::HALF * z - y3 * series) - z) - y3 * P::of(s1));
    let sine = P::select(near, plain, full);
    let sine = P::select(size.less(P::of(TINY)), x, sine);

    let late = P::of(c4) + y2 * (P::of(c5) + y2 * P::of(c6));
    let series = y2 * (P::of(c1) + y2 * (P::of(c2) + y2 * P::of(c3))) + y4 * y4 * late;
    let half = P::HALF * y2;
    let most = P::ONE - half;
    let cosine = most + (((P::ONE - most) - half) + (y2 * series - y * z));

    // After n quarter turns: (s, c), (c, −s), (−s, −c), (−c, s).
    let n = P::select(near, P::of(UNITS), counted).to_bits();
    let one = P::Words::all(1);
    let odd = P::beyond(n & one, 0);
    (
        turned::<P, N>(P::select(odd, cosine, sine), n),
        turned::<P, N>(P::select(odd, sine, cosine), n + one),
    )
}

/// Negative where the second to last bit of a count is set.
#[inline(always)]
fn turned<P: Lanes<N>, const N: usize>(x: P, count: P::Words) -> P {
    P::from_bits(x.to_bits() ^ (count & P::Words::all(2)).up(62))
}

/// Where the algorithm has more to do, or decides by bits that are not looked at here.
#[cold]
#[inline(never)]
fn one_by_one<const N: usize>(x: [f64; N]) -> [[f64; N]; 2] {
    let both = x.map(Real::sin_cos);
    [both.map(|(sine, _)| sine), both.map(|(_, cosine)| cosine)]
}
