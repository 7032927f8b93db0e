//! What a navigator puts out, in whatever axes it computes.

use crate::math::real::{Real, Scalar};
use crate::readout::Readout;
use crate::solution::{EarthFixedSolution, Solution};

/// What a navigator puts out, in whatever axes: its conversions to local ones.
///
/// ```
/// use schuler::prelude::*;
///
/// let level = Euler { roll: 0.0, pitch: 0.0, yaw: 0.0 };
/// let start = Solution::new(Geodetic::default(), Vector::ZERO, level);
/// let navigator = EarthFixedNavigator4::<f64>::from_rate_hz(100.0)?;
/// let state = navigator.start(&start)?;
/// let shown = state.output().readout();
/// assert_eq!(shown.altitude_m, 0.0);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
pub trait Output<R: Real>: Copy {
    /// To the digits of `R`.
    fn solution(&self) -> Solution<R>;
    /// The same, its position to about twice the digits of `R` where less is carried in other axes.
    fn precise(&self) -> Solution<R> {
        self.solution()
    }
    /// In double precision, from all the digits carried.
    fn wide(&self) -> Solution<f64>
    where
        R: Scalar;
    /// As plain numbers in degrees, metres and m/s, to the digits of `R`.
    fn readout(&self) -> Readout<R> {
        Readout::from(&self.solution())
    }
}

impl<R: Real> Output<R> for Solution<R> {
    #[inline(always)]
    fn solution(&self) -> Solution<R> {
        *self
    }
    fn wide(&self) -> Solution<f64>
    where
        R: Scalar,
    {
        self.widen()
    }
}

impl<R: Real> Output<R> for EarthFixedSolution<R> {
    fn solution(&self) -> Solution<R> {
        self.to_local()
    }
    fn precise(&self) -> Solution<R> {
        self.to_local_precisely()
    }
    fn wide(&self) -> Solution<f64>
    where
        R: Scalar,
    {
        self.widen().to_local()
    }
}
