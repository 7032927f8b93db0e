//! The terms that make an Allan variance: non-negative weighted least squares.
//!
//! σ²(τ) is linear in the squares of the magnitudes. The weights are the inverse of the points' covariance
//! under the model itself, so they are found in rounds. What remains is judged by χ² of the cube roots, which are
//! nearly normal even of one degree of freedom (Wilson & Hilferty).

use super::least_squares::{self, Solution};
use super::matrix::{Matrix, factor, forward};
use super::shape::Shape;
use super::spread::Spread;
use schuler::allan::octaves::Point;
use statrs::distribution::{ChiSquared, ContinuousCDF};

/// How often the weights are found anew.
const ROUNDS: usize = 6;

/// How often correlations are taken for less before there are none.
const MOST_SHRUNK: usize = 400;

/// With fewer degrees of freedom the quantile of χ² is no bound worth telling.
const LEAST_FREEDOM: f64 = 6.0;

/// The standard deviations of a two-sided 95 % interval.
pub const NORMAL_95: f64 = 1.959964;

/// A term with its magnitude.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found {
    /// What it is.
    pub shape: Shape,
    /// The square of its magnitude.
    pub square: f64,
    /// The standard deviation of the square.
    pub sigma: f64,
    /// The same if the term were absent: what the other terms alone make of it.
    pub sigma_absent: f64,
}

impl Found {
    /// A square with the standard deviation that it has whatever its size.
    pub fn new(shape: Shape, square: f64, sigma: f64) -> Self {
        Self { shape, square, sigma, sigma_absent: sigma }
    }

    /// The magnitude.
    pub fn magnitude(&self) -> f64 {
        self.square.sqrt()
    }

    /// The 95 % interval of the magnitude. A larger term scatters more: a square s with the variance
    /// σ₀² + (σ² − σ₀²)(s/p)², σ₀ where the term is absent and σ where it is the p that was found. Downwards it is
    /// taken as normal, so that it may be 0; upwards as χ² of 2p²/σ² degrees of freedom.
    pub fn interval(&self) -> [f64; 2] {
        let (p, off) = (self.square, NORMAL_95 * self.sigma);
        let absent = (NORMAL_95 * self.sigma_absent.min(self.sigma)).powi(2);
        // The lesser root of (p − s)² = a + b s²
        let rest = p * p - absent;
        let growth = (off * off - absent) / (p * p);
        let least = if rest > 0.0 { rest / (p + (absent + growth * rest).sqrt()) } else { 0.0 };
        let freedom = 2.0 * (p / self.sigma).powi(2);
        let share = 2.0 / (9.0 * freedom.max(LEAST_FREEDOM));
        // Wilson and Hilferty's quantile.
        let quantile = (1.0 - share - NORMAL_95 * share.sqrt()).powi(3);
        [least.sqrt(), (p / quantile).max(p + off).sqrt()]
    }

    /// Whether it can be told from nothing in this span.
    pub fn is_identified(&self) -> bool {
        self.square > NORMAL_95 * self.sigma
    }
}

/// Terms fitted to a record's points.
#[derive(Clone, Debug, PartialEq)]
pub struct Fit {
    /// A term for each shape.
    pub terms: Vec<Found>,
    /// What the model expects at each point.
    pub expected: Vec<f64>,
    /// The degrees of freedom of each point under the model.
    pub freedom: Vec<f64>,
    /// χ² of what remains.
    pub chi_square: f64,
    /// Its degrees of freedom.
    pub left: usize,
}

impl Fit {
    /// How likely a χ² so large is where the model holds.
    pub fn probability(&self) -> f64 {
        ChiSquared::new(self.left.max(1) as f64).map_or(1.0, |chi| 1.0 - chi.cdf(self.chi_square))
    }
}

/// The fitter of a record: what does not depend on the values is found once.
pub struct Fitter {
    points: Vec<Point<f64>>,
    spread: Spread,
    /// C(u) of the shapes that were asked for.
    known: Vec<(Shape, Vec<Vec<f64>>)>,
}

