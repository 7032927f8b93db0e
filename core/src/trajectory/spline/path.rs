//! Splines of the normal, the height and the attitude as the pieces of a path.
//!
//! ```
//! use schuler::trajectory::spline::{BAND, EXTRA, Ends, basis::Knots};
//! use schuler::trajectory::spline::{interpolate::interpolate, path::{Path, Spline}};
//!
//! // Straight up over the north pole: from 0 to 10 m in 4 s, from rest to rest.
//! let sites = [0.0, 4.0];
//! let (mut band, mut control) = ([[0.0; BAND]; 2 + EXTRA], [[0.0; 4]; 2 + EXTRA]);
//! let points = [[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 1.0, 10.0]];
//! interpolate(&sites, points, Ends::AtRest, &mut band, &mut control)?;
//! let spline = Spline { knots: Knots::eightfold(&sites), control: &control };
//! let path = Path::new(spline, spline, None)?;
//! let piece = path.piece(0).unwrap();
//! assert!((piece.channel(3, 2.0) - 5.0).abs() < 1e-14);
//! assert_eq!(path.pieces(), 1);
//! # Ok::<(), schuler::trajectory::spline::SplineError>(())
//! ```

use super::basis::Knots;
use super::local::coefficients;
use super::{EXTRA, SplineError, TERMS, check_sites};
use crate::math::compensated::Pair;
use crate::trajectory::piecewise::piece::Piece;

/// A spline of four channels.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Spline<'a> {
    /// Its knots.
    pub knots: Knots<'a>,
    /// Its control points, [`EXTRA`] more than sites.
    pub control: &'a [[f64; 4]],
}

impl Spline<'_> {
    /// Whether both are the same in memory.
    fn is(&self, other: &Self) -> bool {
        let alike = self.knots.is_continued() == other.knots.is_continued();
        alike && core::ptr::eq(self.control, other.control)
    }
}

/// A path by splines. Each piece is made when asked for, so that a microcontroller needs no room for all of them.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Path<'a> {
    level: Spline<'a>,
    height: Spline<'a>,
    attitude: Option<Spline<'a>>,
}

impl<'a> Path<'a> {
    /// From splines of n̂ and h, of which the one is read for n̂ and the other for h, and one of the attitude's
    /// quaternion (w, x, y, z; body → Earth-fixed axes), if the path has its own. All are over the same sites.
    ///
    /// # Errors
    ///
    /// [`SplineError`] if the sites do not increase, or there are too few control points.
    pub fn new(
        level: Spline<'a>,
        height: Spline<'a>,
        attitude: Option<Spline<'a>>,
    ) -> Result<Self, SplineError> {
        let sites = level.knots.sites();
        check_sites(sites)?;
        let needed = sites.len() + EXTRA;
        for spline in [Some(level), Some(height), attitude].into_iter().flatten() {
            if spline.control.len() < needed {
                return Err(SplineError::NoRoom { needed });
            }
            if spline.knots.sites() != sites {
                return Err(SplineError::Count { needed: sites.len() });
            }
        }
        Ok(Self { level, height, attitude })
    }

    /// Times of the joints, s.
    pub fn sites(&self) -> &'a [f64] {
        self.level.knots.sites()
    }

    /// Number of pieces.
    pub fn pieces(&self) -> usize {
        self.sites().len().saturating_sub(1)
    }

    /// Whether the path has an attitude of its own; else its quaternions are 0.
    pub fn has_attitude(&self) -> bool {
        self.attitude.is_some()
    }

    /// A piece by its index, from 0.
    pub fn piece(&self, index: usize) -> Option<Piece<TERMS>> {
        let sites = self.sites();
        let mut piece = Piece::new(*sites.get(index)?, *sites.get(index + 1)?);
        let of =
            |spline: Spline<'_>| coefficients(spline.knots, index, piece.middle_s, spline.control);
        let mut position = of(self.level)?;
        if !self.height.is(&self.level) {
            let height = of(self.height)?;
            for ([.., place], [.., h]) in position.iter_mut().zip(height) {
                *place = h;
            }
        }
        let attitude = match self.attitude {
            Some(spline) => of(spline)?,
            None => [[Pair::default(); 4]; TERMS],
        };
        for ((row, position), attitude) in piece.coefficients.iter_mut().zip(position).zip(attitude)
        {
            let channels = position.into_iter().chain(attitude);
            row.iter_mut().zip(channels).for_each(|(place, c)| *place = c.hi);
        }
        Some(piece)
    }
}
