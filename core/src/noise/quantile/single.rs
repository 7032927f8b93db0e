//! The quantile in single precision by polynomials in pieces: no logarithm, no root and no division, which a
//! target without them in hardware pays dearly for.
//!
//! Within ¼ of ½ the deviate is an odd polynomial of the probability's distance from ½. Beyond, each octave of the
//! probability has 16 pieces, which the bits of the probability itself address: 8 KB of coefficients. The
//! compiler works them out: they interpolate PPND16 at the nodes of a Chebyshev polynomial. The relative error is
//! below 2e-7.

#![expect(
    clippy::indexing_slicing,
    reason = "the compiler alone evaluates it, and stops at an index out of range"
)]

use super::Rational;
use super::double::{CENTRAL, FAR_TAIL, TAIL};

/// Coefficients of a piece, by rising powers.
const TERMS: usize = 4;
type Piece = [f32; TERMS];

/// Coefficients about ½, of the deviate over the distance, in the square of the distance.
const CENTRE: [f32; 6] = through(centre());

/// Coefficients beyond, of the deviate, in the place within a piece.
static BEYOND: [Piece; 512] = beyond();

/// The bits of 1, and those that tell a place within a piece: an octave has 16.
const ONE: u32 = 0x3f80_0000;
const PLACE: u32 = (1 << 19) - 1;
/// The piece of 1, among its neighbours in a circle.
const FIRST: usize = (ONE >> 19) as usize % 512;

/// The deviate of a word: its top bit is the sign, the rest, k of 31 bits, the distance q = (k + ½)/2³² from ½.
#[inline(always)]
pub fn normal(word: u32) -> f32 {
    let z = if word & 1 << 30 == 0 {
        let q = ((word << 1 | 1) as i32 as f32) * (0.5 / (1u64 << 32) as f32);
        let r = q * q;
        let [c0, c1, c2, c3, c4, c5] = CENTRE;
        q * (c0 + r * (c1 + r * (c2 + r * (c3 + r * (c4 + r * c5)))))
    } else {
        // 2³³(½ − q) = 2(2³¹ − 1 − k) + 1
        let bits = (!(word << 1) as i32 as f32).to_bits();
        let x = f32::from_bits(bits & PLACE | ONE) - 1.03125;
        let piece = BEYOND.get((bits >> 19) as usize % BEYOND.len());
        let [c0, c1, c2, c3] = *piece.unwrap_or(&[0.0; TERMS]);
        c0 + x * (c1 + x * (c2 + x * c3))
    };
    if (word as i32) < 0 { -z } else { z }
}

/// Zeros of the Chebyshev polynomials of degree 6 and 4.
const SIX: [f64; 6] = [
    -0.965_925_826_289_068_3,
    -0.707_106_781_186_547_5,
    -0.258_819_045_102_520_74,
    0.258_819_045_102_520_74,
    0.707_106_781_186_547_5,
    0.965_925_826_289_068_3,
];
const FOUR: [f64; TERMS] = [
    -0.923_879_532_511_286_7,
    -0.382_683_432_365_089_8,
    0.382_683_432_365_089_8,
    0.923_879_532_511_286_7,
];

/// z(q)/q at six values of r = q² in [0, 1/16].
const fn centre() -> [[f64; 6]; 2] {
    let mut points = [[0.0; 6]; 2];
    let mut n = 0;
    while n < 6 {
        let r = (1.0 + SIX[n]) / 32.0;
        let q = root(r);
        points[0][n] = r;
        points[1][n] = deviate(0.5 - q) / q;
        n += 1;
    }
    points
}

const fn beyond() -> [Piece; 512] {
    let mut pieces = [[0.0; TERMS]; 512];
    // 2⁻³³ times the power of two that an octave starts at
    let mut octave = 1.0 / (1u64 << 33) as f64;
    let mut piece = 0;
    while piece < pieces.len() {
        let mut points = [[0.0; TERMS]; 2];
        let mut n = 0;
        while n < TERMS {
            let x = FOUR[n] / 32.0;
            points[0][n] = x;
            points[1][n] = deviate(octave * (1.03125 + 0.0625 * (piece % 16) as f64 + x));
            n += 1;
        }
        pieces[(FIRST + piece) % 512] = through(points);
        piece += 1;
        if piece % 16 == 0 {
            octave *= 2.0;
        }
    }
    pieces
}

/// The deviate that is exceeded with a probability below ½.
const fn deviate(p: f64) -> f64 {
    let q = 0.5 - p;
    if q <= 0.425 {
        return q * ratio(&CENTRAL, 0.180625 - q * q);
    }
    let r = root(-logarithm(p));
    if r <= 5.0 { ratio(&TAIL, r - 1.6) } else { ratio(&FAR_TAIL, r - 5.0) }
}

const fn ratio(table: &Rational, r: f64) -> f64 {
    let (mut numerator, mut denominator) = (0.0, 0.0);
    let mut n = 0;
    while n < 8 {
        numerator = numerator * r + table.0[n];
        denominator = denominator * r + table.1[n];
        n += 1;
    }
    numerator / denominator
}

/// ln x of a number below 1.
const fn logarithm(mut x: f64) -> f64 {
    let mut halvings = 0.0;
    while x < 0.7 {
        x *= 2.0;
        halvings += 1.0;
    }
    // ln x = 2(s + s³/3 + s⁵/5 + …),  s = (x − 1)/(x + 1)
    let s = (x - 1.0) / (x + 1.0);
    let (mut sum, mut n) = (0.0, 29.0);
    while n > 0.0 {
        sum = sum * s * s + 2.0 / n;
        n -= 2.0;
    }
    s * sum - halvings * core::f64::consts::LN_2
}

/// √x by Newton's method.
const fn root(x: f64) -> f64 {
    let mut root = 0.5 + 0.5 * x;
    let mut n = 0;
    while n < 20 {
        root = 0.5 * (root + x / root);
        n += 1;
    }
    root
}

/// The polynomial through points of x and y, by Newton's divided differences.
const fn through<const N: usize>([x, mut y]: [[f64; N]; 2]) -> [f32; N] {
    let mut order = 1;
    while order < N {
        let mut n = N - 1;
        while n >= order {
            y[n] = (y[n] - y[n - 1]) / (x[n] - x[n - order]);
            n -= 1;
        }
        order += 1;
    }
    // y₀ + (x − x₀)(y₁ + (x − x₁)(y₂ + …)), multiplied out
    let mut powers = [0.0; N];
    let mut factor = N;
    while factor > 0 {
        factor -= 1;
        let mut n = N - 1;
        while n > 0 {
            powers[n] = powers[n - 1] - x[factor] * powers[n];
            n -= 1;
        }
        powers[0] = y[factor] - x[factor] * powers[0];
    }
    let mut coefficients = [0.0; N];
    let mut n = 0;
    while n < N {
        coefficients[n] = powers[n] as f32;
        n += 1;
    }
    coefficients
}