impl Fitter {
    /// Of points with enough differences to say something.
    pub fn new(points: &[Point<f64>]) -> Self {
        Self { points: points.to_vec(), spread: Spread::new(points), known: Vec::new() }
    }

    /// The points.
    pub fn points(&self) -> &[Point<f64>] {
        &self.points
    }

    /// Learns a shape.
    fn learn(&mut self, shapes: &[Shape]) {
        for shape in shapes {
            if !self.known.iter().any(|(known, _)| known == shape) {
                // Correlation times are many; the power laws stay.
                if self.known.len() > 40 {
                    self.known.retain(|(known, _)| !matches!(known, Shape::GaussMarkov(_)));
                }
                self.known.push((*shape, self.spread.correlations(*shape)));
            }
        }
    }

    /// The covariance of the points where terms have these squares.
    fn covariance(&self, shapes: &[Shape], squares: &[f64]) -> Matrix {
        let all: Vec<_> = shapes
            .iter()
            .filter_map(|shape| self.known.iter().find(|(known, _)| known == shape))
            .map(|(_, correlations)| correlations)
            .collect();
        self.spread.covariance(shapes, &all, squares)
    }

    /// Fits terms of some shapes to variances at the points.
    pub fn fit(&mut self, variances: &[f64], shapes: &[Shape]) -> Fit {
        let mut fit = self.try_fit(variances, shapes);
        let squares: Vec<f64> = fit.terms.iter().map(|found| found.square).collect();
        for (i, found) in fit.terms.iter_mut().enumerate().filter(|(_, found)| found.square > 0.0) {
            let mut others = squares.clone();
            others[i] = 0.0;
            if others.iter().any(|square| *square > 0.0) {
                let absent = self.solve_as(variances, shapes, shapes, &others);
                found.sigma_absent = absent.sigmas[i];
            }
        }
        fit
    }

    /// The same, with intervals that are a little long downwards.
    pub fn try_fit(&mut self, variances: &[f64], shapes: &[Shape]) -> Fit {
        self.learn(shapes);
        let columns = columns(&self.points, shapes);
        // First as if each point were white noise of its own size.
        let own: Vec<f64> = self
            .points
            .iter()
            .zip(variances)
            .map(|(point, variance)| {
                let edf = point.freedom(Shape::White.term());
                2.0 * variance * variance / edf
            })
            .collect();
        let n = own.len();
        let mut covariance: Matrix = vec![vec![0.0; n]; n];
        own.iter().enumerate().for_each(|(i, own)| covariance[i][i] = own.max(f64::MIN_POSITIVE));
        let mut solution = weighted(&columns, variances, &covariance);
        for _ in 0..ROUNDS {
            if solution.values.iter().all(|square| *square == 0.0) {
                break;
            }
            covariance = self.covariance(shapes, &solution.values);
            solution = weighted(&columns, variances, &covariance);
        }
        self.judge(variances, shapes, solution)
    }

    /// What remains where terms are as they are said to be.
    pub fn judge_as(&mut self, variances: &[f64], shapes: &[Shape], squares: &[f64]) -> Fit {
        self.learn(shapes);
        let sigmas = vec![0.0; squares.len()];
        let mut fit = self.judge(variances, shapes, Solution { values: squares.to_vec(), sigmas });
        fit.left = self.points.len();
        fit
    }

    /// Fits terms with the weights of a model that is known.
    pub fn solve_as(
        &mut self,
        variances: &[f64],
        shapes: &[Shape],
        model: &[Shape],
        squares: &[f64],
    ) -> Solution {
        self.learn(model);
        weighted(&columns(&self.points, shapes), variances, &self.covariance(model, squares))
    }

