//! A term of rank one added: P ← P + q·a·aᵀ (Agee and Turner, 1972).
//!
//! ```
//! use schuler::aiding::covariance::ud::Ud;
//!
//! let mut ud = Ud::<f64, 3, 6>::diagonal([1.0, 0.0, 1.0]);
//! ud.add_rank_one(4.0, [1.0, 0.5, 0.0]);
//! assert_eq!((ud.variance(0), ud.variance(1), ud.covariance(0, 1)), (5.0, 1.0, 2.0));
//! ```

use super::ud::Ud;
use super::unrolled;
use crate::math::real::Real;

impl<R: Real, const N: usize, const P: usize> Ud<R, N, P> {
    /// Adds q·a·aᵀ, q ≥ 0.
    pub fn add_rank_one(&mut self, weight: R, along: [R; N]) {
        self.add_rank_one_to(N, weight, along);
    }

    /// The same, where only the first `states` components of a may differ from 0.
    pub fn add_rank_one_to(&mut self, states: usize, weight: R, mut along: [R; N]) {
        let mut q = weight;
        for j in (0..states.min(N)).rev() {
            let a = along.get(j).copied().unwrap_or(R::ZERO);
            let Some((above, d)) = self.column_mut(j) else { return };
            // D_j' = D_j + q a_j²,  a_i ← a_i − a_j U_ij,  U_ij ← U_ij + (q a_j/D_j') a_i,  q ← q D_j/D_j'
            let grown = *d + q * a * a;
            let some = R::ZERO.less(grown);
            let inverse = R::select(some, R::ONE / grown, R::ZERO);
            let gain = q * a * inverse;
            // With D_j' = 0 there is nothing along a_j, and the rest of the term stays whole.
            q = R::select(some, q * *d * inverse, q);
            *d = grown;
            unrolled::pairs(above, &mut along, |u, rest| {
                *rest = *rest - a * *u;
                *u = *u + gain * *rest;
            });
        }
    }

    /// Adds an independent variance to one state.
    pub fn add_variance(&mut self, state: usize, variance: R) {
        let mut along = [R::ZERO; N];
        if let Some(one) = along.get_mut(state) {
            *one = R::ONE;
        }
        self.add_rank_one_to(state + 1, variance, along);
    }
}
