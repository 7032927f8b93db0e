//! Least squares with a penalty: minimise Σ|z − f(t)|² + λP, by its normal equations and their factors LDLᵀ.
//!
//! (BᵀB + λP)c = Bᵀz, a symmetric band of seven entries below the diagonal. Entry d of column c is that of row c + d.
//! Source: Golub & Van Loan, *Matrix Computations*, 4th ed., §4.1.2 and §4.3.5.
//!
//! ```
//! use schuler::trajectory::spline::{BAND, normal::{factor, solve}};
//!
//! // (4 2; 2 3) x = (2; 5)
//! let mut columns = [[0.0; BAND]; 2];
//! columns[0][..2].copy_from_slice(&[4.0, 2.0]);
//! columns[1][0] = 3.0;
//! let mut right = [[2.0], [5.0]];
//! factor(&mut columns)?;
//! solve(&columns, &mut right);
//! assert!((right[0][0] + 0.5).abs() < 1e-15 && (right[1][0] - 2.0).abs() < 1e-15);
//! # Ok::<(), schuler::trajectory::spline::SplineError>(())
//! ```

use super::basis::{Knots, values};
use super::{BAND, SplineError, TERMS};

/// Calls a function for each sample, with the first control point that counts there and the basis.
///
/// # Errors
///
/// [`SplineError`] if the times do not increase, or one lies outside the sites.
pub fn for_each_sample(
    knots: Knots<'_>,
    times_s: &[f64],
    mut visit: impl FnMut(usize, usize, [f64; TERMS]),
) -> Result<(), SplineError> {
    let sites = knots.sites();
    let mut span = 0;
    let last_span = sites.len().saturating_sub(2);
    let outside = |time: f64| {
        !(sites.first().is_some_and(|&first| first <= time)
            && sites.last().is_some_and(|&last| time <= last))
    };
    for (index, &time) in times_s.iter().enumerate() {
        if outside(time) {
            return Err(SplineError::Outside { index });
        }
        while span < last_span && sites.get(span + 1).is_some_and(|&end| end <= time) {
            span += 1;
        }
        visit(index, span, values(&knots.around(span), time));
    }
    Ok(())
}

/// Adds a sample's BᵀB to the band.
pub fn add_sample(band: &mut [[f64; BAND]], span: usize, basis: &[f64; TERMS]) {
    for (k, (column, weight)) in band.iter_mut().skip(span).zip(basis).enumerate() {
        for (place, other) in column.iter_mut().zip(basis.iter().skip(k)) {
            *place += weight * other;
        }
    }
}

/// The spline's value at a sample.
pub fn value<const C: usize>(control: &[[f64; C]], span: usize, basis: &[f64; TERMS]) -> [f64; C] {
    let mut sum = [0.0; C];
    for (point, weight) in control.iter().skip(span).zip(basis) {
        sum.iter_mut().zip(point).for_each(|(sum, c)| *sum += weight * c);
    }
    sum
}

/// Factors a positive definite band in its place: D on the diagonal, L below it.
///
/// # Errors
///
/// [`SplineError::Undetermined`] if it is not positive definite.
pub fn factor(band: &mut [[f64; BAND]]) -> Result<(), SplineError> {
    let mut rest = band;
    while let Some((column, below)) = rest.split_first_mut() {
        let Some((&mut diagonal, entries)) = column.split_first_mut() else { break };
        if !(diagonal > 0.0 && diagonal.is_finite()) {
            return Err(SplineError::Undetermined);
        }
        for (i, target) in below.iter_mut().take(BAND - 1).enumerate() {
            // A_{c+i, c+j} ← A − l_i d l_j for j ≥ i
            let Some((&first, _)) = entries.get(i..).and_then(<[f64]>::split_first) else { break };
            let share = first / diagonal;
            for (place, entry) in target.iter_mut().zip(entries.iter().skip(i)) {
                *place -= share * entry;
            }
        }
        entries.iter_mut().for_each(|entry| *entry /= diagonal);
        rest = below;
    }
    Ok(())
}

/// Solves for every channel of the right side, in its place, with the factors.
pub fn solve<const C: usize>(factors: &[[f64; BAND]], right: &mut [[f64; C]]) {
    let mut rest = &mut *right;
    for column in factors {
        let Some((x, below)) = rest.split_first_mut() else { break };
        for (row, l) in below.iter_mut().zip(column.iter().skip(1)) {
            row.iter_mut().zip(x.iter()).for_each(|(row, x)| *row -= l * x);
        }
        rest = below;
    }
    for (index, column) in factors.iter().enumerate().rev() {
        let Some((x, below)) = right.get_mut(index..).and_then(<[_]>::split_first_mut) else {
            continue;
        };
        let Some((diagonal, entries)) = column.split_first() else { continue };
        x.iter_mut().for_each(|x| *x /= diagonal);
        for (row, l) in below.iter().zip(entries) {
            x.iter_mut().zip(row).for_each(|(x, row)| *x -= l * row);
        }
    }
}
