//! Modified weighted Gram-Schmidt: the factors of W·D·Wᵀ.
//!
//! ```
//! use schuler::aiding::covariance::gram_schmidt::orthogonalise;
//!
//! // Two states out of three independent sources.
//! let mut rows = [[1.0_f64, 0.0, 1.0], [0.0, 1.0, 1.0]];
//! let (u, d) = orthogonalise(&mut rows, &[1.0, 2.0, 3.0]);
//! // P = [[4, 3], [3, 5]]
//! assert_eq!(d[1], 5.0);
//! assert!((u[0][1] - 0.6).abs() < 1e-15 && (d[0] - 2.2).abs() < 1e-15);
//! ```

use crate::math::real::Real;

/// Σ a·b.
#[inline(always)]
fn dot<R: Real, const C: usize>(a: &[R; C], b: &[R; C]) -> R {
    a.iter().zip(b).fold(R::ZERO, |sum, (a, b)| sum + *a * *b)
}

/// U by rows, of which only what is above the diagonal counts, and D; the rows of W become orthogonal.
#[inline]
pub fn orthogonalise<R: Real, const M: usize, const C: usize>(
    rows: &mut [[R; C]; M],
    weights: &[R; C],
) -> ([[R; M]; M], [R; M]) {
    let (mut u, mut d) = ([[R::ZERO; M]; M], [R::ZERO; M]);
    let mut rest = rows.as_mut_slice();
    for j in (0..M).rev() {
        let Some((row, before)) = rest.split_last_mut() else { break };
        // D_j = Σ D w_j²,  U_ij = Σ D w_i w_j/D_j,  w_i ← w_i − U_ij w_j
        let mut weighted = *row;
        for (w, weight) in weighted.iter_mut().zip(weights) {
            *w = *w * *weight;
        }
        let length = dot(row, &weighted);
        // A row of length 0 is a state that is known exactly: nothing is along it.
        let inverse = R::select(R::ZERO.less(length), R::ONE / length, R::ZERO);
        if let Some(d) = d.get_mut(j) {
            *d = length;
        }
        for (above, u) in before.iter_mut().zip(&mut u) {
            let along = dot(above, &weighted) * inverse;
            if let Some(u) = u.get_mut(j) {
                *u = along;
            }
            for (a, w) in above.iter_mut().zip(row.iter()) {
                *a = *a - along * *w;
            }
        }
        rest = before;
    }
    (u, d)
}
