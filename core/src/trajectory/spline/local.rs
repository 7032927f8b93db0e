//! A span of a spline as a polynomial about a time.
//!
//! The values of a span are symmetric and affine in seven arguments (its blossom f): p(t) = f(t, …, t), and
//! p⁽ᵏ⁾(t)/k! = C(7, k) f(δ, …, δ, t, …, t) with k times the direction δ in place of a time. de Boor's scheme puts
//! in one argument after the other. All of it is carried in [`Pair`]s from control points that count as exact, and
//! rounded once: neighbours agree at their joint as far as rounded coefficients can.
//! Source: Ramshaw, Blossoms are polar forms, *Computer Aided Geometric Design* 6 (1989) 323–358;
//! de Boor, *A Practical Guide to Splines*, ch. X.
//!
//! ```
//! use schuler::trajectory::spline::{basis::Knots, local::coefficients};
//!
//! // Control points at the means of seven knots each are the function t.
//! let knots = Knots::eightfold(&[0.0, 2.0]);
//! let control: [[f64; 1]; 8] = core::array::from_fn(|k| [2.0 * k as f64 / 7.0]);
//! let polynomial = coefficients(knots, 0, 1.0, &control).unwrap();
//! assert!((polynomial[0][0].hi - 1.0).abs() < 1e-16);
//! assert!((polynomial[1][0].hi - 1.0).abs() < 1e-15);
//! ```

use super::basis::{KNOTS, Knots};
use super::{DEGREE, TERMS};
use crate::math::compensated::Pair;

/// Pascal's row 7.
const CHOOSE: [f64; TERMS] = [1.0, 7.0, 21.0, 35.0, 35.0, 21.0, 7.0, 1.0];

/// The weights of de Boor's scheme at one time.
struct Weights {
    /// By step, then by entry: 1/(upper − lower).
    inverse: [[Pair<f64>; DEGREE]; DEGREE],
    /// (time − lower)/(upper − lower).
    along: [[Pair<f64>; DEGREE]; DEGREE],
}

impl Weights {
    fn new(knots: &[f64; KNOTS], time: f64) -> Self {
        let zero = [[Pair::default(); DEGREE]; DEGREE];
        let mut this = Self { inverse: zero, along: zero };
        let rows = this.inverse.iter_mut().zip(&mut this.along);
        for (step, (inverse, along)) in rows.enumerate() {
            // Step r takes the entry j between the knots t_{i−6+r+j} and t_{i+1+j}.
            let lower = knots.iter().skip(step);
            let upper = knots.iter().skip(DEGREE);
            let places = inverse.iter_mut().zip(along).take(DEGREE - step);
            for ((inverse, along), (&lower, &upper)) in places.zip(lower.zip(upper)) {
                *inverse = Pair::sum(upper, -lower).reciprocal();
                *along = Pair::sum(time, -lower) * *inverse;
            }
        }
        this
    }
}

/// One step of the scheme on the first entries of a row, which shortens by one.
fn step<const C: usize>(
    row: &mut [[Pair<f64>; C]; TERMS],
    weights: Option<&[Pair<f64>; DEGREE]>,
    number: usize,
    direction: bool,
) {
    let Some(weights) = weights else { return };
    let mut rest = row.as_mut_slice();
    for &weight in weights.iter().take(DEGREE - number) {
        let [entry, next, ..] = rest else { return };
        for (a, &b) in entry.iter_mut().zip(next.iter()) {
            // d ← d + w(d₊ − d), or w(d₊ − d) for the direction
            let difference = (b - *a) * weight;
            *a = if direction { difference } else { *a + difference };
        }
        rest = rest.split_first_mut().map_or(&mut [], |(_, rest)| rest);
    }
}

/// Coefficients of u⁰ to u⁷, u = t − `about`, of each channel over a span between these knots, from its eight
/// control points.
pub fn polynomial<const C: usize>(
    knots: &[f64; KNOTS],
    about: f64,
    control: &[[f64; C]; TERMS],
) -> [[Pair<f64>; C]; TERMS] {
    let weights = Weights::new(knots, about);
    let mut result = [[Pair::default(); C]; TERMS];
    // After k steps in the direction, the rest of the steps at the time itself.
    let mut differences = control.map(|row| row.map(Pair::new));
    for (k, (place, choose)) in result.iter_mut().zip(CHOOSE).enumerate() {
        let mut row = differences;
        for number in k..DEGREE {
            step(&mut row, weights.along.get(number), number, false);
        }
        if let Some(value) = row.first() {
            *place = value.map(|c| c * Pair::new(choose));
        }
        step(&mut differences, weights.inverse.get(k), k, true);
    }
    result
}

/// The same over the span after a site, of a whole spline; nothing for a span that there is not.
pub fn coefficients<const C: usize>(
    knots: Knots<'_>,
    span: usize,
    about: f64,
    control: &[[f64; C]],
) -> Option<[[Pair<f64>; C]; TERMS]> {
    if span + 1 >= knots.sites().len() {
        return None;
    }
    let control = control.get(span..)?.first_chunk::<TERMS>()?;
    Some(polynomial(&knots.around(span), about, control))
}
