//! The smoothest spline that leaves a given residual.
//!
//! Differentiating twice multiplies noise: positions to 2 cm at 10 Hz, interpolated, are accelerations to 8 m/s².
//! So noisy samples are smoothed: Σ|z − f(t)|² + λ∫|f‴|² is least, with λ from the size σ of the noise. λ = τ⁶/Δt, Δt
//! the mean spacing of the samples: the path follows what is slower than 2πτ, what is faster is taken out. τ is
//! found by bisecting its logarithm, so that the residual is σ√(1 − ½ν/n), where ν is how many of the n values the path
//! can follow. A residual of σ (Morozov's principle) asks for a part of it from the path itself and smooths
//! manoeuvres away: in a flight that is straight most of the time accelerations were wrong by 0.18 m/s² instead of 0.02. With
//! the whole of ν, noise alone would leave as much at any τ, and chance would choose.
//! Source: Reinsch, Smoothing by spline functions, *Numerische Mathematik* 10 (1967) 177–183; Wahba, *Spline Models for
//! Observational Data* (1990), §4.7 (degrees of freedom).
//!
//! ```
//! use schuler::trajectory::spline::smooth::{Fit, Workspace, smooth};
//! use schuler::trajectory::spline::{BAND, EXTRA, basis::Knots, local::coefficients};
//!
//! // t² with errors of 1 cm rms.
//! let times: [f64; 40] = core::array::from_fn(|k| 0.1 * k as f64);
//! let noisy = times.map(|t| [t * t + 0.014 * (370.0 * t * t).sin()]);
//! let mut control = [[0.0]; 40 + EXTRA];
//! let (mut gram, mut factors) = ([[0.0; BAND]; 40 + EXTRA], [[0.0; BAND]; 40 + EXTRA]);
//! let mut right = [[0.0]; 40 + EXTRA];
//! let workspace = Workspace { gram: &mut gram, factors: &mut factors, right: &mut right };
//! let fit = Fit { sites: &times, times_s: &times, values: &noisy, channels: 0..1 };
//! let outcome = smooth(&fit, 0.01, workspace, &mut control)?;
//! assert!((outcome.residual - 0.01).abs() < 1e-3, "{outcome:?}");
//! // Through the samples the acceleration would swing by metres per second squared about 2.
//! let middle = coefficients(Knots::continued(&times), 20, 2.0, &control).unwrap();
//! assert!((2.0 * middle[2][0].hi - 2.0).abs() < 0.1, "{}", middle[2][0].hi);
//! # Ok::<(), schuler::trajectory::spline::SplineError>(())
//! ```

use super::basis::Knots;
use super::normal::{add_sample, factor, for_each_sample, solve, value};
use super::penalty::{add_to, subtract_gradient};
use super::{BAND, EXTRA, SplineError, check_sites};
use crate::math::real::Real;
use core::ops::Range;

/// Bisections of the logarithm of τ, from [`SHORTEST`] to [`LONGEST`].
const BISECTIONS: usize = 30;
/// τ at least, in mean spacings of the sites: noise of the highest frequency passes to 99.9 %.
const SHORTEST: f64 = 0.1;
/// τ at most, in mean spacings of the sites: much beyond it rounding makes the equations indefinite.
const LONGEST: f64 = 50.0;

/// Solutions with the same factors, each for what the ones before left: while searching, and in the end.
const PASSES: [usize; 2] = [2, 3];

/// What is to be smoothed.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Fit<'a, const C: usize> {
    /// Times of the joints, s.
    pub sites: &'a [f64],
    /// Times of the samples, s, within the sites.
    pub times_s: &'a [f64],
    /// The samples.
    pub values: &'a [[f64; C]],
    /// The channels whose residual counts, and that are written.
    pub channels: Range<usize>,
}

/// Room for the equations, each with [`EXTRA`] more entries than there are sites.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Workspace<'a, const C: usize> {
    /// BᵀB.
    pub gram: &'a mut [[f64; BAND]],
    /// Factors.
    pub factors: &'a mut [[f64; BAND]],
    /// Right side, and solution.
    pub right: &'a mut [[f64; C]],
}

