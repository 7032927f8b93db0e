//! A linear map of consecutive states: P ← T·P·Tᵀ, T the identity elsewhere.
//!
//! ```
//! use schuler::aiding::covariance::ud::Ud;
//!
//! let mut ud = Ud::<f64, 3, 6>::diagonal([1.0, 2.0, 3.0]);
//! // The second and the third change places.
//! ud.map_states(1, &[[0.0, 1.0], [1.0, 0.0]]);
//! assert_eq!((ud.variance(1), ud.variance(2)), (9.0, 4.0));
//! ```

use super::gram_schmidt::orthogonalise;
use super::ud::Ud;
use crate::math::real::Real;

impl<R: Real, const N: usize, const P: usize> Ud<R, N, P> {
    /// Maps `K` states from `first` on by a matrix given by rows.
    pub fn map_states<const K: usize>(&mut self, first: usize, matrix: &[[R; K]; K]) {
        let end = first + K;
        if end > N {
            return;
        }
        let mapped = |x: [R; K]| {
            let mut y = [R::ZERO; K];
            for (y, row) in y.iter_mut().zip(matrix) {
                *y = row.iter().zip(&x).fold(R::ZERO, |sum, (m, x)| sum + *m * *x);
            }
            y
        };
        // The columns of these states: W = T·U for their own rows; the rows above stay.
        let (mut rows, mut above, mut weights) =
            ([[R::ZERO; K]; K], [[R::ZERO; K]; N], [R::ZERO; K]);
        for (c, weight) in weights.iter_mut().enumerate() {
            let (column, d) = self.column(first + c);
            *weight = d;
            let (mut own, mut at) = ([R::ZERO; K], 0);
            for (row, u) in column.iter().enumerate() {
                if row < first {
                    if let Some(cell) = above.get_mut(row).and_then(|row| row.get_mut(c)) {
                        *cell = *u;
                    }
                } else if let Some(cell) = own.get_mut(at) {
                    *cell = *u;
                    at += 1;
                }
            }
            if let Some(cell) = own.get_mut(c) {
                *cell = R::ONE;
            }
            for (row, y) in rows.iter_mut().zip(mapped(own)) {
                if let Some(cell) = row.get_mut(c) {
                    *cell = y;
                }
            }
        }
        self.store(first, rows, above, &weights);
        // The columns beyond: their rows of these states.
        for j in end..N {
            let Some((column, _)) = self.column_mut(j) else { return };
            if let Some(part) = column.get_mut(first..end) {
                let mut x = [R::ZERO; K];
                for (x, u) in x.iter_mut().zip(part.iter()) {
                    *x = *u;
                }
                for (u, y) in part.iter_mut().zip(mapped(x)) {
                    *u = y;
                }
            }
        }
    }

    /// The factors of the mapped columns, and what the rows above have along them.
    fn store<const K: usize>(
        &mut self,
        first: usize,
        mut rows: [[R; K]; K],
        mut above: [[R; K]; N],
        weights: &[R; K],
    ) {
        let (u, d) = orthogonalise(&mut rows, weights);
        // K columns have K directions, so that a row above is the sum of its parts along the orthogonal rows.
        // Backwards through two arrays at once, the standard library keeps a path that panics.
        for c in (0..K).rev() {
            let (Some(row), Some(&d)) = (rows.get(c), d.get(c)) else { return };
            let Some((column, slot)) = self.column_mut(first + c) else { return };
            *slot = d;
            let inverse = R::select(R::ZERO.less(d), R::ONE / d, R::ZERO);
            for ((r, cell), above) in column.iter_mut().enumerate().zip(&mut above) {
                if let Some(i) = r.checked_sub(first) {
                    *cell = u.get(i).and_then(|u| u.get(c)).copied().unwrap_or(R::ZERO);
                    continue;
                }
                let mut along = R::ZERO;
                for ((a, w), weight) in above.iter().zip(row).zip(weights) {
                    along = along + *a * *w * *weight;
                }
                *cell = along * inverse;
                for (a, w) in above.iter_mut().zip(row) {
                    *a = *a - *cell * *w;
                }
            }
        }
    }
}
