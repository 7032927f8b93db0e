//! What becomes of measurements, and what a smoother needs of a filter's steps.
//!
//! ```
//! use schuler::aiding::aided::verdict::{Verdict, Witness};
//!
//! /// Counts what was refused.
//! struct Refused(u32);
//!
//! impl Witness<f64, 15, 120, 0> for Refused {
//!     fn judged(&mut self, verdict: &Verdict<f64>) {
//!         self.0 += u32::from(!verdict.accepted);
//!     }
//! }
//! # let _ = Refused(0);
//! ```

use super::instant::Instant;
use super::measured::Kind;
use crate::aiding::covariance::ud::Ud;
use crate::aiding::filter::Fading;
use crate::aiding::transition::{BIASES, NAVIGATION, Transition};
use crate::math::real::Real;

/// What became of a measurement.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Verdict<R> {
    /// Its time.
    pub at: Instant<R>,
    /// What was measured.
    pub kind: Kind,
    /// How old it was, s.
    pub age_s: R,
    /// Σ y²/α over the vector; its expected value is the number of its components.
    pub nis: R,
    /// The largest NIS that is accepted.
    pub limit: R,
    /// Whether it was accepted. One within the limit is refused if its correction is too large to be made.
    pub accepted: bool,
    /// Whether it completed a lockout: so many refusals in a row that the filter, not the sensor, may be wrong.
    pub locked_out: bool,
}

/// A step of the filter, as a smoother needs it.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Step<'a, R, const N: usize, const P: usize, const E: usize> {
    /// Samples at its end.
    pub samples: u64,
    /// P⁺ at its start.
    pub before: &'a Ud<R, N, P>,
    /// Φ of the navigation errors.
    pub transition: &'a Transition<R>,
    /// What biases and further states fade by at its end.
    pub fading: &'a Fading<R, E>,
    /// P⁻ at its end.
    pub after: &'a Ud<R, N, P>,
}

impl<R: Real, const N: usize, const P: usize, const E: usize> Step<'_, R, N, P, E> {
    /// Φ of all the states by rows.
    pub fn matrix(&self) -> [[R; N]; N] {
        let mut matrix = [[R::ZERO; N]; N];
        let unit = |at: usize| {
            let (mut x, mut b) = ([R::ZERO; NAVIGATION], [R::ZERO; BIASES]);
            if let Some(one) = x.get_mut(at) {
                *one = R::ONE;
            } else if let Some(one) = b.get_mut(at - NAVIGATION) {
                *one = R::ONE;
            }
            self.transition.of(&x, &b)
        };
        let [gyro, force] = self.fading.biases;
        for column in 0..NAVIGATION + BIASES {
            for (row, x) in matrix.iter_mut().zip(unit(column)) {
                if let Some(cell) = row.get_mut(column) {
                    *cell = x;
                }
            }
        }
        let factors = [gyro, gyro, gyro, force, force, force].into_iter().chain(self.fading.extras);
        for ((n, row), factor) in matrix.iter_mut().enumerate().skip(NAVIGATION).zip(factors) {
            if let Some(cell) = row.get_mut(n) {
                *cell = factor;
            }
        }
        matrix
    }
}

/// Sees what a filter does: for a smoother, for a log. `()` sees nothing.
pub trait Witness<R: Real, const N: usize, const P: usize, const E: usize> {
    /// The filter was carried on over a step. An uncertainty that is added after a lockout is a step of no time.
    fn stepped(&mut self, step: &Step<'_, R, N, P, E>) {
        let _ = step;
    }
    /// Estimated errors were taken off the state at the end of so many samples; P⁺ is what remains.
    fn corrected(&mut self, samples: u64, errors: &[R; N], after: &Ud<R, N, P>) {
        let _ = (samples, errors, after);
    }
    /// A measurement was judged.
    fn judged(&mut self, verdict: &Verdict<R>) {
        let _ = verdict;
    }
    /// The filter started again, because the heading had been too far off for a linear one.
    fn restarted(&mut self, samples: u64) {
        let _ = samples;
    }
}

impl<R: Real, const N: usize, const P: usize, const E: usize> Witness<R, N, P, E> for () {}
