//! The navigation errors and the biases over a step (Thornton): P ← Φ·P·Φᵀ + G·Q·Gᵀ.
//!
//! Φ changes only the nine navigation rows: x ← A·x + B·b. With U = [U₁₁ U₁₂; 0 U₂₂] the factors of the other states
//! stay, bit for bit: U₁₂ ← A·U₁₂ + B·U₂₂, and U₁₁, D₁ are the factors of A·U₁₁·D₁·U₁₁ᵀ·Aᵀ + G·Q·Gᵀ.
//!
//! ```
//! use schuler::aiding::covariance::ud::Ud;
//! use schuler::aiding::transition::{StepNoise, Transition};
//! use schuler::math::quaternion::Quaternion;
//! use schuler::math::vector::Vector;
//! use schuler::aiding::transition::Stretch;
//!
//! let mut ud = Ud::<f64, 15, 120>::exact();
//! let stretch = Stretch { time_s: 0.1, ..Stretch::default() };
//! let noise = StepNoise { gyro: 1e-6, accelerometer: 1e-4 };
//! ud.propagate(&Transition::new(&stretch), &noise);
//! assert!((ud.variance(3) - 1e-8 * 0.1).abs() < 1e-18);
//! ```

use super::gram_schmidt::orthogonalise;
use super::ud::Ud;
use crate::aiding::transition::{BIASES, NAVIGATION, StepNoise, Transition};
use crate::math::real::Real;

/// White noises of a step: three gyros, three accelerometers.
const NOISES: usize = 6;
/// Columns of W: those of U₁₁, then the noises.
const SOURCES: usize = NAVIGATION + NOISES;

impl<R: Real, const N: usize, const P: usize> Ud<R, N, P> {
    /// Over a step, with its noise.
    #[inline]
    pub fn propagate(&mut self, transition: &Transition<R>, noise: &StepNoise<R>) {
        let (mut rows, mut weights) = ([[R::ZERO; SOURCES]; NAVIGATION], [R::ZERO; SOURCES]);
        let mut put = |c: usize, weight: R, column: &[R; NAVIGATION]| {
            for (row, x) in rows.iter_mut().zip(column) {
                if let Some(cell) = row.get_mut(c) {
                    *cell = *x;
                }
            }
            if let Some(cell) = weights.get_mut(c) {
                *cell = weight;
            }
        };
        for (j, (above, d)) in self.columns_mut().enumerate() {
            let (mut x, mut b) = ([R::ZERO; NAVIGATION], [R::ZERO; BIASES]);
            let (lower, upper) = above.split_at_mut_checked(NAVIGATION).unwrap_or_default();
            if j < NAVIGATION {
                for (x, u) in x.iter_mut().zip(above.iter()) {
                    *x = *u;
                }
                if let Some(own) = x.get_mut(j) {
                    *own = R::ONE;
                }
                put(j, *d, &transition.of_errors(&x));
            } else {
                for (x, u) in x.iter_mut().zip(lower.iter()) {
                    *x = *u;
                }
                for (b, u) in b.iter_mut().zip(upper.iter()) {
                    *b = *u;
                }
                if let Some(own) = b.get_mut(j - NAVIGATION) {
                    *own = R::ONE;
                }
                for (u, x) in lower.iter_mut().zip(transition.of(&x, &b)) {
                    *u = x;
                }
            }
        }
        for (c, column) in transition.noise_columns().iter().enumerate() {
            let density = if c < NOISES / 2 { noise.gyro } else { noise.accelerometer };
            put(NAVIGATION + c, density * density * transition.time_s(), column);
        }
        let (u, d) = orthogonalise(&mut rows, &weights);
        for ((j, (above, slot)), d) in self.columns_mut().enumerate().zip(d) {
            *slot = d;
            for (cell, row) in above.iter_mut().zip(&u) {
                *cell = row.get(j).copied().unwrap_or(R::ZERO);
            }
        }
    }
}
