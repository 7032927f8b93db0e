//! A covariance as a full matrix in double precision, by the textbook: what factors are compared with.

pub const N: usize = 15;
pub type Matrix = Vec<[f64; N]>;

pub fn zero() -> Matrix {
    vec![[0.0; N]; N]
}

pub fn diagonal(sigmas: [f64; N]) -> Matrix {
    let mut p = zero();
    for (n, sigma) in sigmas.into_iter().enumerate() {
        p[n][n] = sigma * sigma;
    }
    p
}

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    let mut c = zero();
    for i in 0..N {
        for k in 0..N {
            let x = a[i][k];
            if x != 0.0 {
                for j in 0..N {
                    c[i][j] += x * b[k][j];
                }
            }
        }
    }
    c
}

fn transpose(a: &Matrix) -> Matrix {
    let mut t = zero();
    for i in 0..N {
        for j in 0..N {
            t[j][i] = a[i][j];
        }
    }
    t
}

/// A·P·Aᵀ.
pub fn mapped(a: &Matrix, p: &Matrix) -> Matrix {
    let mut q = product(&product(a, p), &transpose(a));
    let mirrored = transpose(&q);
    for (row, other) in q.iter_mut().zip(&mirrored) {
        for (x, y) in row.iter_mut().zip(other) {
            *x = 0.5 * (*x + y);
        }
    }
    q
}

/// P + q·a·aᵀ.
pub fn add(p: &mut Matrix, q: f64, a: &[f64]) {
    for i in 0..a.len() {
        for j in 0..a.len() {
            p[i][j] += q * a[i] * a[j];
        }
    }
}

/// (I − kh)P(I − kh)ᵀ + krkᵀ: the true covariance after a gain, whatever gain it is (Joseph).
pub fn measured(p: &Matrix, h: &[f64; N], k: &[f64; N], r: f64) -> Matrix {
    let mut rest = zero();
    for i in 0..N {
        for j in 0..N {
            rest[i][j] = f64::from(u8::from(i == j)) - k[i] * h[j];
        }
    }
    let mut q = mapped(&rest, p);
    add(&mut q, r, k);
    q
}

/// The optimal gain.
pub fn gain(p: &Matrix, h: &[f64; N], r: f64) -> [f64; N] {
    let along: Vec<f64> = p.iter().map(|row| row.iter().zip(h).map(|(a, b)| a * b).sum()).collect();
    let alpha: f64 = r + along.iter().zip(h).map(|(a, b)| a * b).sum::<f64>();
    core::array::from_fn(|n| along[n] / alpha)
}
