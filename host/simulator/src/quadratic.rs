//! Quadratic forms: how far an error is from nothing, measured by a covariance, and what chance makes of their means.

use statrs::distribution::{ChiSquared, ContinuousCDF};

/// eᵀP⁻¹e by Cholesky's factor: L·z = e, P = L·Lᵀ. Not a number where P is no covariance.
pub fn quadratic<const N: usize>(p: &[[f64; N]; N], e: &[f64; N]) -> f64 {
    // Positions in metres beside angles: to unit variances first.
    let scale: [f64; N] = std::array::from_fn(|i| p[i][i].sqrt());
    let mut l = [[0.0; N]; N];
    let mut z = [0.0; N];
    for i in 0..N {
        for j in 0..=i {
            let covered: f64 = (0..j).map(|k| l[i][k] * l[j][k]).sum();
            let rest = p[i][j] / (scale[i] * scale[j]) - covered;
            l[i][j] = if i == j { rest.sqrt() } else { rest / l[j][j] };
        }
        let known: f64 = (0..i).map(|k| l[i][k] * z[k]).sum();
        z[i] = (e[i] / scale[i] - known) / l[i][i];
    }
    z.iter().map(|z| z * z).sum()
}

/// Where 95 % of such forms lie by their expected value, where all of them together have so many degrees of freedom; not
/// numbers where they have none.
pub fn by_chance(freedom: f64) -> [f64; 2] {
    ChiSquared::new(freedom)
        .map_or([f64::NAN; 2], |law| [0.025, 0.975].map(|part| law.inverse_cdf(part) / freedom))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_correlated_error_weighs_as_its_inverse_says() {
        // P = [4 2; 2 3]: P⁻¹ = [3 −2; −2 4]/8
        let p = [[4.0, 2.0], [2.0, 3.0]];
        assert!((quadratic(&p, &[1.0, 2.0]) - (3.0 - 8.0 + 16.0) / 8.0).abs() < 1e-14);
        assert!(quadratic(&[[1.0, 2.0], [2.0, 1.0]], &[1.0, 0.0]).is_nan());
    }
}
