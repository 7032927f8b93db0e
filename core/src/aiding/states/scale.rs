//! The scale factor of a speed that is measured along the body, as an odometer's.

use super::Process;
use crate::math::real::Real;

/// A scale factor; 1e-3 reads 0.1 % too much. It walks, with tyre pressure and temperature.
///
/// ```
/// use schuler::aiding::states::scale::Scale;
///
/// // The error of the speed that the navigator expects to be read, per unit of scale factor.
/// assert_eq!(Scale::<f64>::column(20.0), 20.0);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Scale<R> {
    /// Its standard deviation at the start.
    pub sigma: R,
    /// Its growth, 1/√s; 0 if it is constant.
    pub per_root_s: R,
}

impl<R: Real> Scale<R> {
    /// What it does over time.
    pub fn process(&self) -> Process<R> {
        Process::random_walk(self.sigma, self.per_root_s)
    }

    /// Its column in a measured speed, m/s.
    pub fn column(speed: R) -> R {
        speed
    }
}
