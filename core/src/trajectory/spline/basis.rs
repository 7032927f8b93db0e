//! Knots of a spline, and the eight basis functions that are not 0 in a span.
//!
//! ```
//! use schuler::trajectory::spline::basis::{Knots, values};
//!
//! let sites = [0.0, 1.0, 2.5, 3.0];
//! let knots = Knots::eightfold(&sites);
//! let basis = values(&knots.around(1), 2.0);
//! // The basis is positive and adds up to 1.
//! assert!(basis.iter().all(|&b| b > 0.0));
//! assert!((basis.iter().sum::<f64>() - 1.0).abs() < 1e-15);
//! // At the first site only the first function is left.
//! assert_eq!(values(&knots.around(0), 0.0), [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
//! ```

use super::{DEGREE, TERMS};

/// Number of knots on which a span depends.
pub const KNOTS: usize = 2 * DEGREE;

/// The knots of a spline: its sites, and what stands outside them.
///
/// Either way the splines are the same functions; only their control points differ.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Knots<'a> {
    sites: &'a [f64],
    continued: bool,
}

impl<'a> Knots<'a> {
    /// Both ends are eightfold: control points stay near the path, as interpolation needs.
    pub fn eightfold(sites: &'a [f64]) -> Self {
        Self { sites, continued: false }
    }

    /// The first and the last interval go on: third differences are alike everywhere, as smoothing needs. With
    /// eightfold ends they would be 200 times as large there.
    pub fn continued(sites: &'a [f64]) -> Self {
        Self { sites, continued: true }
    }

    /// Whether the first and the last interval go on.
    pub fn is_continued(&self) -> bool {
        self.continued
    }

    /// Times of the joints, s.
    pub fn sites(&self) -> &'a [f64] {
        self.sites
    }

    /// Knot j of all n + 15: seven before the sites, the sites, seven after them.
    pub fn at(&self, j: usize) -> f64 {
        let last = self.sites.len().saturating_sub(1);
        let site = |place: usize| self.sites.get(place).copied().unwrap_or(0.0);
        let beyond = |first: usize, second: usize, steps: usize| {
            if self.continued { steps as f64 * (site(second) - site(first)) } else { 0.0 }
        };
        match j.checked_sub(DEGREE) {
            None => site(0) - beyond(0, 1, DEGREE - j),
            Some(place) if place <= last => site(place),
            Some(place) => site(last) + beyond(last.saturating_sub(1), last, place - last),
        }
    }

    /// The knots t_{i−6} to t_{i+7} around the span from site i to site i + 1.
    pub fn around(&self, span: usize) -> [f64; KNOTS] {
        core::array::from_fn(|k| self.at(span + k + 1))
    }
}

/// The functions of the control points i to i + 7 at a time within the span.
#[inline]
pub fn values(knots: &[f64; KNOTS], time: f64) -> [f64; TERMS] {
    // B_{j,0} = 1 in the span;  B_{j,d} = (t − t_j)/(t_{j+d} − t_j) B_{j,d−1} + (t_{j+d+1} − t)/(…) B_{j+1,d−1}
    // (Cox, de Boor). A shared quotient goes up to the one and down to the other.
    let mut basis = [0.0; TERMS];
    if let Some(first) = basis.first_mut() {
        *first = 1.0;
    }
    let at = |k: usize| knots.get(k).copied().unwrap_or(0.0);
    for degree in 1..=DEGREE {
        let mut carried = 0.0;
        for (j, place) in basis.iter_mut().take(degree).enumerate() {
            let (lower, upper) = (at(DEGREE + j - degree), at(DEGREE + j));
            let share = *place / (upper - lower);
            *place = carried + (upper - time) * share;
            carried = (time - lower) * share;
        }
        if let Some(place) = basis.get_mut(degree) {
            *place = carried;
        }
    }
    basis
}
