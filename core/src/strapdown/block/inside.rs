//! Rows inside a block, by evaluating its series.
//!
//! Even and odd powers are summed separately, so that one evaluation serves σ and −σ.
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::sample::Increment;
//! use schuler::strapdown::block::body::{Sum, integrate};
//! use schuler::strapdown::block::fit::Fit;
//! use schuler::strapdown::block::inside::BlockSeries;
//!
//! // A steady force for one second: after half of it u is half of the whole, s a quarter.
//! let sample = Increment { angle_b: Vector::ZERO, velocity_b: Vector::new(0.25, 0.0, 0.0) };
//! let (fit, _) = Fit::<f64, 4>::from_any(&[sample; 4], 0, 4);
//! let (body, series) = integrate::<f64, 4, 11>(&fit, &Sum::plain(&[sample; 4]), 0.5, 10);
//! let half = series.until(0.0, 0.5);
//! assert!((half.velocity.x - 0.5 * body.velocity.x).abs() < 1e-15);
//! assert!((half.position.x - 0.25 * body.position.x).abs() < 1e-15);
//! ```

use super::body::BodyMotion;
use super::series::{Series, Term};
use crate::math::real::Real;
use crate::math::real::Twin as _;
use crate::math::vector::Vector;

/// Rows of the first half of a block that are kept for the second.
const KEPT: usize = 2;

/// The even and the odd powers at rows of the first half.
#[derive(Clone, Copy)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Mirror<R: Real> {
    halves: [(Term<R>, Term<R>); KEPT],
}

impl<R: Real> Mirror<R> {
    /// Nothing yet.
    #[inline(always)]
    pub fn new() -> Self {
        Self { halves: [(Term::zero(), Term::zero()); KEPT] }
    }
}

impl<R: Real> Default for Mirror<R> {
    fn default() -> Self {
        Self::new()
    }
}

/// A series that can be evaluated inside its block.
pub trait BlockSeries<R: Real> {
    /// The motion from the block's start to σ in (−1, 1).
    fn until(&self, sigma: R, half_time_s: R) -> BodyMotion<R>;
    /// The motion up to a row, by its number and the number of rows in the block, in rising order.
    fn until_row(
        &self,
        row: usize,
        rows: usize,
        half_time_s: R,
        mirror: &mut Mirror<R>,
    ) -> BodyMotion<R>;
}

impl<R: Real, const N: usize> BlockSeries<R> for Series<R, N> {
    #[inline]
    fn until(&self, sigma: R, half_time_s: R) -> BodyMotion<R> {
        let (even, odd) = self.halves(sigma);
        self.motion(&even.zip(odd, |a, b| a + b), sigma, half_time_s)
    }

    #[inline(always)]
    fn until_row(
        &self,
        row: usize,
        rows: usize,
        half_time_s: R,
        mirror: &mut Mirror<R>,
    ) -> BodyMotion<R> {
        let fraction = R::count(row as u32) / R::count(rows as u32);
        let sigma = fraction + fraction - R::ONE;
        if row + row == rows {
            return self.motion(&Term::zero(), sigma, half_time_s);
        }
        let (even, odd) = match mirror.halves.get((rows - row).wrapping_sub(1)) {
            Some((even, odd)) if row + row > rows => (*even, odd.zip(*odd, |x, _| -x)),
            _ => self.halves(sigma),
        };
        if let Some(kept) = mirror.halves.get_mut(row - 1) {
            *kept = (even, odd);
        }
        self.motion(&even.zip(odd, |a, b| a + b), sigma, half_time_s)
    }
}

impl<R: Real, const N: usize> Series<R, N> {
    /// The even powers at σ, and the odd ones.
    #[inline(always)]
    fn halves(&self, sigma: R) -> (Term<R>, Term<R>) {
        let square = R::Twin::both(sigma * sigma);
        let (mut even, mut odd) = (Term::zero(), Term::zero());
        for n in (0..self.last.div_ceil(2)).rev() {
            if let Some([next_odd, next_even]) = self.terms.get(2 * n + 1..2 * n + 3) {
                odd = odd.zip(*next_odd, |sum, x| sum * square + x);
                even = even.zip(*next_even, |sum, x| (sum + x) * square);
            }
        }
        let sigma = R::Twin::both(sigma);
        (even, odd.scaled(sigma, sigma))
    }

    /// The motion from the block's start to where the series, without its constant, is `at`.
    #[inline(always)]
    fn motion(&self, at: &Term<R>, sigma: R, half_time_s: R) -> BodyMotion<R> {
        let start = self.even.zip(self.odd, |a, b| a - b);
        // q_rel = q(−1)* q(σ),  u = R_rel U(σ) − U₋,  s = (T/2)(R_rel D(σ) − D₋ − (1 + σ)U₋)
        let back = start.rotation().conjugate();
        let e = (back + at.rotation() + back * at.rotation()).normalised_less_one();
        let turned = e.map(R::Twin::both).turn_less_one(at.motion);
        let moved = at.motion - start.motion + turned;
        let velocity = moved.map(|c| c.parts().0);
        let position = moved.map(|c| c.parts().1) - start.velocity() * (R::ONE + sigma);
        BodyMotion {
            rotation: e,
            rotation_low: Vector::ZERO,
            velocity_low: Vector::ZERO,
            velocity,
            position: position * half_time_s,
            position_integral: Vector::ZERO,
        }
    }
}
