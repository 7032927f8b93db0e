//! A path of which a few pieces are known at a time: compiled as it is flown, in fixed memory.
//!
//! ```
//! use schuler::imu::Quadrature;
//! use schuler::math::compensated::Pair;
//! use schuler::trajectory::piecewise::{Attitude, piece::Piece, stream::Stream};
//!
//! // From the equator to the north in pieces of one second, 1 µrad/s.
//! let pieces = (0..10).map(|n| {
//!     let mut piece = Piece::<8>::new(f64::from(n), f64::from(n + 1));
//!     piece.coefficients[0] = [1.0, 0.0, piece.middle_s * 1e-6, 0.0, 0.0, 0.0, 0.0, 0.0];
//!     piece.coefficients[1][2] = 1e-6;
//!     Ok::<_, core::convert::Infallible>(piece)
//! });
//! let mut path = Stream::<_, 8, 2>::new(pieces, Attitude::Upright);
//! path.advance(2.5, 3.5)?;
//! let sample = Quadrature::of_nodes(2).increment(&path, 2.5, 3.5);
//! assert!((sample.velocity_b.z + 9.78).abs() < 1e-2);
//! # Ok::<(), schuler::trajectory::piecewise::stream::StreamError<core::convert::Infallible>>(())
//! ```

use super::piece::Piece;
use super::{Attitude, Piecewise};
use crate::math::compensated::Pair;
use crate::sample::Rates;
use crate::solution::Solution;
use crate::trajectory::kinematics::Kinematics;
use crate::trajectory::{Bound, Motion, Trajectory};
use heapless::Vec;

/// Why a stream cannot go on.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum StreamError<E> {
    /// The next piece could not be made.
    Piece(E),
    /// The span asked for has more pieces than there is room for.
    TooManyPieces {
        /// The number of pieces that there is room for.
        room: usize,
    },
    /// The span begins before the pieces that are known: a stream goes forward only.
    Past {
        /// When these begin, s.
        start_s: f64,
    },
    /// The path ends before the span does.
    Ended {
        /// When it ends, s.
        end_s: f64,
    },
}

impl<E: core::fmt::Display> core::fmt::Display for StreamError<E> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Piece(error) => error.fmt(f),
            Self::TooManyPieces { room } => write!(f, "more than {room} pieces within one span"),
            Self::Past { start_s } => {
                write!(f, "the path is known from {start_s} s on: it goes forward only")
            }
            Self::Ended { end_s } => write!(f, "the path ends at {end_s} s"),
        }
    }
}

impl<E: core::error::Error> core::error::Error for StreamError<E> {}

/// A path from a source of pieces, with room for `N` of them.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Stream<I, const TERMS: usize, const N: usize> {
    source: I,
    known: Piecewise<Vec<Piece<TERMS>, N>, TERMS>,
}

impl<I, E, const TERMS: usize, const N: usize> Stream<I, TERMS, N>
where
    I: Iterator<Item = Result<Piece<TERMS>, E>>,
{
    /// Before its first piece.
    pub fn new(source: I, attitude: Attitude) -> Self {
        let known = Piecewise { pieces: Vec::new(), attitude, bound: Bound::default() };
        Self { source, known }
    }

    /// Makes a span of time known, s, and forgets what ended before it. The motion may be asked within the
    /// span from then on.
    ///
    /// # Errors
    ///
    /// [`StreamError`] where the source fails or the span cannot be known.
    pub fn advance(&mut self, from_s: f64, to_s: f64) -> Result<(), StreamError<E>> {
        let pieces = &mut self.known.pieces;
        if let Some(first) = pieces.first()
            && from_s < first.start_s
        {
            return Err(StreamError::Past { start_s: first.start_s });
        }
        pieces.retain(|piece| piece.end_s > from_s);
        while pieces.last().is_none_or(|last| last.end_s < to_s) {
            let Some(next) = self.source.next() else {
                let end_s = pieces.last().map_or(from_s, |last| last.end_s);
                return Err(StreamError::Ended { end_s });
            };
            let next = next.map_err(StreamError::Piece)?;
            if next.end_s > from_s {
                pieces.push(next).map_err(|_| StreamError::TooManyPieces { room: N })?;
            }
        }
        Ok(())
    }
}

impl<I, const TERMS: usize, const N: usize> Trajectory<f64> for Stream<I, TERMS, N> {
    fn at_instant(&self, time_s: Pair<f64>) -> Motion<f64> {
        self.known.at_instant(time_s)
    }
    #[inline]
    fn rates_at(&self, time_s: Pair<f64>) -> Rates<f64> {
        self.known.rates_at(time_s)
    }
    fn kinematics_at(&self, time_s: Pair<f64>) -> Kinematics {
        self.known.kinematics_at(time_s)
    }
    fn solution_at(&self, time_s: Pair<f64>) -> Solution<f64> {
        self.known.solution_at(time_s)
    }
    fn initial_at(&self, time_s: Pair<f64>) -> Solution<f64> {
        self.known.initial_at(time_s)
    }
    fn joint_after(&self, time_s: f64) -> Option<f64> {
        self.known.joint_after(time_s)
    }
    fn bound(&self) -> Bound<f64> {
        self.known.bound()
    }
}
