//! The ellipse about its mean that holds a share of a normal distribution in the plane.

use std::f64::consts::TAU;

/// Steps around it.
const STEPS: usize = 96;

/// Its outline, closed. `covariance` is of the two coordinates of `mean`.
pub fn outline(
    mean: [f64; 2],
    covariance: [[f64; 2]; 2],
    share: f64,
) -> impl Iterator<Item = [f64; 2]> {
    // P(χ²₂ ≤ k²) = 1 − e^{−k²/2}; with L·Lᵀ = P, points are m + k·L·(cos t, sin t)
    let k = (-2.0 * (1.0 - share).ln()).sqrt();
    let [[a, b], [_, d]] = covariance;
    let across = a.max(0.0).sqrt();
    let mixed = if across > 0.0 { b / across } else { 0.0 };
    let rest = (d - mixed * mixed).max(0.0).sqrt();
    (0..=STEPS).map(move |step| {
        let (sin, cos) = (step as f64 / STEPS as f64 * TAU).sin_cos();
        [mean[0] + k * across * cos, mean[1] + k * (mixed * cos + rest * sin)]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_point_is_as_far_by_the_inverse_covariance() {
        let (mean, covariance) = ([3.0, -2.0], [[4.0, 1.5], [1.5, 9.0]]);
        let [[a, b], [_, d]] = covariance;
        let determinant = a * d - b * b;
        let points: Vec<_> = outline(mean, covariance, 0.95).collect();
        for [x, y] in &points {
            let (x, y) = (x - mean[0], y - mean[1]);
            // χ² of two freedoms at 95 %: 5.991
            let square = (d * x * x - 2.0 * b * x * y + a * y * y) / determinant;
            assert!((square - 5.991_464_547_107_98).abs() < 1e-9, "{square}");
        }
        assert!((points[0][0] - points[STEPS][0]).abs() < 1e-9);
    }

    #[test]
    fn a_line_and_a_point_are_ellipses_too() {
        let line: Vec<_> = outline([0.0; 2], [[0.0, 0.0], [0.0, 4.0]], 0.5).collect();
        assert!(line.iter().all(|point| point[0] == 0.0));
        assert!(line.iter().any(|point| point[1] > 2.3));
        assert!(outline([1.0; 2], [[0.0; 2]; 2], 0.5).all(|point| point == [1.0; 2]));
    }
}