impl<const C: usize> Workspace<'_, C> {
    /// The same room for another use.
    pub fn again(&mut self) -> Workspace<'_, C> {
        Workspace { gram: self.gram, factors: self.factors, right: self.right }
    }
}

/// How a path was smoothed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Smoothing {
    /// τ, s.
    pub time_constant_s: f64,
    /// √(Σ|z − f(t)|²/n) over the samples, in the channels' unit.
    pub residual: f64,
    /// The longest τ leaves less than the noise: the samples scatter less than stated, and the path is as smooth
    /// as its sites allow.
    pub at_limit: bool,
}

/// Finds the control points of the smoothest spline whose residual √(Σ|z − f(t)|²/n) is what the `noise` leaves; its knots are
/// [`Knots::continued`].
///
/// # Errors
///
/// [`SplineError`] with the index of a sample; [`SplineError::TooStiff`] if no τ leaves as little as the noise.
pub fn smooth<const C: usize>(
    fit: &Fit<'_, C>,
    noise: f64,
    workspace: Workspace<'_, C>,
    control: &mut [[f64; C]],
) -> Result<Smoothing, SplineError> {
    check_sites(fit.sites)?;
    check_sites(fit.times_s)?;
    let count = fit.times_s.len();
    if fit.values.len() != count {
        return Err(SplineError::Count { needed: count });
    }
    let finite = |row: &[f64; C]| row.iter().all(|x| x.is_finite());
    if let Some(index) = fit.values.iter().position(|row| !finite(row)) {
        return Err(SplineError::NotFinite { index });
    }
    if count < 3 {
        return Err(SplineError::Undetermined);
    }
    let needed = fit.sites.len() + EXTRA;
    let no_room = SplineError::NoRoom { needed };
    let mut problem = Problem {
        fit,
        base: fit.values.first().copied().unwrap_or([0.0; C]),
        gram: workspace.gram.get_mut(..needed).ok_or(no_room)?,
        factors: workspace.factors.get_mut(..needed).ok_or(no_room)?,
        right: workspace.right.get_mut(..needed).ok_or(no_room)?,
        control: control.get_mut(..needed).ok_or(no_room)?,
    };
    problem.fill_gram()?;
    problem.search(noise)
}

struct Problem<'a, 'b, const C: usize> {
    fit: &'a Fit<'b, C>,
    /// The first sample: all is solved for the differences from it.
    base: [f64; C],
    gram: &'a mut [[f64; BAND]],
    factors: &'a mut [[f64; BAND]],
    right: &'a mut [[f64; C]],
    control: &'a mut [[f64; C]],
}

impl<const C: usize> Problem<'_, '_, C> {
    fn fill_gram(&mut self) -> Result<(), SplineError> {
        self.gram.fill([0.0; BAND]);
        let Self { fit, gram, .. } = self;
        for_each_sample(Knots::continued(fit.sites), fit.times_s, |_, span, basis| {
            add_sample(gram, span, &basis)
        })
    }

    fn search(&mut self, noise: f64) -> Result<Smoothing, SplineError> {
        let spacing = mean_spacing(self.fit.sites);
        let [rough, fine] = PASSES;
        let (mut low, mut high) = (SHORTEST * spacing, LONGEST * spacing);
        // Where sites lie much closer than in the mean, the limit is lower.
        let mut outcome = self.solve(high, fine);
        while outcome == Err(SplineError::Undetermined) && high > 2.0 * low {
            high *= 0.5;
            outcome = self.solve(high, fine);
        }
        let mut outcome = outcome?;
        outcome.at_limit = true;
        if outcome.residual > self.expected(noise, high) {
            for _ in 0..BISECTIONS {
                let middle = Real::sqrt(low * high);
                let residual = self.solve(middle, rough)?.residual;
                let less = residual < self.expected(noise, middle);
                *if less { &mut low } else { &mut high } = middle;
            }
            outcome = self.solve(low, fine)?;
            // A residual that stays above the noise leaves the lower end where it was.
            if outcome.residual > 1.001 * self.expected(noise, low) {
                return Err(SplineError::TooStiff);
            }
        }
        for row in self.control.iter_mut() {
            let channels = row.iter_mut().zip(self.base).enumerate();
            for (_, (c, base)) in channels.filter(|(k, _)| self.fit.channels.contains(k)) {
                *c += base;
            }
        }
        Ok(outcome)
    }

