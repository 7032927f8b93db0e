//! The runs at one instant: mean, covariance, quantiles, extremes.

use super::order::Ordered;
use super::values::Values;

/// The shares of the runs at which quantiles are told.
pub const SHARES: [f64; 5] = [0.025, 0.25, 0.5, 0.75, 0.975];

/// A symmetric matrix over the nine numbers.
pub type Matrix = [[f64; 9]; 9];

/// A value, and the number of the run that has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extreme {
    /// m, m/s, arcsec.
    pub value: f64,
    /// Its number: `schuler run --run` flies it again.
    pub run: u64,
}

/// What the runs do at one instant; m, m/s, arcsec.
#[derive(Clone, Debug, PartialEq)]
pub struct Spread {
    /// Over the runs.
    pub mean: [f64; 9],
    /// About their own mean, over n − 1.
    pub covariance: Matrix,
    /// At [`SHARES`], of each.
    pub quantiles: [[f64; SHARES.len()]; 9],
    /// The least and the greatest of each; the first run that has it.
    pub extremes: [[Extreme; 2]; 9],
}

impl Spread {
    /// Of runs at one instant; there are two at least.
    pub fn new(values: &Values) -> Self {
        let n = values.runs.len() as f64;
        let mean: [f64; 9] =
            std::array::from_fn(|i| values.numbers.iter().map(|x| x[i]).sum::<f64>() / n);
        let mut covariance = Matrix::default();
        for x in &values.numbers {
            let deviation: [f64; 9] = std::array::from_fn(|i| x[i] - mean[i]);
            for (row, a) in covariance.iter_mut().zip(deviation) {
                for (entry, b) in row.iter_mut().zip(deviation) {
                    *entry += a * b;
                }
            }
        }
        let covariance = covariance.map(|row| row.map(|sum| sum / (n - 1.0)));
        let quantiles = std::array::from_fn(|i| {
            let ordered = Ordered::new(values.component(i));
            SHARES.map(|share| ordered.quantile(share))
        });
        let extremes = std::array::from_fn(|i| {
            let better = |sign: f64| {
                let mut best = Extreme { value: f64::NAN, run: 0 };
                for (x, &run) in values.numbers.iter().zip(&values.runs) {
                    if best.value.is_nan() || sign * x[i] > sign * best.value {
                        best = Extreme { value: x[i], run };
                    }
                }
                best
            };
            [better(-1.0), better(1.0)]
        });
        Self { mean, covariance, quantiles, extremes }
    }
}
