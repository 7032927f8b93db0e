//! The size of a spline's third derivative, as a quadratic form of its control points.
//!
//! f‴ is a spline of degree 4 with control points e_j, third divided differences of c:
//! c⁽ᵐ⁺¹⁾_j = (7 − m)(c⁽ᵐ⁾_{j+1} − c⁽ᵐ⁾_j)/(t_{j+8} − t_{j+m+1}), e = c⁽³⁾, and the penalty is
//! P = Σ_j w_j e_j² with w_j = (t_{j+8} − t_{j+3})/5, the integral of the function that e_j stands with. With equal
//! spacing this is the third difference of a P-spline (Eilers & Marx, *Statistical Science* 11 (1996) 89–121); with
//! unequal knots its general form (Li & Cao, General P-splines for non-uniform B-splines, arXiv 2201.06808).
//!
//! ```
//! use schuler::trajectory::spline::{basis::Knots, penalty::difference};
//!
//! // With equal spacing, third differences over the cube of it.
//! let (weights, size) = difference(Knots::continued(&[0.0, 0.5, 1.0]), 2);
//! for (weight, expected) in weights.iter().zip([-8.0, 24.0, -24.0, 8.0]) {
//!     assert!((weight - expected).abs() < 1e-13);
//! }
//! assert!((size - 0.5).abs() < 1e-15);
//! ```

use super::basis::Knots;
use super::{BAND, DEGREE};

/// Number of control points in a third difference.
pub const REACH: usize = 4;

/// The weights of c_j to c_{j+3} in e_j, per second³, and w_j, s.
pub fn difference(knots: Knots<'_>, j: usize) -> ([f64; REACH], f64) {
    let t = |k: usize| knots.at(j + k);
    let mut weights = [-1.0, 1.0, 0.0, 0.0];
    let mut next = [0.0, -1.0, 1.0, 0.0];
    let mut third = [0.0, 0.0, -1.0, 1.0];
    // First differences, then their differences in place.
    let scale = |row: &mut [f64; REACH], factor: f64| row.iter_mut().for_each(|x| *x *= factor);
    let degree = DEGREE as f64;
    scale(&mut weights, degree / (t(8) - t(1)));
    scale(&mut next, degree / (t(9) - t(2)));
    scale(&mut third, degree / (t(10) - t(3)));
    let subtract = |a: &mut [f64; REACH], b: &[f64; REACH], factor: f64| {
        a.iter_mut().zip(b).for_each(|(a, b)| *a = (b - *a) * factor);
    };
    subtract(&mut weights, &next, (degree - 1.0) / (t(8) - t(2)));
    subtract(&mut next, &third, (degree - 1.0) / (t(9) - t(3)));
    subtract(&mut weights, &next, (degree - 2.0) / (t(8) - t(3)));
    (weights, (t(8) - t(3)) / 5.0)
}

/// Adds λP to the lower half of a symmetric band: entry d of column c is that of row c + d.
pub fn add_to(knots: Knots<'_>, lambda: f64, band: &mut [[f64; BAND]]) {
    for j in 0..(band.len() + 1).saturating_sub(REACH) {
        let (weights, size) = difference(knots, j);
        for (k, weight) in weights.iter().enumerate() {
            let Some(column) = band.get_mut(j + k) else { continue };
            for (place, other) in column.iter_mut().zip(weights.iter().skip(k)) {
                *place += lambda * size * weight * other;
            }
        }
    }
}

/// Takes λP·c, the penalty's gradient by half, from the right side.
pub fn subtract_gradient<const C: usize>(
    knots: Knots<'_>,
    lambda: f64,
    control: &[[f64; C]],
    right: &mut [[f64; C]],
) {
    for (j, points) in control.windows(REACH).enumerate() {
        let (weights, size) = difference(knots, j);
        let mut third = [0.0; C];
        for (point, weight) in points.iter().zip(weights) {
            third.iter_mut().zip(point).for_each(|(e, c)| *e += weight * c);
        }
        for (row, weight) in right.iter_mut().skip(j).zip(weights) {
            row.iter_mut().zip(third).for_each(|(x, e)| *x -= lambda * size * weight * e);
        }
    }
}
