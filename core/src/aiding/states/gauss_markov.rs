//! A Gauss-Markov process of first order: it decays, and noise keeps its variance.

use crate::aiding::covariance::ud::Ud;
use crate::math::real::Real;

/// A stationary Gauss-Markov process.
///
/// ```
/// use schuler::aiding::covariance::ud::Ud;
/// use schuler::aiding::states::gauss_markov::GaussMarkov;
///
/// let mut ud = Ud::<f64, 1, 1>::diagonal([5.0]);
/// let process = GaussMarkov { rms: 5.0, correlation_s: 10.0 };
/// let factor = process.advance(&mut ud, 0, 2.0);
/// assert!((factor - (-0.2_f64).exp()).abs() < 1e-15);
/// assert!((ud.sigma(0) - 5.0).abs() < 1e-14);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GaussMarkov<R> {
    /// Its rms.
    pub rms: R,
    /// Its correlation time, s.
    pub correlation_s: R,
}

impl<R: Real> GaussMarkov<R> {
    /// Carries the covariance of one state on; the result is the factor for the estimate.
    pub fn advance<const N: usize, const P: usize>(
        &self,
        ud: &mut Ud<R, N, P>,
        state: usize,
        time_s: R,
    ) -> R {
        // φ = e^(−T/τ),  q = σ²(1 − φ²) = −σ²(φ − 1)(φ + 1)
        let less_one = (-(time_s / self.correlation_s)).exp_m1();
        let factor = R::ONE + less_one;
        ud.map_states(state, &[[factor]]);
        ud.add_variance(state, -(self.rms * self.rms * less_one * (R::ONE + factor)));
        factor
    }
}
