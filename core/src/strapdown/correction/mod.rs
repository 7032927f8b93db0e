//! Corrections of a running state, by a filter, a position fix or an operator.
//!
//! | file | what it has |
//! |---|---|
//! | this file | [`Correction`] and its limits |
//! | `local_level` | the increments of a local-level state, by the series of the step |
//! | `earth_fixed` | the increments of an Earth-fixed state, by two-float geometry |
//! | `turn` | rotations that are stored less one |
//!
//! A correction applies to the state at the end of the last block, which
//! [`output`](crate::strapdown::mechanization::Mechanization::output) shows. It goes through the same compensated
//! sums as a step. Samples that wait for the next block are integrated from the corrected state. Quantities
//! that depend on position and velocity are corrected too: the sine and cosine of the latitude, gravity, and the
//! gravity history, which the next block sets up again as after a start.

mod earth_fixed;
mod local_level;
pub(crate) mod turn;

pub(crate) use earth_fixed::earth_fixed;
pub(crate) use local_level::local_level;

use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::strapdown::limits::Rejected;
use crate::strapdown::plausible::Plausible;

/// The corrected state less the present one, in north, east and down.
///
/// Its three parts are those of [`Drift`](crate::drift::compare::Drift), the difference of two solutions. So
/// `drift(&truth, &computed)` is the correction from the computed solution to the truth, whatever its size.
///
/// ```
/// use schuler::prelude::*;
///
/// # let level = Euler { roll: 0.0, pitch: 0.0, yaw: 0.0 };
/// # let start = Solution::new(Geodetic::default(), Vector::ZERO, level);
/// let navigator = Navigator4::<f64>::from_rate_hz(100.0)?;
/// let mut state = navigator.start(&start)?;
/// // Two metres higher, and a tenth of a metre per second slower to the north.
/// let correction = Correction {
///     position_ned: Vector::new(0.0, 0.0, -2.0),
///     velocity_ned: Vector::new(-0.1, 0.0, 0.0),
///     ..Correction::ZERO
/// };
/// navigator.correct(&mut state, &correction)?;
/// assert_eq!(navigator.readout(&state).altitude_m, 2.0);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Correction<R> {
    /// Position, m: the horizontal components of the straight chord from the present to the corrected
    /// position, along the present north and east, and the height lost. At most [`MOST_POSITION`].
    pub position_ned: Vector<R>,
    /// Velocity, m/s: the corrected less the present one, each in the north, east and down of its own
    /// position. At most [`MOST_VELOCITY`].
    pub velocity_ned: Vector<R>,
    /// Attitude, rad: the rotation vector of C_bⁿ(corrected)·C_bⁿ(present)ᵀ, each against the north, east
    /// and down of its own position. At most π.
    ///
    /// Beyond [`POLAR_SINE`](crate::earth::POLAR_SINE), 84° of latitude, the corrected north of velocity and
    /// attitude is the present one, carried along the shortest way to the corrected position.
    pub attitude_ned: Vector<R>,
}

/// The largest correction of a position, m. A navigator with a larger error must be started again.
pub const MOST_POSITION: f64 = 1e4;
/// The largest correction of a velocity, m/s.
pub const MOST_VELOCITY: f64 = 1e4;

impl<R: Real> Correction<R> {
    /// No correction: it changes no bit of a state.
    pub const ZERO: Self =
        Self { position_ned: Vector::ZERO, velocity_ned: Vector::ZERO, attitude_ned: Vector::ZERO };

    /// Whether it corrects nothing.
    fn is_zero(&self) -> bool {
        !self.moves() && self.attitude_ned.is_within(R::ZERO)
    }

    /// Whether it changes position or velocity, and so the gravity history.
    pub(crate) fn moves(&self) -> bool {
        !self.position_ned.is_within(R::ZERO) || !self.velocity_ned.is_within(R::ZERO)
    }

    /// Whether it is finite and within its limits.
    fn admit(&self) -> Result<(), CorrectionError> {
        let admitted = self.position_ned.norm().is_within(R::of(MOST_POSITION))
            & self.velocity_ned.norm().is_within(R::of(MOST_VELOCITY))
            & self.attitude_ned.norm().is_within(R::of(core::f64::consts::PI));
        if admitted { Ok(()) } else { Err(CorrectionError::Size) }
    }

    /// Corrects the navigation of a state by a function, if the correction and its result are valid. Otherwise,
    /// or with nothing to correct, the state does not change.
    pub(crate) fn apply<F: Copy + Plausible>(
        &self,
        frame: &mut F,
        correct: impl FnOnce(&mut F, &Self) -> Result<(), Rejected>,
    ) -> Result<(), CorrectionError> {
        self.admit()?;
        if self.is_zero() {
            return Ok(());
        }
        let mut corrected = *frame;
        correct(&mut corrected, self)?;
        if !corrected.is_plausible() {
            return Err(CorrectionError::State);
        }
        *frame = corrected;
        Ok(())
    }
}

/// Why a correction was refused. The state has not changed in any bit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum CorrectionError {
    /// It is not finite, or above [`MOST_POSITION`], [`MOST_VELOCITY`] or half a turn.
    Size,
    /// Local-level axes are within 64 times its length of a pole, or would come within 640 m of one.
    Pole,
    /// It leads to a place more than 1000 km from the ellipsoid.
    Place,
    /// The result is not a valid state; most often its speed is too high.
    State,
}

impl core::fmt::Display for CorrectionError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(match self {
            Self::Size => "the correction must be finite, within 10 km, 10 km/s and half a turn",
            Self::Pole => "the correction is too large so near a pole; earth-fixed takes it",
            Self::Place => "the correction leads over 1000 km from the ellipsoid",
            Self::State => "the corrected state is none to go on from",
        })
    }
}

impl core::error::Error for CorrectionError {}

impl From<Rejected> for CorrectionError {
    /// The reason why a frame cannot continue from a place.
    fn from(rejected: Rejected) -> Self {
        if rejected == Rejected::Pole { Self::Pole } else { Self::Place }
    }
}
