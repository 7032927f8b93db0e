//! Increments from instantaneous rates that stand at the samples' ends.
//!
//! A sample's increment is the integral of the cubic through the rates at four neighbouring
//! instants: two before and two after, or the nearest four at either end of an unbroken stretch,
//! where the very first sample, whose start has no rate, is extrapolated. With even steps h that is
//! h/24·(−f₋₂ + 13f₋₁ + 13f₀ − f₁); its error is 11/720·h⁵f⁗ per sample (19/720 for the second and
//! the last sample, 251/720 for the first). A stretch of fewer rates uses the polynomial through them.

use super::{Sample, stretches};
use schuler::math::vector::Vector;
use schuler::sample::Increment;

/// Instants that a polynomial goes through.
const POINTS: usize = 4;

/// Turns samples that hold rates (rad/s, m/s² in place of rad, m/s) into increments.
pub fn integrate(samples: &mut [Sample], interval_s: f64) {
    let rates = samples.to_vec();
    let mut rest = samples;
    for stretch in stretches(&rates, interval_s) {
        let (head, tail) = rest.split_at_mut(stretch.len());
        rest = tail;
        let points = POINTS.min(stretch.len());
        for (i, sample) in head.iter_mut().enumerate() {
            let from_s = match i {
                0 => sample.time_s - interval_s,
                _ => stretch[i - 1].time_s,
            };
            let first = i.saturating_sub(POINTS / 2).min(stretch.len() - points);
            sample.increment = integral(&stretch[first..first + points], from_s, sample.time_s);
        }
    }
}

/// The integral of the polynomial through some samples' rates.
fn integral(rates: &[Sample], from_s: f64, to_s: f64) -> Increment<f64> {
    // Gauss-Legendre with two nodes, ±1/√3, is exact for a cubic.
    let (centre, half) = (0.5 * (from_s + to_s), 0.5 * (to_s - from_s));
    let offset = half / 3f64.sqrt();
    let mut sum = Increment { angle_b: Vector::ZERO, velocity_b: Vector::ZERO };
    for (j, rate) in rates.iter().enumerate() {
        // Lagrange: ℓⱼ(t) = Π (t − tₖ)/(tⱼ − tₖ)
        let basis = |t: f64| -> f64 {
            let others = rates.iter().enumerate().filter(|(k, _)| *k != j);
            others.map(|(_, other)| (t - other.time_s) / (rate.time_s - other.time_s)).product()
        };
        let weight = half * (basis(centre - offset) + basis(centre + offset));
        sum.angle_b = sum.angle_b + rate.increment.angle_b * weight;
        sum.velocity_b = sum.velocity_b + rate.increment.velocity_b * weight;
    }
    sum
}
