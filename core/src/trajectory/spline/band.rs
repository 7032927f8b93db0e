//! Elimination in a band of seven entries a row, with exchange of rows.
//!
//! Row r of n begins at column r − 3, at least 0 and at most n − 7. So rows are stored from their first column
//! on. When column k is eliminated, all rows that are left and have an entry there begin there, and none reaches
//! beyond k + 6, also after an exchange. The exchange takes no room of its own.
//! Source: Golub & Van Loan, *Matrix Computations*, 4th ed., §4.3.3.
//!
//! ```
//! use schuler::trajectory::spline::{BAND, band::solve};
//!
//! // 2x + y = 5, x + 3y = 10.
//! let mut rows = [[0.0; BAND]; 2];
//! rows[0][..2].copy_from_slice(&[2.0, 1.0]);
//! rows[1][..2].copy_from_slice(&[1.0, 3.0]);
//! let mut right = [[5.0], [10.0]];
//! solve(&mut rows, &mut right)?;
//! assert!((right[0][0] - 1.0).abs() < 1e-15 && (right[1][0] - 3.0).abs() < 1e-15);
//! # Ok::<(), schuler::trajectory::spline::SplineError>(())
//! ```

use super::{BAND, SplineError};

/// Rows below the diagonal, but for the last columns.
pub const BELOW: usize = 3;
/// Entries of a row.
const WIDTH: usize = 2 * BELOW + 1;

/// Solves for every channel of the right side, in its place; the rows are used up.
///
/// # Errors
///
/// [`SplineError::Undetermined`] if a column has no pivot.
pub fn solve<const C: usize>(
    rows: &mut [[f64; BAND]],
    right: &mut [[f64; C]],
) -> Result<(), SplineError> {
    // Pivots are compared between rows of like size.
    for (row, right) in rows.iter_mut().zip(right.iter_mut()) {
        let largest = row.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        if largest > 0.0 {
            row.iter_mut().chain(right).for_each(|x| *x /= largest);
        }
    }
    let count = rows.len().min(right.len());
    for column in 0..count {
        let (Some(rows), Some(right)) = (rows.get_mut(column..), right.get_mut(column..)) else {
            break;
        };
        let active = if column + WIDTH < count { BELOW + 1 } else { WIDTH };
        eliminate(rows, right, active)?;
    }
    for column in (0..count).rev() {
        let (Some(row), Some(right)) = (rows.get(column), right.get_mut(column..)) else { break };
        let Some((x, known)) = right.split_first_mut() else { break };
        let (pivot, rest) = split(row);
        for (channel, x) in x.iter_mut().enumerate() {
            let known = known.iter().filter_map(|row| row.get(channel));
            let sum: f64 = rest.iter().zip(known).map(|(a, x)| a * x).sum();
            *x = (*x - sum) / pivot;
        }
    }
    Ok(())
}

/// The first entry of a row, and the others.
fn split(row: &[f64; BAND]) -> (f64, &[f64]) {
    row.split_first().map_or((0.0, &[]), |(first, rest)| (*first, rest))
}

/// Exchanges the first row for another.
fn exchange<T>(rows: &mut [T], index: usize) {
    if let Some((first, rest)) = rows.split_first_mut()
        && let Some(other) = index.checked_sub(1).and_then(|index| rest.get_mut(index))
    {
        core::mem::swap(first, other);
    }
}

/// Makes one of the active rows the pivot and the first, and takes it from the others, which then begin one
/// column later.
fn eliminate<const C: usize>(
    rows: &mut [[f64; BAND]],
    right: &mut [[f64; C]],
    active: usize,
) -> Result<(), SplineError> {
    let mut best = (0, 0.0);
    for (index, row) in rows.iter().take(active).enumerate() {
        let size = split(row).0.abs();
        if size > best.1 {
            best = (index, size);
        }
    }
    if !(best.1 > 0.0 && best.1.is_finite()) {
        return Err(SplineError::Undetermined);
    }
    exchange(rows, best.0);
    exchange(right, best.0);
    let (Some((pivot, rows)), Some((source, right))) =
        (rows.split_first_mut(), right.split_first_mut())
    else {
        return Ok(());
    };
    let (first, _) = split(pivot);
    for (row, right) in rows.iter_mut().zip(right).take(active - 1) {
        let factor = split(row).0 / first;
        for (x, p) in row.iter_mut().zip(pivot.iter()) {
            *x -= factor * p;
        }
        row.rotate_left(1);
        if let Some(last) = row.last_mut() {
            *last = 0.0;
        }
        for (x, p) in right.iter_mut().zip(source.iter()) {
            *x -= factor * p;
        }
    }
    Ok(())
}
