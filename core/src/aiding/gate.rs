//! A vector of measurements accepted or refused as a whole, and what happens after many refusals.
//!
//! Component by component the innovations become independent, so that NIS = Σ y²/α has a χ² distribution with as
//! many degrees of freedom as the vector has components.
//!
//! ```
//! use schuler::aiding::gate::{Gate, Watch};
//!
//! let gate = Gate { limit: 16.3_f64, patience: 3 };
//! let mut watch = Watch::default();
//! let locked = [true, false, false, false].map(|accepted| watch.note(&gate, accepted, 1.0));
//! assert_eq!(locked, [false, false, false, true]);
//! assert_eq!((watch.refused(), watch.lockouts()), (3, 1));
//! ```

use super::covariance::ud::Ud;
use crate::math::real::Real;
use crate::record::{Record, record};

/// A vector of `M` measurements of `N` states: y = H·x + v.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Rows<R, const N: usize, const M: usize> {
    /// H by rows.
    pub rows: [[R; N]; M],
    /// What the navigator expects less what is measured.
    pub innovation: [R; M],
    /// Variances of the noise, above 0; the components are independent.
    pub variance: [R; M],
}

/// What became of a vector.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Judged<R: Real, const N: usize> {
    /// The estimated errors; 0 if it was refused.
    pub errors: [R; N],
    /// Σ y²/α.
    pub nis: R,
    /// Where it was accepted.
    pub accepted: R::Mask,
}

/// Takes a vector, whether it is to be accepted or not, and judges it.
#[inline(never)]
pub(super) fn judge<R: Real, const N: usize, const P: usize, const M: usize>(
    ud: &mut Ud<R, N, P>,
    vector: &Rows<R, N, M>,
    limit: R,
) -> Judged<R, N> {
    let (mut errors, mut nis) = ([R::ZERO; N], R::ZERO);
    for ((h, y), variance) in vector.rows.iter().zip(vector.innovation).zip(vector.variance) {
        let explained = h.iter().zip(&errors).fold(R::ZERO, |sum, (h, x)| sum + *h * *x);
        let gain = ud.measure(h, variance);
        let rest = y - explained;
        let weight = rest / gain.variance;
        nis = nis + rest * weight;
        for (x, k) in errors.iter_mut().zip(gain.along) {
            *x = *x + k * weight;
        }
    }
    // A NIS that is not a number is not below the limit.
    let accepted = nis.less(limit);
    let errors = errors.map(|x| R::select(accepted, x, R::ZERO));
    Judged { errors, nis, accepted }
}

/// When a vector is refused, and after how many refusals in a row its sensor counts as locked out.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Gate<R> {
    /// The largest NIS. A χ² of three degrees exceeds 16.3 once in a thousand times, 30.7 once in a million.
    pub limit: R,
    /// Refusals in a row that are a lockout.
    pub patience: u32,
}

/// Counts of one sensor's measurements.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Watch<R> {
    accepted: u32,
    refused: u32,
    in_row: u32,
    lockouts: u32,
    /// Σ NIS of those accepted.
    nis: R,
}

impl<R: Real> Watch<R> {
    /// Counts one. The result says whether it completes a lockout: then the filter is too sure of its errors, and
    /// an uncertainty must be [added](super::filter::Filter::add_uncertainty).
    pub fn note(&mut self, gate: &Gate<R>, accepted: bool, nis: R) -> bool {
        if accepted {
            self.accepted = self.accepted.saturating_add(1);
            self.in_row = 0;
            self.nis = self.nis + nis;
            return false;
        }
        self.refused = self.refused.saturating_add(1);
        self.in_row = self.in_row.saturating_add(1);
        let locked = self.in_row >= gate.patience;
        if locked {
            self.in_row = 0;
            self.lockouts = self.lockouts.saturating_add(1);
        }
        locked
    }

    /// Whether one more refusal completes a lockout.
    pub fn is_out_of_patience(&self, gate: &Gate<R>) -> bool {
        self.in_row.saturating_add(1) >= gate.patience
    }

    /// Vectors accepted.
    pub fn accepted(&self) -> u32 {
        self.accepted
    }

    /// Vectors refused.
    pub fn refused(&self) -> u32 {
        self.refused
    }

    /// Lockouts so far.
    pub fn lockouts(&self) -> u32 {
        self.lockouts
    }

    /// Σ NIS of the accepted vectors.
    pub fn nis(&self) -> R {
        self.nis
    }
}

impl<R: Record> Record for Watch<R> {
    record!(accepted, refused, in_row, lockouts, nis);
}
