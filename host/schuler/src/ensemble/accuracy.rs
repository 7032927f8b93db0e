//! What navigators are specified by: circular and vertical error, and the drift in nautical miles an hour.

use super::circular::{Plane, bound};
use super::order::{Ordered, Quantile};
use super::values::Values;
use crate::report::traces::NAUTICAL_MILE;

/// A figure of the runs, and the same of theory's normal distribution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Figure {
    /// Of the runs, m.
    pub runs: Quantile,
    /// By theory, m; not a number where that has ended.
    pub theory: f64,
}

/// The figures at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Accuracy {
    /// Seconds since the start.
    pub time_s: f64,
    /// The circle about the truth that holds half of the runs.
    pub cep50: Figure,
    /// The one that holds 95 %.
    pub cep95: Figure,
    /// What 95 % of the runs are not farther above or below than.
    pub vertical95: Figure,
}

impl Accuracy {
    /// Of runs at one instant, with theory's mean and covariance, m.
    pub fn new(time_s: f64, values: &Values, mean: [f64; 3], covariance: [[f64; 3]; 3]) -> Self {
        let [north, east, down] = mean;
        let [[a, b, _], [_, d, _], [_, _, vertical]] = covariance;
        let plane = Plane { mean: [north, east], covariance: [[a, b], [b, d]] };
        let radii = values.numbers.iter().map(|x| x[0].hypot(x[1])).collect();
        let heights = values.numbers.iter().map(|x| x[2].abs()).collect();
        let (radii, heights) = (Ordered::new(radii), Ordered::new(heights));
        let circle = |share: f64| Figure {
            runs: radii.with_interval(share),
            theory: if north.is_nan() { f64::NAN } else { plane.radius(share) },
        };
        let vertical95 = Figure {
            runs: heights.with_interval(0.95),
            theory: if down.is_nan() {
                f64::NAN
            } else {
                bound(down, vertical.max(0.0).sqrt(), 0.95)
            },
        };
        Self { time_s, cep50: circle(0.5), cep95: circle(0.95), vertical95 }
    }

    /// The circle that holds half of the runs, over the time flown: nautical miles an hour.
    pub fn nmi_h(&self, metres: f64) -> f64 {
        metres / NAUTICAL_MILE / (self.time_s / 3600.0)
    }
}
