//! A time counted in samples, so that its order is exact in any precision.
//!
//! ```
//! use schuler::aiding::aided::instant::Instant;
//!
//! let fix = Instant::<f32>::from_seconds(3600.004, 100.0).unwrap();
//! assert_eq!(fix.samples, 360_000);
//! assert!((fix.part - 0.4).abs() < 1e-6);
//! assert!(Instant::of_sample(360_000).is_before(&fix));
//! ```

use crate::math::real::{Real, Scalar};
use crate::record::{Record, record};

/// The latest time that is told, samples.
const LAST: f64 = 9e15;
/// The largest shift, samples.
const FARTHEST: u32 = 4096;

/// A time since the start of navigation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Instant<R> {
    /// Whole samples.
    pub samples: u64,
    /// The part of a sample after them, at least 0 and below 1.
    pub part: R,
}

impl<R: Real> Instant<R> {
    /// The end of a sample; 0 is the start.
    pub const fn of_sample(samples: u64) -> Self {
        Self { samples, part: R::ZERO }
    }
}

impl<R: Scalar> Instant<R> {
    /// A time in seconds since the start; `None` if it is before that, or not finite.
    pub fn from_seconds(seconds: f64, rate_hz: f64) -> Option<Self> {
        let samples = seconds * rate_hz;
        if !(0.0..LAST).contains(&samples) {
            return None;
        }
        // A time that is a sample's end but for its own rounding is that end.
        let nearest = samples.round();
        if (samples - nearest).abs() <= 4.0 * f64::EPSILON * samples {
            return Some(Self::of_sample(nearest as u64));
        }
        let whole = samples as u64;
        let part = R::narrow(samples - whole as f64);
        Some(if part < R::ONE { Self { samples: whole, part } } else { Self::of_sample(whole + 1) })
    }

    /// Whether it is a time at all.
    pub(super) fn is_valid(&self) -> bool {
        self.part >= R::ZERO && self.part < R::ONE
    }

    /// Whether it comes before another one.
    pub fn is_before(&self, other: &Self) -> bool {
        (self.samples, self.part) < (other.samples, other.part)
    }

    /// Samples from another time to this one, which must be near it.
    pub fn since(&self, other: &Self) -> R {
        let ahead = self.samples.saturating_sub(other.samples) as u32;
        let behind = other.samples.saturating_sub(self.samples) as u32;
        R::count(ahead) - R::count(behind) + (self.part - other.part)
    }

    /// Later by some samples, or earlier.
    pub(super) fn shifted(&self, samples: R) -> Self {
        let mut shifted = Self { part: self.part + samples, ..*self };
        for _ in 0..FARTHEST {
            if shifted.part < R::ZERO && shifted.samples > 0 {
                (shifted.samples, shifted.part) = (shifted.samples - 1, shifted.part + R::ONE);
            } else if shifted.part >= R::ONE {
                (shifted.samples, shifted.part) = (shifted.samples + 1, shifted.part - R::ONE);
            } else {
                break;
            }
        }
        shifted
    }
}

impl<R: Record> Record for Instant<R> {
    record!(samples, part);
}
