//! How late a measurement is, where that is not known well enough.

use crate::math::real::Real;
use crate::math::vector::Vector;

/// A constant latency: the measurement belongs to a time that is earlier by it.
///
/// ```
/// use schuler::aiding::states::latency::Latency;
/// use schuler::math::vector::Vector;
///
/// let column = Latency::column(Vector::new(20.0_f64, 0.0, 0.0));
/// assert_eq!(column.x, -20.0);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Latency<R> {
    /// Its standard deviation, s.
    pub sigma_s: R,
}

impl<R: Real> Latency<R> {
    /// Its column in a measured position: −v, in the axes of the measurement, m/s.
    pub fn column(velocity: Vector<R>) -> Vector<R> {
        -velocity
    }
}
