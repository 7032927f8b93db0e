//! Terms that a scene configures, each against what was measured.
//!
//! A term is refused only where its square is off by more than chance explains once in a thousand, both as a normal
//! deviate and as a χ² of its own degrees of freedom: the estimate of a term that shows at few points is neither.

use super::fit::{Fit, Fitter, Found};
use super::shape::Shape;
use crate::scene::SensorErrors;
use schuler::sensor::Timing;

/// Two-sided, 1 in 1000.
const FAR: f64 = 3.2905;
/// χ² of one degree of freedom: 1 in 1000, and 1 in 20.
const FAR_SQUARE: f64 = 10.828;
const NEAR_SQUARE: f64 = 3.841;

/// What is to be said of a term.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// As configured.
    Agrees,
    /// Not as configured.
    Differs,
    /// Nothing of it shows, nor need it.
    NotIdentifiable,
}

impl Verdict {
    /// In words.
    pub fn words(self) -> &'static str {
        match self {
            Self::Agrees => "agrees",
            Self::Differs => "DIFFERS",
            Self::NotIdentifiable => "not identifiable in this span",
        }
    }
}

/// A configured term and what was found of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Compared {
    /// The term, as configured.
    pub shape: Shape,
    /// Its magnitude, as configured.
    pub configured: f64,
    /// What was found.
    pub found: Found,
    /// What is to be said.
    pub verdict: Verdict,
}

/// The configured correlation time and what was found of it, s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ComparedTime {
    /// As configured.
    pub configured_s: f64,
    /// The one that fits best.
    pub found_s: f64,
    /// Its 95 % interval.
    pub interval_s: [f64; 2],
    /// What is to be said.
    pub verdict: Verdict,
}

/// What one axis is configured to do: terms with the squares of their magnitudes.
pub fn configured(errors: &SensorErrors, axis: usize, timing: Timing<f64>) -> Vec<(Shape, f64)> {
    let mut terms = Vec::new();
    let mut add = |shape, magnitude: f64| {
        if magnitude > 0.0 {
            terms.push((shape, magnitude * magnitude));
        }
    };
    if let Some(step) = errors.quantization {
        add(Shape::Quantization, step[axis] / 12f64.sqrt());
    }
    if let Some(density) = errors.white {
        add(Shape::White, density[axis]);
    }
    if let Some(instability) = errors.bias_instability {
        add(Shape::Flicker(timing), instability[axis]);
    }
    if let Some(density) = errors.random_walk {
        add(Shape::RandomWalk, density[axis]);
    }
    if let Some(process) = errors.gauss_markov {
        add(Shape::GaussMarkov(process.correlation_s[axis]), process.rms[axis]);
    }
    terms
}

/// Compares each configured term, the correlation time, and the whole.
pub fn compare(
    fitter: &mut Fitter,
    variances: &[f64],
    terms: &[(Shape, f64)],
) -> (Vec<Compared>, Option<ComparedTime>, Fit) {
    let (shapes, squares): (Vec<_>, Vec<_>) = terms.iter().copied().unzip();
    let whole = fitter.judge_as(variances, &shapes, &squares);
    let solution = fitter.solve_as(variances, &shapes, &shapes, &squares);
    let found = shapes.iter().zip(&solution.values).zip(&solution.sigmas);
    let found = found.map(|((&shape, &square), &sigma)| Found::new(shape, square, sigma));
    let compared = found.zip(&squares).map(|(found, &square)| {
        let verdict = if is_far(found.square, square, found.sigma) {
            Verdict::Differs
        } else if square > 1.96 * found.sigma {
            Verdict::Agrees
        } else {
            Verdict::NotIdentifiable
        };
        Compared { shape: found.shape, configured: square.sqrt(), found, verdict }
    });
    let compared: Vec<_> = compared.collect();
    let time = time(fitter, variances, &shapes, &squares);
    (compared, time, whole)
}

fn is_far(found: f64, configured: f64, sigma: f64) -> bool {
    let normal = (found - configured) / sigma;
    // Wilson and Hilferty's cube root of a χ² over its degrees of freedom, 2p²/σ².
    let share = (sigma / configured).powi(2) / 9.0;
    let as_square = ((found / configured).cbrt() - (1.0 - share)) / share.sqrt();
    normal.abs() > FAR && as_square.abs() > FAR
}

/// The correlation time, by χ² with the weights of the configured model.
fn time(
    fitter: &mut Fitter,
    variances: &[f64],
    shapes: &[Shape],
    squares: &[f64],
) -> Option<ComparedTime> {
    let place = shapes.iter().position(|shape| matches!(shape, Shape::GaussMarkov(_)))?;
    let Shape::GaussMarkov(configured_s) = *shapes.get(place)? else { return None };
    let mut off = |correlation_s: f64| {
        let mut tried = shapes.to_vec();
        tried[place] = Shape::GaussMarkov(correlation_s);
        fitter.off_as(variances, &tried, shapes, squares)
    };
    let own = off(configured_s);
    // A factor of 100 to both sides, in steps of a factor of 1.15; then golden section.
    let steps: Vec<(f64, f64)> = (-33..=33)
        .map(|i| configured_s * 1.15f64.powi(i))
        .map(|correlation_s| (correlation_s, off(correlation_s)))
        .collect();
    let (near_s, _) = steps.iter().copied().min_by(|a, b| a.1.total_cmp(&b.1))?;
    let found_s = golden([near_s / 1.15, near_s * 1.15], &mut off);
    let least = off(found_s);
    let inside = steps.iter().filter(|(_, off)| *off - least < NEAR_SQUARE).map(|(t, _)| *t);
    let interval_s = inside.fold([found_s; 2], |[from, to], t: f64| [from.min(t), to.max(t)]);
    let [first, last] = [steps.first()?.0, steps.last()?.0];
    let verdict = if own - least > FAR_SQUARE {
        Verdict::Differs
    } else if interval_s[0] <= first || interval_s[1] >= last {
        Verdict::NotIdentifiable
    } else {
        Verdict::Agrees
    };
    Some(ComparedTime { configured_s, found_s, interval_s, verdict })
}

/// Where a function is least between two times; by golden section of their logarithms.
pub fn golden([from, to]: [f64; 2], of: &mut impl FnMut(f64) -> f64) -> f64 {
    let part = (5f64.sqrt() - 1.0) / 2.0;
    let (mut a, mut b) = (from.ln(), to.ln());
    let (mut c, mut d) = (b - part * (b - a), a + part * (b - a));
    let (mut at_c, mut at_d) = (of(c.exp()), of(d.exp()));
    for _ in 0..30 {
        if at_c < at_d {
            (b, d, at_d) = (d, c, at_c);
            c = b - part * (b - a);
            at_c = of(c.exp());
        } else {
            (a, c, at_c) = (c, d, at_d);
            d = a + part * (b - a);
            at_d = of(d.exp());
        }
    }
    (0.5 * (a + b)).exp()
}
