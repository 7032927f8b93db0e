//! Counts: of each sensor's measurements, and of what transport did to them.
//!
//! ```
//! use schuler::aiding::aided::tally::Tally;
//!
//! let tally = Tally::<f64>::default();
//! assert_eq!((tally.accepted(), tally.consistency()), (0, 0.0));
//! ```

use crate::aiding::gate::{Gate, Watch};
use crate::math::real::{Real, Scalar};
use crate::record::{Record, record};

/// Counts of one sensor.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Tally<R> {
    watch: Watch<R>,
    /// Components of the accepted vectors.
    degrees: u32,
    /// Vectors set aside while the heading was looked for.
    aside: u32,
}

impl<R: Real> Tally<R> {
    /// Vectors accepted.
    pub fn accepted(&self) -> u32 {
        self.watch.accepted()
    }

    /// Vectors refused.
    pub fn refused(&self) -> u32 {
        self.watch.refused()
    }

    /// Lockouts.
    pub fn lockouts(&self) -> u32 {
        self.watch.lockouts()
    }

    /// Σ NIS of the accepted vectors.
    pub fn nis(&self) -> R {
        self.watch.nis()
    }

    /// Components of the accepted vectors: what Σ NIS should be, about.
    pub fn degrees(&self) -> u32 {
        self.degrees
    }

    /// Vectors set aside while the heading was looked for: those that did not fit, so that the filter started again,
    /// and those of wheels, which cannot tell a heading from its opposite. They are neither accepted nor refused.
    pub fn set_aside(&self) -> u32 {
        self.aside
    }

    /// Counts one of these.
    pub(super) fn note_aside(&mut self) {
        self.aside = self.aside.saturating_add(1);
    }

    /// Whether one more refusal completes a lockout.
    pub(super) fn is_out_of_patience(&self, gate: &Gate<R>) -> bool {
        self.watch.is_out_of_patience(gate)
    }

    /// Counts one; the result says whether it completes a lockout.
    pub(super) fn note(&mut self, gate: &Gate<R>, accepted: bool, nis: R, degrees: u32) -> bool {
        if accepted {
            self.degrees = self.degrees.saturating_add(degrees);
        }
        self.watch.note(gate, accepted, nis)
    }
}

impl<R: Scalar> Tally<R> {
    /// Σ NIS by what it should be: near 1 if the claimed standard deviations are right; 0 without measurements.
    pub fn consistency(&self) -> R {
        self.nis() / R::count(self.degrees.max(1))
    }
}

/// What came too late, again, or in too large a number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Transport {
    /// Measurements that came again.
    pub again: u32,
    /// Measurements older than the horizon, or than what is remembered.
    pub late: u32,
    /// Measurements for which there was no room.
    pub dropped: u32,
}

impl<R: Record> Record for Tally<R> {
    record!(watch, degrees, aside);
}

impl Record for Transport {
    record!(again, late, dropped);
}
