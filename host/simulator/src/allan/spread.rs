//! How the points of one record scatter, and how together: their covariance under a model.
//!
//! With C(u) = E[d_a(t)d_b(t + u)] of differences over two lengths of clusters,
//! cov(σ_a², σ_b²) = Σ n(u)·2C²(u)/(M_a M_b 4τ_a²τ_b²) over the n(u) pairs at each lag u; a ramp, whose
//! differences have the means μ, adds 4μ_aμ_bC(u).
//! Source: Isserlis' theorem; s(t) of `schuler::allan::term`.

use super::matrix::Matrix;
use super::shape::Shape;
use schuler::allan::octaves::Point;

/// Octaves further apart are taken as independent: their correlations are at most √(1/2⁶) and count by their squares.
const FARTHEST: usize = 6;

/// Two octaves of one record.
struct Pair {
    a: usize,
    b: usize,
    /// A lag, s.
    step_s: f64,
    /// Lengths of clusters, in lags.
    lengths: [i64; 2],
    /// The first lag, and how many pairs of differences have it and each of the next.
    first: i64,
    counts: Vec<f64>,
}

/// The lags of a record's octaves, and the terms that were asked for at them.
pub struct Spread {
    points: Vec<Point<f64>>,
    pairs: Vec<Pair>,
}

impl Spread {
    /// Of a record's points.
    pub fn new(points: &[Point<f64>]) -> Self {
        let octaves = 0..points.len();
        let pairs =
            octaves.flat_map(|a| (a..points.len().min(a + FARTHEST + 1)).map(move |b| (a, b)));
        Self {
            points: points.to_vec(),
            pairs: pairs.map(|(a, b)| Pair::new(a, b, &points[a], &points[b])).collect(),
        }
    }

    /// C(u) of a term at every lag of every pair.
    pub fn correlations(&self, shape: Shape) -> Vec<Vec<f64>> {
        self.pairs.iter().map(|pair| pair.correlations(shape)).collect()
    }

    /// The covariance of the points where the squares of the terms' magnitudes are these.
    pub fn covariance(&self, shapes: &[Shape], all: &[&Vec<Vec<f64>>], squares: &[f64]) -> Matrix {
        let n = self.points.len();
        let mut covariance = vec![vec![0.0; n]; n];
        let ramp = shapes.iter().zip(squares).find(|(shape, _)| **shape == Shape::Ramp);
        let ramp = ramp.map_or(0.0, |(_, square)| *square);
        for (i, pair) in self.pairs.iter().enumerate() {
            let (a, b) = (&self.points[pair.a], &self.points[pair.b]);
            // μ = Rτ²
            let means = ramp * (a.tau_s * b.tau_s).powi(2);
            let mut sum = 0.0;
            for (lag, count) in pair.counts.iter().enumerate() {
                let terms = all.iter().zip(squares).filter(|(_, square)| **square > 0.0);
                let c: f64 = terms.map(|(all, square)| square * all[i][lag]).sum();
                sum += count * (2.0 * c * c + 4.0 * means * c);
            }
            let scale = 4.0 * (a.tau_s * b.tau_s).powi(2);
            let value = sum / (a.differences as f64 * b.differences as f64 * scale);
            covariance[pair.a][pair.b] = value;
            covariance[pair.b][pair.a] = value;
        }
        covariance
    }
}

impl Pair {
    fn new(a: usize, b: usize, first: &Point<f64>, second: &Point<f64>) -> Self {
        let stride = |point: &Point<f64>| (point.samples / u64::from(point.per_cluster())) as i64;
        let of_one = stride(first);
        let lengths = [first, second].map(|point| point.samples as i64 / of_one);
        let jump = stride(second) / of_one;
        let [short, long] = lengths;
        // Beyond the clusters themselves, where flicker alone has correlations.
        let air = 2 * long;
        let from = -(2 * short + air);
        let count = |lag: i64| {
            // The differences of b that end 2τ_b + j·jump, of a that end 2τ_a + i.
            let off = 2 * short + lag - 2 * long;
            let least = off.div_euclid(jump) + i64::from(off.rem_euclid(jump) != 0);
            let most = (off + first.differences as i64 - 1).div_euclid(jump);
            (most.min(second.differences as i64 - 1) - least.max(0) + 1).max(0) as f64
        };
        let counts = (from..=2 * long + air).map(count).collect();
        let step_s = first.tau_s / short as f64;
        Self { a, b, step_s, lengths, first: from, counts }
    }

    fn correlations(&self, shape: Shape) -> Vec<f64> {
        let [a, b] = self.lengths;
        // s at every multiple of the step that is asked for.
        let begin = self.first - 2 * b;
        let end = self.first + self.counts.len() as i64 + 2 * a;
        let s: Vec<f64> = (begin..end).map(|t| shape.covariance(t as f64 * self.step_s)).collect();
        let weights = [1.0, -2.0, 1.0];
        let at = |lag: i64| {
            let mut sum = 0.0;
            for (p, wa) in (0..).zip(weights) {
                for (q, wb) in (0..).zip(weights) {
                    sum += wa * wb * s[(lag + p * a - q * b - begin) as usize];
                }
            }
            sum
        };
        (0..self.counts.len() as i64).map(|i| at(self.first + i)).collect()
    }
}
