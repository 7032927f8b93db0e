//! The truth: motion as an analytic function of time.
//!
//! ```
//! use schuler::trajectory::{Jet, Motion};
//!
//! // 0.01 rad/s of latitude is about 64 km/s to the north.
//! let motion = Motion {
//!     latitude: Jet { value: 0.0_f64, first: 0.01, second: 0.0 },
//!     ..Motion::default()
//! };
//! assert!((motion.velocity_ned().x - 63354.0).abs() < 1.0);
//! ```
//!
//! | file | what it has |
//! |---|---|
//! | `motion` | attitude and position with their derivatives, and what sensors read there |
//! | [`kinematics`] | the same in Earth-fixed axes |
//! | `geographic` | what a navigator would print of that |
//! | [`harmonic`] | channels of harmonics, as in the paper |
//! | [`series`], `columns` | truncated power series, and the quaternion of axes in them |
//! | [`piecewise`] | any path: polynomials of the normal, the height and the attitude |
//! | [`carried`], `displaced` | a lever arm and vibration on any motion |
//! | [`hermite`] | the polynomial between two ends |
//! | [`segment`] | a path by manoeuvres |
//! | [`log`] | paths by logged positions and attitudes |
//! | [`spline`] | splines through points, or near them |
//! | [`waypoints`] | paths by way-points |

pub mod carried;
mod columns;
mod displaced;
mod geographic;
pub mod harmonic;
pub mod hermite;
pub mod kinematics;
pub mod log;
mod motion;
pub mod piecewise;
pub mod segment;
pub mod series;
pub mod spline;
pub mod waypoints;

pub use motion::{Jet, Motion, wrap};

use crate::math::compensated::Pair;
use crate::math::real::{Real, Scalar};
use crate::sample::Rates;
use crate::solution::Solution;
use kinematics::Kinematics;

/// Bounds of a motion, from which quadrature and windows are planned.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bound<R> {
    /// An angular frequency Λ, rad/s, such that the k-th derivative of every component of ω_ibᵇ and
    /// fᵇ stays within Λᵏ times that component's own range, or its size in a steady climb. 0 where
    /// nothing changes.
    pub bandwidth: R,
    /// |ω_ibᵇ| at most, rad/s.
    pub angular_rate: R,
}

/// A motion that can be evaluated at any time, in seconds with the remainder.
///
/// A kind that knows its [`Motion`] has the rest from that; another says it from what it has.
pub trait Trajectory<R: Real> {
    /// Attitude and position with their derivatives; whole turns may be removed from an angle. Not a number
    /// where an angle is not defined: longitude at a pole, roll and yaw at a pitch of 90°.
    fn at_instant(&self, time_s: Pair<R>) -> Motion<R>;
    /// The motion at a time in seconds.
    fn at(&self, time_s: R) -> Motion<R> {
        self.at_instant(Pair::new(time_s))
    }
    /// What perfect sensors read, everywhere.
    #[inline(always)]
    fn rates_at(&self, time_s: Pair<R>) -> Rates<R> {
        self.at_instant(time_s).rates()
    }
    /// Place and motion in Earth-fixed axes, in double precision.
    fn kinematics_at(&self, time_s: Pair<R>) -> Kinematics
    where
        R: Scalar,
    {
        Kinematics::from(&self.at_instant(time_s).widen())
    }
    /// The state that a perfect navigator would print.
    #[inline]
    fn solution_at(&self, time_s: Pair<R>) -> Solution<R>
    where
        R: Scalar,
    {
        self.at_instant(time_s).solution()
    }
    /// The same as a start, to about twice the digits where they count.
    #[inline]
    fn initial_at(&self, time_s: Pair<R>) -> Solution<R>
    where
        R: Scalar,
    {
        self.at_instant(time_s).initial()
    }
    /// The next time after one, s, at which a higher derivative may jump, so that quadrature ends there.
    #[inline(always)]
    fn joint_after(&self, time_s: R) -> Option<R> {
        let _ = time_s;
        None
    }
    /// Its bounds, over all time.
    fn bound(&self) -> Bound<R>;
}
