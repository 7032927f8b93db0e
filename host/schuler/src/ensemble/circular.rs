//! The circle about the truth that holds a share of horizontal errors, and the interval that holds a share of
//! vertical ones, of normal distributions.

use statrs::distribution::{ContinuousCDF, Normal};
use std::f64::consts::FRAC_PI_2;

/// Panels of the quadrature, of five points each.
const PANELS: usize = 48;
/// Beyond so many σ there is nothing.
const FAR: f64 = 9.0;
/// Gauss's five points on (−1, 1), and their weights.
const POINTS: [(f64, f64); 5] = [
    (-0.906_179_845_938_664, 0.236_926_885_056_189_08),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (0.906_179_845_938_664, 0.236_926_885_056_189_08),
];

/// A normal distribution in the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// North and east.
    pub mean: [f64; 2],
    /// Of north and east.
    pub covariance: [[f64; 2]; 2],
}

/// The main axes of an ellipse of scatter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axes {
    /// The greater and the lesser σ.
    pub sigma: [f64; 2],
    /// Of the greater axis, from north toward east, rad.
    pub direction: f64,
}

impl Plane {
    /// Its ellipse: the eigenvalues of the covariance and the direction of the greater.
    pub fn axes(&self) -> Axes {
        let [[a, b], [_, d]] = self.covariance;
        // λ = (a + d)/2 ± √(((a − d)/2)² + b²)
        let (middle, half) = (0.5 * (a + d), (0.5 * (a - d)).hypot(b));
        let direction = 0.5 * (2.0 * b).atan2(a - d);
        Axes { sigma: [middle + half, middle - half].map(|x| x.max(0.0).sqrt()), direction }
    }

    /// The share of the distribution within a radius of the origin.
    pub fn within(&self, radius: f64) -> f64 {
        let Axes { sigma: [major, minor], direction } = self.axes();
        let (sin, cos) = direction.sin_cos();
        let [north, east] = self.mean;
        let mean = [cos * north + sin * east, cos * east - sin * north];
        if major == 0.0 {
            return if mean[0].hypot(mean[1]) <= radius { 1.0 } else { 0.0 };
        }
        let (from, to) = ((-radius).max(mean[0] - FAR * major), radius.min(mean[0] + FAR * major));
        if from >= to {
            return 0.0;
        }
        // P = ∫ φ(x) [Φ(√(R² − x²)) − Φ(−√(R² − x²))] dx along the greater axis. With x = c + d sin u the root has no
        // edge at the ends.
        let (centre, half) = (0.5 * (from + to), 0.5 * (to - from));
        let width = 2.0 * FRAC_PI_2 / PANELS as f64;
        let mut sum = 0.0;
        for panel in 0..PANELS {
            let middle = -FRAC_PI_2 + (panel as f64 + 0.5) * width;
            for (point, weight) in POINTS {
                let (sin, cos) = (middle + 0.5 * width * point).sin_cos();
                let x = centre + half * sin;
                let chord = (radius * radius - x * x).max(0.0).sqrt();
                let density = (-0.5 * ((x - mean[0]) / major).powi(2)).exp();
                sum += weight * density * between(mean[1], minor, chord) * half * cos;
            }
        }
        0.5 * width * sum / (major * (2.0 * std::f64::consts::PI).sqrt())
    }

    /// The radius about the origin that holds a share of the distribution.
    pub fn radius(&self, share: f64) -> f64 {
        let [north, east] = self.mean;
        let most = north.hypot(east) + FAR * self.axes().sigma[0];
        inverse(share, most, |radius| self.within(radius))
    }
}

/// The bound whose interval about 0 holds a share of a normal distribution.
pub fn bound(mean: f64, sigma: f64, share: f64) -> f64 {
    inverse(share, mean.abs() + FAR * sigma, |bound| between(mean, sigma, bound))
}

/// The share of a normal distribution between −b and b.
fn between(mean: f64, sigma: f64, b: f64) -> f64 {
    match Normal::new(mean, sigma) {
        Ok(law) if sigma > 0.0 => law.cdf(b) - law.cdf(-b),
        _ if mean.abs() <= b => 1.0,
        _ => 0.0,
    }
}

/// Where an increasing function reaches a value, from 0 to a bound, by bisection.
fn inverse(value: f64, most: f64, of: impl Fn(f64) -> f64) -> f64 {
    if !most.is_finite() {
        return f64::NAN;
    }
    let (mut low, mut high) = (0.0, most);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if of(middle) < value { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}
