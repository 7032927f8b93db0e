//! A stretch of a path, flown while its pieces are made: in the fixed memory of a target, and by its twin on the
//! host.

use core::cell::Cell;
use schuler::digest::Digest;
use schuler::drift::compare::drift;
use schuler::flight::catalogue::Entry;
use schuler::flight::from_double::FromDouble;
use schuler::flight::plan::HIGHEST_ORDER;
use schuler::imu::{Quadrature, instant};
use schuler::math::compensated::Pair;
use schuler::strapdown::limits::{Rejected, StartError};
use schuler::trajectory::Trajectory as _;
use schuler::trajectory::piecewise::Attitude;
use schuler::trajectory::piecewise::piece::Piece;
use schuler::trajectory::piecewise::stream::{Stream, StreamError};

/// Pieces that are known at a time.
pub const ROOM: usize = 4;

/// What is flown of a path.
#[derive(Clone, Copy, Debug)]
pub struct Stretch {
    /// Where it begins, s.
    pub from_s: u32,
    /// Where it ends, s.
    pub to_s: u32,
    /// Samples per second.
    pub rate_hz: u32,
    /// Evaluations in each part of a sample.
    pub nodes: usize,
}

/// What it came to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Flown {
    /// How many pieces were made, those before the stretch among them.
    pub pieces: u32,
    /// The digest of their coefficients.
    pub path: u64,
    /// The digest of the increments.
    pub increments: u64,
    /// The digest of the navigator's states.
    pub states: u64,
    /// How far from the truth it ends, m.
    pub final_m: f64,
}

/// Why it was not flown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Refused<E> {
    /// The path cannot begin.
    Source(E),
    /// It cannot go on.
    Path(StreamError<E>),
    /// The navigator does not start.
    Start(StartError),
    /// It refuses a sample.
    Sample(Rejected),
}

/// Flies a stretch of a path by perfect samples.
///
/// # Errors
///
/// [`Refused`] where the path, the navigator or a sample is at fault.
pub fn fly<M: Entry, E, const TERMS: usize>(
    pieces: impl Iterator<Item = Result<Piece<TERMS>, E>>,
    attitude: Attitude,
    stretch: Stretch,
) -> Result<Flown, Refused<E>> {
    let Stretch { from_s, to_s, rate_hz, nodes } = stretch;
    let (made, path) = (Cell::new(0), Cell::new(Digest::default()));
    let pieces = pieces.inspect(|piece| {
        if let Ok(piece) = piece {
            made.set(made.get() + 1);
            path.set(with_piece(path.get(), piece));
        }
    });
    let mut course = Stream::<_, TERMS, ROOM>::new(pieces, attitude);
    let (first, last) =
        (u64::from(from_s) * u64::from(rate_hz), u64::from(to_s) * u64::from(rate_hz));
    let rate_hz = f64::from(rate_hz);
    let at = |sample: u64| instant(sample as f64, rate_hz);
    course.advance(at(first).hi, at(first + 1).hi).map_err(Refused::Path)?;
    let initial = course.initial_at(at(first));
    let interval_s = Pair::new(rate_hz).reciprocal();
    let started = FromDouble::<M>::start(interval_s, HIGHEST_ORDER, &initial);
    let mut flying = started.map_err(Refused::Start)?;

    let quadrature = Quadrature::of_nodes(nodes);
    let mut increments = Digest::default();
    for sample in first + 1..=last {
        course.advance(at(sample - 1).hi, at(sample).hi).map_err(Refused::Path)?;
        let increment = quadrature.sample(&course, sample, rate_hz);
        increments.add(&increment);
        flying.push_by(&increment, &mut M::push).map_err(Refused::Sample)?;
    }
    flying.flight.finish_by(|m, state| m.finish_rows(state, |_, _| ()));
    let truth = course.solution_at(at(last));
    Ok(Flown {
        pieces: made.get(),
        path: path.get().value(),
        increments: increments.value(),
        states: flying.flight.digest(),
        final_m: drift(&flying.solution(), &truth).position_ned.norm(),
    })
}

/// A digest with every number of a piece.
fn with_piece<const TERMS: usize>(mut digest: Digest, piece: &Piece<TERMS>) -> Digest {
    let times = [piece.start_s, piece.end_s, piece.middle_s];
    let numbers = times.iter().chain(piece.coefficients.as_flattened());
    digest.add_words(numbers.map(|x| x.to_bits()));
    digest
}