    /// The residual to reach, σ√(1 − ½ν/n).
    fn expected(&self, noise: f64, time_constant_s: f64) -> f64 {
        // ν = 3 + T/(3τ): the three of a parabola, and the filter's gains 1/(1 + τ⁶ω⁶) over all frequencies
        let count = self.fit.times_s.len() as f64;
        let duration = mean_spacing(self.fit.times_s) * (count - 1.0);
        let share = (3.0 + duration / (3.0 * time_constant_s)) / count;
        noise * Real::sqrt(1.0 - 0.5 * if share < 1.0 { share } else { 1.0 })
    }

    /// Solves for a τ and leaves the differences of the control points in `control`.
    fn solve(&mut self, time_constant_s: f64, passes: usize) -> Result<Smoothing, SplineError> {
        let square = time_constant_s * time_constant_s;
        let lambda = square * square * square / mean_spacing(self.fit.times_s);
        self.factors.copy_from_slice(self.gram);
        add_to(Knots::continued(self.fit.sites), lambda, self.factors);
        factor(self.factors)?;
        self.start();
        // The first pass solves; the others make up for what rounding in the factors lost.
        for _ in 0..passes {
            self.right.fill([0.0; C]);
            self.residual()?;
            let Self { fit, factors, right, control, .. } = self;
            // Unwritten channels have no differences here, and stay as they are.
            subtract_gradient(Knots::continued(fit.sites), lambda, control, right);
            solve(factors, right);
            for (c, correction) in control.iter_mut().zip(right.iter()) {
                let channels = c.iter_mut().zip(correction).enumerate();
                for (_, (c, d)) in channels.filter(|(k, _)| fit.channels.contains(k)) {
                    *c += d;
                }
            }
        }
        let residual = self.residual()?;
        Ok(Smoothing { time_constant_s, residual, at_limit: false })
    }

    /// Sets the written channels to 0.
    fn start(&mut self) {
        for row in self.control.iter_mut() {
            let channels = row.iter_mut().enumerate();
            for (_, c) in channels.filter(|(k, _)| self.fit.channels.contains(k)) {
                *c = 0.0;
            }
        }
    }

    /// Adds Bᵀ(z − Bc) to the right side, and returns the residual.
    fn residual(&mut self) -> Result<f64, SplineError> {
        let Self { fit, base, right, control, .. } = self;
        let mut sum = 0.0;
        for_each_sample(Knots::continued(fit.sites), fit.times_s, |index, span, basis| {
            let fitted = value(control, span, &basis);
            let Some(sample) = fit.values.get(index) else { return };
            let mut rest = [0.0; C];
            let parts = rest.iter_mut().zip(sample).zip(*base).zip(fitted).enumerate();
            for (_, (((rest, z), base), f)) in parts.filter(|(k, _)| fit.channels.contains(k)) {
                *rest = (z - base) - f;
                sum += *rest * *rest;
            }
            for (row, weight) in right.iter_mut().skip(span).zip(basis) {
                row.iter_mut().zip(rest).for_each(|(row, rest)| *row += weight * rest);
            }
        })?;
        Ok(Real::sqrt(sum / fit.times_s.len() as f64))
    }
}

/// The mean distance between neighbours.
fn mean_spacing(times: &[f64]) -> f64 {
    match times {
        [first, .., last] => (last - first) / (times.len() - 1) as f64,
        _ => 0.0,
    }
}
