//! The terms that a record shows, none of them configured.
//!
//! All of them are fitted; a Gauss-Markov bias, with the correlation time that fits best, is taken only where χ²
//! falls by more than chance explains once in a thousand. Then what cannot be told from nothing is left out,
//! the least certain first.

use super::fit::{Fit, Fitter, Found};
use super::shape::Shape;
use super::verdict::golden;
use schuler::sensor::Timing;

/// χ² of two degrees of freedom, 1 in 1000.
const WORTH: f64 = 13.816;
/// The shapes of a record without a Gauss-Markov bias.
fn power_laws(timing: Timing<f64>) -> Vec<Shape> {
    vec![Shape::Quantization, Shape::White, Shape::Flicker(timing), Shape::RandomWalk, Shape::Ramp]
}

/// What was found of an axis.
#[derive(Clone, Debug)]
pub struct Identified {
    /// The terms that show, and χ² of what they leave.
    pub fit: Fit,
    /// Those that do not, with what all of them together left to each.
    pub hidden: Vec<Found>,
}

/// Finds the terms of an axis.
pub fn identify(fitter: &mut Fitter, variances: &[f64], timing: Timing<f64>) -> Identified {
    let mut shapes = power_laws(timing);
    let mut all = fitter.fit(variances, &shapes);
    let [shortest_s, longest_s] =
        [2.0, 0.3 * timing.samples() as f64].map(|n| n * timing.interval_s());
    if longest_s > 2.0 * shortest_s {
        let mut with = |correlation_s: f64| {
            let mut with = shapes.clone();
            with.push(Shape::GaussMarkov(correlation_s));
            fitter.try_fit(variances, &with)
        };
        let ratio = longest_s / shortest_s;
        let coarse = (0..=12).map(|i| shortest_s * ratio.powf(f64::from(i) / 12.0));
        let tried = coarse.map(|t| (t, with(t).chi_square));
        if let Some((near_s, _)) = tried.min_by(|a, b| a.1.total_cmp(&b.1)) {
            let step = ratio.powf(1.0 / 12.0);
            let best_s = golden([near_s / step, near_s * step], &mut |t| with(t).chi_square);
            let best = with(best_s);
            if all.chi_square - best.chi_square > WORTH {
                shapes.push(Shape::GaussMarkov(best_s));
                all = fitter.fit(variances, &shapes);
            }
        }
    }
    let mut fit = all.clone();
    // The least certain goes first; what is left may well become certain then.
    loop {
        let certainty = |found: &Found| found.square / found.sigma;
        let unsure = fit.terms.iter().filter(|found| !found.is_identified());
        let Some(least) = unsure.min_by(|a, b| certainty(a).total_cmp(&certainty(b))) else {
            break;
        };
        let least = least.shape;
        shapes.retain(|shape| *shape != least);
        if shapes.is_empty() {
            break;
        }
        fit = fitter.fit(variances, &shapes);
    }
    let hidden = all.terms.iter().filter(|found| !shapes.contains(&found.shape)).copied().collect();
    Identified { fit, hidden }
}
