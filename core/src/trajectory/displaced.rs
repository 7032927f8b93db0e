//! The place beside a place: normal and height of a point some metres away.
//!
//! Differences are computed as differences, so that the result is as exact as a double can say it, anywhere
//! on Earth.

use crate::earth::{ECCENTRICITY_SQUARED as E2, SEMI_MAJOR_AXIS};
use crate::math::real::Real;
use crate::math::vector::Vector;

/// Newton steps: the first leaves the displacement squared over the Earth's radius.
const STEPS: usize = 4;

/// Normal and height, m, of a point by the vector to it, m, in Earth-fixed axes; for displacements that are small
/// against the Earth.
pub(super) fn displaced(
    normal: Vector<f64>,
    altitude: f64,
    displacement_e: Vector<f64>,
) -> (Vector<f64>, f64) {
    let root = |sine: f64| Real::sqrt(1.0 - E2 * sine * sine);
    let w = root(normal.z);
    // n̂' = (n̂ + t)/√(1 + t²) with t at right angles to n̂
    let (mut t, mut climb) = (Vector::ZERO, 0.0);
    let mut change = Vector::ZERO;
    for _ in 0..STEPS {
        let n = normal + change;
        let w_there = root(n.z);
        let there = SEMI_MAJOR_AXIS / w_there;
        // N' − N = a e²(σ'² − σ²)/(W W'(W + W'))
        let gained =
            SEMI_MAJOR_AXIS * E2 * change.z * (n.z + normal.z) / (w * w_there * (w + w_there));
        // r' − r = (N' + h')δn̂ + (δN + δh)n̂ − e²(N'δσ + δN σ)ẑ
        let mut moved = change * (there + altitude + climb) + normal * (gained + climb);
        moved.z -= E2 * (there * change.z + gained * normal.z);
        let rest = displacement_e - moved;
        // δn̂ = e/(N + h) + p(e·p) N e²/(W²(R_M + h)(N + h)),  p = ẑ − σn̂
        let up = rest.dot(n);
        let level = rest - n * up;
        let meridian = there * (1.0 - E2) / (w_there * w_there) + altitude + climb;
        let p = Vector::new(0.0, 0.0, 1.0) - n * n.z;
        let turn = there * E2 / (w_there * w_there * meridian);
        let step = (level + p * (level.dot(p) * turn)) * (1.0 / (there + altitude + climb));
        t = t + (step - normal * step.dot(normal));
        climb += up;
        // k − 1 = −t²/(√(1 + t²)(1 + √(1 + t²)))
        let square = t.dot(t);
        let length = Real::sqrt(1.0 + square);
        change = t * (1.0 / length) - normal * (square / (length * (1.0 + length)));
    }
    (normal + change, altitude + climb)
}
