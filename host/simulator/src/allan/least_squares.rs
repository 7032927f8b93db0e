//! Least squares whose unknowns are not negative.
//!
//! Source: Lawson & Hanson, *Solving Least Squares Problems*, chapter 23, on the normal equations.

use super::matrix::{Matrix, factor, forward, inverse};

/// Unknowns that are not negative, and how well those above 0 are known.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// The unknowns.
    pub values: Vec<f64>,
    /// Their standard deviations; for one that is 0, what it would have beside the others.
    pub sigmas: Vec<f64>,
}

/// Minimises ½xᵀGx − bᵀx over x ≥ 0, G the matrix and b the right side of the normal equations.
pub fn solve(normal: &Matrix, right: &[f64]) -> Solution {
    let n = right.len();
    // Unknowns in units in which G has a diagonal of 1.
    let unit: Vec<f64> = (0..n).map(|i| normal[i][i].max(f64::MIN_POSITIVE).sqrt()).collect();
    let scaled = |i: usize, j: usize| normal[i][j] / (unit[i] * unit[j]);
    let b: Vec<f64> = right.iter().zip(&unit).map(|(b, unit)| b / unit).collect();
    let among = |set: &[usize]| -> Matrix {
        set.iter().map(|&i| set.iter().map(|&j| scaled(i, j)).collect()).collect()
    };
    let mut x = vec![0.0; n];
    let mut free: Vec<usize> = Vec::new();
    let mut refused: Vec<usize> = Vec::new();
    // Each pass frees one unknown; more than this it takes only where rounding goes in circles.
    for _ in 0..10 * n {
        let slope = |i: usize| b[i] - (0..n).map(|j| scaled(i, j) * x[j]).sum::<f64>();
        let bound = (0..n).filter(|i| !free.contains(i) && !refused.contains(i));
        let next = bound.map(|i| (slope(i), i)).max_by(|a, b| a.0.total_cmp(&b.0));
        let Some((_, next)) = next.filter(|(slope, _)| *slope > 1e-10) else { break };
        free.push(next);
        loop {
            let Some(l) = factor(&among(&free)) else {
                // It says nothing that the others do not say.
                free.retain(|i| *i != next);
                refused.push(next);
                break;
            };
            let inverse = inverse(&l);
            let best: Vec<f64> = inverse
                .iter()
                .map(|row| row.iter().zip(&free).map(|(g, &j)| g * b[j]).sum())
                .collect();
            if best.iter().all(|value| *value > 0.0) {
                free.iter().zip(&best).for_each(|(&i, best)| x[i] = *best);
                break;
            }
            // As far as the first that would be negative.
            let steps = free.iter().zip(&best).filter(|(_, best)| **best <= 0.0);
            let step = steps.map(|(&i, best)| x[i] / (x[i] - best)).fold(1.0, f64::min);
            for (&i, best) in free.iter().zip(&best) {
                x[i] += step * (best - x[i]);
            }
            free.retain(|&i| x[i] > 1e-14);
            (0..n).filter(|i| !free.contains(i)).for_each(|i| x[i] = 0.0);
            if free.is_empty() {
                break;
            }
        }
    }
    let sigma = |i: usize| {
        let mut set = free.clone();
        if !set.contains(&i) {
            set.push(i);
        }
        let place = set.iter().position(|j| *j == i).unwrap_or(0);
        let unit_vector: Vec<f64> =
            (0..set.len()).map(|j| f64::from(u8::from(j == place))).collect();
        let variance = factor(&among(&set))
            .map(|l| forward(&l, &unit_vector).iter().map(|x| x * x).sum::<f64>());
        variance.map_or(f64::INFINITY, f64::sqrt) / unit[i]
    };
    let sigmas = (0..n).map(sigma).collect();
    Solution { values: x.iter().zip(&unit).map(|(x, unit)| x / unit).collect(), sigmas }
}
