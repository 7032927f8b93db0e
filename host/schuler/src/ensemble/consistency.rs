//! Whether states scatter together as theory's covariance says.
//!
//! With x a run's deviation from theory's mean and P theory's covariance, ε = xᵀP⁻¹x is χ² with as many degrees of
//! freedom as there are states (the normalized estimation error squared; Bar-Shalom, Li and Kirubarajan, Estimation with
//! Applications to Tracking and Navigation, 2001, section 5.4), and Σε over n runs χ² with n times as many.

use super::spread::Matrix;
use super::statistics::{Test, tails};
use super::values::Values;

/// States that go together: what they are called, and which of the nine they are.
pub const GROUPS: [(&str, std::ops::Range<usize>); 4] = [
    ("all states together", 0..9),
    ("the position", 0..3),
    ("the velocity", 3..6),
    ("the attitude", 6..9),
];

/// What entries of theory's covariance may be off by beside the variances: it takes noise as continuous, and
/// interpolates.
const THEORY: f64 = 1e-5;

/// What other states leave of a state's variance, as a share, so that it is tested: what theory is off by there shifts
/// ε by a third of the scatter of its mean, √(2/n), at most.
fn least_own(runs: usize) -> f64 {
    3.0 * THEORY * (0.5 * runs as f64).sqrt()
}

/// A group of states at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Consistency {
    /// Seconds since the start.
    pub time_s: f64,
    /// Which of [`GROUPS`].
    pub group: usize,
    /// How many of its states scatter by themselves: those that follow from others are left out.
    pub states: usize,
    /// How many runs.
    pub runs: usize,
    /// The mean of ε over the runs: `states` is expected.
    pub mean: f64,
    /// Of Σε.
    pub test: Test,
}

impl Consistency {
    /// Of a group of states, as far as they are tested; `None` of fewer than two.
    pub fn new(
        time_s: f64,
        group: usize,
        values: &Values,
        mean: &[f64; 9],
        covariance: &Matrix,
        tested: &[bool; 9],
    ) -> Option<Self> {
        let (_, range) = GROUPS.get(group)?;
        let wanted: Vec<usize> = range.clone().filter(|&i| tested[i]).collect();
        let factor = Factor::new(covariance, &wanted, least_own(values.numbers.len()));
        let states = factor.order.len();
        if states < 2 {
            return None;
        }
        let sum: f64 = values
            .numbers
            .iter()
            .map(|x| factor.square(&std::array::from_fn(|i| x[i] - mean[i])))
            .sum();
        let runs = values.numbers.len();
        let (below, above) = tails((runs * states) as f64, sum);
        let probability = (2.0 * below.min(above)).min(1.0);
        let test = Test { chi_square: sum, probability };
        Some(Self { time_s, group, states, runs, mean: sum / runs as f64, test })
    }
}

/// Cholesky's factor of a covariance scaled to unit variances, the state with the most variance of its own next.
struct Factor {
    /// The states, in the order of the rows.
    order: Vec<usize>,
    /// Their σ.
    sigma: Vec<f64>,
    /// The rows, each up to its own column.
    rows: Vec<Vec<f64>>,
}

impl Factor {
    /// Of these states, less those of which the others leave less than a share.
    fn new(covariance: &Matrix, wanted: &[usize], least_own: f64) -> Self {
        let mut factor = Self { order: Vec::new(), sigma: Vec::new(), rows: Vec::new() };
        let mut left = wanted.to_vec();
        loop {
            let candidates = left.iter().enumerate().map(|(place, &state)| {
                let (row, own) = factor.row(covariance, state);
                (place, row, own)
            });
            let Some((place, mut row, own)) = candidates.max_by(|a, b| a.2.total_cmp(&b.2)) else {
                break;
            };
            if own < least_own {
                break;
            }
            row.push(own.sqrt());
            let state = left.remove(place);
            factor.order.push(state);
            factor.sigma.push(covariance[state][state].sqrt());
            factor.rows.push(row);
        }
        factor
    }

    /// A further state's row, and the variance of its own that is left beside it, as a share.
    fn row(&self, covariance: &Matrix, state: usize) -> (Vec<f64>, f64) {
        let sigma = covariance[state][state].sqrt();
        let mut row: Vec<f64> = Vec::new();
        for ((&other, other_sigma), other_row) in self.order.iter().zip(&self.sigma).zip(&self.rows)
        {
            let dot: f64 = row.iter().zip(other_row).map(|(a, b)| a * b).sum();
            let correlation = covariance[state][other] / (sigma * other_sigma);
            let diagonal = other_row.last().copied().unwrap_or(f64::NAN);
            row.push((correlation - dot) / diagonal);
        }
        let own = 1.0 - row.iter().map(|x| x * x).sum::<f64>();
        (row, own)
    }

    /// xᵀP⁻¹x, by forward substitution.
    fn square(&self, x: &[f64; 9]) -> f64 {
        let mut solved: Vec<f64> = Vec::with_capacity(self.order.len());
        for ((&state, sigma), row) in self.order.iter().zip(&self.sigma).zip(&self.rows) {
            let dot: f64 = row.iter().zip(&solved).map(|(a, b)| a * b).sum();
            let diagonal = row.last().copied().unwrap_or(f64::NAN);
            solved.push((x[state] / sigma - dot) / diagonal);
        }
        solved.iter().map(|y| y * y).sum()
    }
}