    /// χ² of what terms of some shapes leave at best, with the weights of a model that is known.
    pub fn off_as(
        &mut self,
        variances: &[f64],
        shapes: &[Shape],
        model: &[Shape],
        squares: &[f64],
    ) -> f64 {
        let solution = self.solve_as(variances, shapes, model, squares);
        let expected = expected(&columns(&self.points, shapes), &solution.values);
        let rest: Vec<f64> = variances.iter().zip(expected).map(|(v, e)| v - e).collect();
        let l = definite(self.covariance(model, squares));
        forward(&l, &rest).iter().map(|x| x * x).sum()
    }

    fn judge(&self, variances: &[f64], shapes: &[Shape], solution: Solution) -> Fit {
        let columns = columns(&self.points, shapes);
        let expected = expected(&columns, &solution.values);
        let covariance = self.covariance(shapes, &solution.values);
        let freedom: Vec<f64> = expected
            .iter()
            .enumerate()
            .map(|(i, expected)| {
                // A ramp alone does not scatter.
                let most = self.points[i].differences as f64;
                (2.0 * expected * expected / covariance[i][i]).clamp(0.5, most)
            })
            .collect();
        let z: Vec<f64> = variances
            .iter()
            .zip(&expected)
            .zip(&freedom)
            .map(|((variance, expected), edf)| {
                let share = 2.0 / (9.0 * edf);
                ((variance / expected).cbrt() - (1.0 - share)) / share.sqrt()
            })
            .collect();
        let n = z.len();
        let correlation: Matrix = (0..n)
            .map(|i| {
                let scale = |j: usize| (covariance[i][i] * covariance[j][j]).sqrt();
                (0..n).map(|j| covariance[i][j] / scale(j)).collect()
            })
            .collect();
        let chi_square = forward(&definite(correlation), &z).iter().map(|z| z * z).sum();
        let used = solution.values.iter().filter(|square| **square > 0.0).count();
        let found = shapes.iter().zip(&solution.values).zip(&solution.sigmas);
        let terms = found.map(|((&shape, &square), &sigma)| Found::new(shape, square, sigma));
        let terms = terms.collect();
        Fit { terms, expected, freedom, chi_square, left: n.saturating_sub(used).max(1) }
    }
}

/// Each shape at each point.
fn columns(points: &[Point<f64>], shapes: &[Shape]) -> Vec<Vec<f64>> {
    let column = |shape: &Shape| points.iter().map(|point| shape.variance(point.tau_s)).collect();
    shapes.iter().map(column).collect()
}

fn expected(columns: &[Vec<f64>], squares: &[f64]) -> Vec<f64> {
    let n = columns.first().map_or(0, Vec::len);
    let at = |i: usize| columns.iter().zip(squares).map(|(column, x)| x * column[i]).sum();
    (0..n).map(at).collect()
}

/// Least squares with the inverse of a covariance as weights.
fn weighted(columns: &[Vec<f64>], variances: &[f64], covariance: &Matrix) -> Solution {
    let l = definite(covariance.clone());
    let whitened: Vec<_> = columns.iter().map(|column| forward(&l, column)).collect();
    let measured = forward(&l, variances);
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
    let normal: Matrix =
        whitened.iter().map(|a| whitened.iter().map(|b| dot(a, b)).collect()).collect();
    let right: Vec<_> = whitened.iter().map(|a| dot(a, &measured)).collect();
    least_squares::solve(&normal, &right)
}

/// The factor of a covariance. Octaves that were taken as independent may leave it indefinite: then all
/// correlations are taken for a little less, until it is definite.
fn definite(mut covariance: Matrix) -> Matrix {
    for _ in 0..MOST_SHRUNK {
        if let Some(l) = factor(&covariance) {
            return l;
        }
        for (i, row) in covariance.iter_mut().enumerate() {
            for (j, value) in row.iter_mut().enumerate() {
                if i == j {
                    // Also of what does not scatter at all.
                    *value = value.max(f64::MIN_POSITIVE);
                } else {
                    *value *= 0.9;
                }
            }
        }
    }
    // No number of them is finite, or nothing scatters.
    let n = covariance.len();
    (0..n).map(|i| (0..n).map(|j| f64::from(u8::from(i == j))).collect()).collect()
}
