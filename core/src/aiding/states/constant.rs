//! A number that does not change.

/// A constant.
///
/// ```
/// use schuler::aiding::covariance::ud::Ud;
/// use schuler::aiding::states::Process;
///
/// let mut ud = Ud::<f64, 1, 1>::diagonal([2.0]);
/// let before = ud;
/// assert_eq!(Process::constant(2.0).advance(&mut ud, 0, 100.0), 1.0);
/// assert_eq!(ud, before);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Constant<R> {
    /// Its standard deviation at the start; 0 if it is known.
    pub sigma: R,
}
