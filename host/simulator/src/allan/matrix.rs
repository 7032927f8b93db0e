//! Small symmetric matrices: Cholesky's factor, and what is solved with it.

/// A square matrix by rows.
pub type Matrix = Vec<Vec<f64>>;

/// L with A = L·Lᵀ; none where A is not positive definite.
pub fn factor(a: &Matrix) -> Option<Matrix> {
    let mut l: Matrix = vec![vec![0.0; a.len()]; a.len()];
    for (i, row) in a.iter().enumerate() {
        for j in 0..=i {
            let dot: f64 = l[i].iter().zip(&l[j]).take(j).map(|(x, y)| x * y).sum();
            let rest = row[j] - dot;
            if i == j {
                if !(rest > 1e-13 * row[i] && rest.is_finite()) {
                    return None;
                }
                l[i][i] = rest.sqrt();
            } else {
                l[i][j] = rest / l[j][j];
            }
        }
    }
    Some(l)
}

/// x of L·x = b.
pub fn forward(l: &Matrix, b: &[f64]) -> Vec<f64> {
    let mut x: Vec<f64> = Vec::with_capacity(b.len());
    for (row, b) in l.iter().zip(b) {
        let dot: f64 = row.iter().zip(&x).map(|(l, x)| l * x).sum();
        let pivot = row[x.len()];
        x.push((b - dot) / pivot);
    }
    x
}

/// A⁻¹ from its factor.
pub fn inverse(l: &Matrix) -> Matrix {
    let n = l.len();
    let unit = |i: usize| (0..n).map(|j| f64::from(u8::from(i == j))).collect::<Vec<_>>();
    // Columns of L⁻¹; A⁻¹ is their products.
    let columns: Vec<_> = (0..n).map(|i| forward(l, &unit(i))).collect();
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
    columns.iter().map(|a| columns.iter().map(|b| dot(a, b)).collect()).collect()
}
