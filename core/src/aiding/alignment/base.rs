//! What is known of the vehicle's motion while it is aligned.
//!
//! ```
//! use schuler::aiding::alignment::base::Base;
//!
//! assert_eq!(Base::<f64>::still().displacement_m(), Some(3e-4));
//! assert_eq!(Base::<f64>::Moving.displacement_m(), None);
//! ```

use crate::aiding::states::resonator::Resonator;
use crate::math::real::Real;

/// The displacement of a vehicle that stands still, m.
pub const STILL_M: f64 = 3e-4;

/// How the vehicle moves.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Base<R> {
    /// It stands still or turns about itself, to within a displacement (m, of a tenth of a second, per axis).
    Still {
        /// The standard deviation of its displacement, m.
        displacement_m: R,
    },
    /// It sways about a place, as at a mooring.
    Swaying {
        /// How it sways.
        sway: Resonator<R>,
        /// What the resonator does not explain of its displacement, m.
        displacement_m: R,
    },
    /// It moves, and its velocity is measured.
    Moving,
}

impl<R: Real> Base<R> {
    /// A vehicle that stands still to within [`STILL_M`].
    pub fn still() -> Self {
        Self::Still { displacement_m: R::of(STILL_M) }
    }

    /// A vehicle in a swell of some seven seconds, whose amplitude is about 0.3 m.
    pub fn swaying() -> Self {
        let rate = R::of(core::f64::consts::TAU / 7.0);
        let sway = Resonator { rms_m: R::of(0.2), rate, damping: R::of(0.03) };
        Self::Swaying { sway, displacement_m: R::of(1e-2) }
    }

    /// The white part of its displacement, m; none where it moves.
    pub fn displacement_m(&self) -> Option<R> {
        match *self {
            Self::Still { displacement_m } | Self::Swaying { displacement_m, .. } => {
                Some(displacement_m)
            }
            Self::Moving => None,
        }
    }
}
