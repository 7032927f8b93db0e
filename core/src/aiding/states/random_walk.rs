//! A random walk: its variance grows with time.

use crate::aiding::covariance::ud::Ud;
use crate::math::real::Real;

/// A random walk.
///
/// ```
/// use schuler::aiding::covariance::ud::Ud;
/// use schuler::aiding::states::random_walk::RandomWalk;
///
/// let mut ud = Ud::<f64, 1, 1>::exact();
/// RandomWalk { sigma: 0.0, per_root_s: 3.0 }.advance(&mut ud, 0, 4.0);
/// assert_eq!(ud.sigma(0), 6.0);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RandomWalk<R> {
    /// Its standard deviation at the start.
    pub sigma: R,
    /// Its growth, units per √s.
    pub per_root_s: R,
}

impl<R: Real> RandomWalk<R> {
    /// Carries the covariance of one state on; the estimate keeps.
    pub fn advance<const N: usize, const P: usize>(
        &self,
        ud: &mut Ud<R, N, P>,
        state: usize,
        time_s: R,
    ) -> R {
        ud.add_variance(state, self.per_root_s * self.per_root_s * time_s);
        R::ONE
    }
}
