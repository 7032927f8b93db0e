//! The polynomial of degree 11 with given derivatives at both of its ends, to about twice the digits.
//!
//! Two pieces that meet have the same six derivatives there, so a path of them is five times continuously
//! differentiable. In plain double precision the joints would jump: coefficients are found in pairs.
//! Source: two-point Taylor interpolation, Davis, *Interpolation and Approximation* (1963), §2.5.
//!
//! ```
//! use schuler::math::compensated::Pair;
//! use schuler::trajectory::hermite::two_point;
//!
//! // t³ between −2 and 2, from its Taylor coefficients there.
//! let ends = [[-8.0, 12.0, -6.0, 1.0, 0.0, 0.0], [8.0, 12.0, 6.0, 1.0, 0.0, 0.0]];
//! let [start, end] = ends.map(|end| end.map(Pair::new));
//! let cubic = two_point(&start, &end, Pair::new(2.0_f64));
//! assert_eq!(cubic.map(|c| c.hi), [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
//! ```

use crate::math::compensated::Pair;

/// Number of derivatives at each end, the value among them.
pub const ORDERS: usize = 6;
/// Number of coefficients.
pub const TERMS: usize = 2 * ORDERS;

/// Row i gives coefficient 2i, times 256, from the Taylor coefficients of an even function at 1: the inverse
/// of the binomials C(2i, j).
const EVEN: [[f64; ORDERS]; ORDERS] = [
    [256.0, -193.0, 130.0, -74.0, 32.0, -8.0],
    [0.0, 315.0, -374.0, 282.0, -144.0, 40.0],
    [0.0, -210.0, 420.0, -420.0, 256.0, -80.0],
    [0.0, 126.0, -252.0, 308.0, -224.0, 80.0],
    [0.0, -45.0, 90.0, -114.0, 96.0, -40.0],
    [0.0, 7.0, -14.0, 18.0, -16.0, 8.0],
];

/// The same for coefficient 2i + 1 of an odd function, from the binomials C(2i + 1, j).
const ODD: [[f64; ORDERS]; ORDERS] = [
    [693.0, -437.0, 244.0, -114.0, 40.0, -8.0],
    [-1155.0, 1155.0, -840.0, 466.0, -184.0, 40.0],
    [1386.0, -1386.0, 1176.0, -756.0, 336.0, -80.0],
    [-990.0, 990.0, -864.0, 612.0, -304.0, 80.0],
    [385.0, -385.0, 340.0, -250.0, 136.0, -40.0],
    [-63.0, 63.0, -56.0, 42.0, -24.0, 8.0],
];

/// Coefficients of uᵏ about the middle, |u| ≤ `half`, from the Taylor coefficients f⁽ʲ⁾/j! at the start
/// (u = −half) and at the end (u = half).
pub fn two_point(
    start: &[Pair<f64>; ORDERS],
    end: &[Pair<f64>; ORDERS],
    half: Pair<f64>,
) -> [Pair<f64>; TERMS] {
    // With τ = u/half and b_j, a_j the coefficients at τ = ±1, those of the even and the odd part at 1 are
    // ½(b_j ± (−1)ʲ a_j). Halves and 1/256 are exact.
    let mut even = [Pair::default(); ORDERS];
    let mut odd = even;
    let (mut power, mut sign) = (Pair::new(1.0 / 512.0), 1.0);
    for (((even, odd), a), b) in even.iter_mut().zip(&mut odd).zip(start).zip(end) {
        let (a, b) = (*a * power * Pair::new(sign), *b * power);
        (*even, *odd) = (b + a, b - a);
        power = power * half;
        sign = -sign;
    }
    let row = |row: &[f64; ORDERS], part: &[Pair<f64>; ORDERS]| {
        row.iter().zip(part).fold(Pair::default(), |sum, (m, x)| sum + *x * Pair::new(*m))
    };
    let mut coefficients = [Pair::default(); TERMS];
    let (inverse, mut scale) = (half.reciprocal(), Pair::new(1.0));
    let rows = EVEN.iter().zip(&ODD);
    for (pair, (even_row, odd_row)) in coefficients.as_chunks_mut::<2>().0.iter_mut().zip(rows) {
        let even = row(even_row, &even) * scale;
        scale = scale * inverse;
        let odd = row(odd_row, &odd) * scale;
        scale = scale * inverse;
        *pair = [even, odd];
    }
    coefficients
}
