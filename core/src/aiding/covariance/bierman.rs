//! A scalar measurement: P ← P − P·h·hᵀ·P/α without a difference (Bierman, 1977, ch. V).
//!
//! ```
//! use schuler::aiding::covariance::ud::Ud;
//!
//! let mut ud = Ud::<f64, 1, 1>::diagonal([1.0]);
//! let gain = ud.measure(&[1.0], 1.0);
//! assert_eq!((ud.variance(0), gain.along[0] / gain.variance), (0.5, 0.5));
//! ```

use super::ud::Ud;
use super::unrolled;
use crate::math::real::Real;

/// What a scalar measurement says about the states.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Gain<R, const N: usize> {
    /// α = hᵀPh + r: the variance of the innovation.
    pub variance: R,
    /// P·h: the gain is this by α.
    pub along: [R; N],
}

impl<R: Real, const N: usize, const P: usize> Ud<R, N, P> {
    /// Takes y = h·x + v, v of a variance above 0.
    #[inline]
    pub fn measure(&mut self, h: &[R; N], variance: R) -> Gain<R, N> {
        // f = Uᵀh,  g = D f,  α_j = α_{j−1} + f_j g_j,  D_j ← D_j α_{j−1}/α_j,
        // U_ij ← U_ij − (f_j/α_{j−1}) k_i,  k_i ← k_i + g_j U_ij
        let mut along = [R::ZERO; N];
        let mut alpha = variance;
        let mut inverse = R::ONE / variance;
        for ((j, (above, d)), own) in self.columns_mut().enumerate().zip(h) {
            let f = unrolled::sum(*own, above, h, |f, u, h| f + *u * *h);
            let g = *d * f;
            let back = -(f * inverse);
            let before = alpha;
            alpha = alpha + f * g;
            inverse = R::ONE / alpha;
            *d = *d * (before * inverse);
            unrolled::pairs(above, &mut along, |u, k| {
                let old = *u;
                *u = old + back * *k;
                *k = *k + g * old;
            });
            if let Some(k) = along.get_mut(j) {
                *k = g;
            }
        }
        Gain { variance: alpha, along }
    }
}
