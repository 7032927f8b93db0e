//! One piece of a path: polynomials of the n-vector, the height and the attitude.
//!
//! ```
//! use schuler::trajectory::piecewise::piece::Piece;
//!
//! // At the north pole, climbing 2 m/s from 100 m, between 10 s and 20 s.
//! let mut piece = Piece::<8>::new(10.0, 20.0);
//! piece.coefficients[0] = [0.0, 0.0, 1.0, 110.0, 1.0, 0.0, 0.0, 0.0];
//! piece.coefficients[1][3] = 2.0;
//! assert_eq!(piece.channel(3, 10.0), 100.0);
//! ```

use crate::math::compensated::Pair;
use crate::trajectory::series::Series;

/// Number of channels: three of the normal, the height, four of the attitude.
pub const CHANNELS: usize = 8;

/// A polynomial of `TERMS` coefficients in each channel, over a span of time.
///
/// Channels are m (3), h, s (4): the outward normal n̂ = m/|m| in Earth-fixed axes, the height above the
/// ellipsoid in m, and the quaternion s = w, x, y, z that turns body axes into Earth-fixed ones, of any
/// length. Coefficient k stands with uᵏ, u = t − middle.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Piece<const TERMS: usize> {
    /// Where it begins, s.
    pub start_s: f64,
    /// Where it ends, s.
    pub end_s: f64,
    /// Where u = 0, s.
    pub middle_s: f64,
    /// By power, then by channel.
    pub coefficients: [[f64; CHANNELS]; TERMS],
}

impl<const TERMS: usize> Piece<TERMS> {
    /// Zero throughout, about the middle of its span.
    pub fn new(start_s: f64, end_s: f64) -> Self {
        let middle_s = start_s + 0.5 * (end_s - start_s);
        Self { start_s, end_s, middle_s, coefficients: [[0.0; CHANNELS]; TERMS] }
    }

    /// The value of a channel at a time, s; 0 for a channel that there is not.
    pub fn channel(&self, channel: usize, time_s: f64) -> f64 {
        let u = time_s - self.middle_s;
        let coefficient = |row: &[f64; CHANNELS]| row.get(channel).copied().unwrap_or(0.0);
        self.coefficients.iter().rev().fold(0.0, |sum, row| sum * u + coefficient(row))
    }

    /// The first `N` Taylor coefficients of four channels from one on, about a time with its remainder, s.
    #[inline(always)]
    pub(crate) fn series<const N: usize>(&self, half: Half, time_s: Pair<f64>) -> [Series<N>; 4] {
        // Horner's rule with its derivatives: p ← p u + c,  p⁽ᵏ⁾/k! ← p⁽ᵏ⁾/k! · u + p⁽ᵏ⁻¹⁾/(k−1)!
        let u = (time_s.hi - self.middle_s) + time_s.lo;
        let mut rows = [[0.0; 4]; N];
        for [a, b, c, d, e, f, g, h] in self.coefficients.iter().rev() {
            let mut below = match half {
                Half::Position => [*a, *b, *c, *d],
                Half::Attitude => [*e, *f, *g, *h],
            };
            for row in &mut rows {
                let before = *row;
                for (value, below) in row.iter_mut().zip(below) {
                    *value = *value * u + below;
                }
                below = before;
            }
        }
        core::array::from_fn(|channel| {
            Series(rows.map(|row| row.get(channel).copied().unwrap_or(0.0)))
        })
    }
}

/// Which four of the channels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Half {
    /// m and h.
    Position,
    /// s.
    Attitude,
}
