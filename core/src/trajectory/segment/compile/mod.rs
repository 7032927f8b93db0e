//! Segments in, pieces out: one by one, in fixed memory.
//!
//! | file | what it has |
//! |---|---|
//! | [`segment`] | what a scene says of one manoeuvre |
//! | [`extent`] | how long, how far, how fast, how tight |
//! | [`check`] | its numbers, checked before anything moves |
//! | `climb`, `turn` | how a climb and a turn are divided |
//!
//! ```
//! use schuler::earth::Geodetic;
//! use schuler::trajectory::segment::attitude::AttitudeRule;
//! use schuler::trajectory::segment::compile::segment::{Amount, Pace, Segment, Tightness};
//! use schuler::trajectory::segment::compile::{Compiler, Start};
//!
//! // Stand, drive off, turn left on a circle of 30 m, stop, stand.
//! let start = Start {
//!     position: Geodetic { latitude: 0.8, longitude: 3.14, altitude: 100.0 },
//!     course: 1.4,
//!     speed: 0.0,
//! };
//! let segments = [
//!     Segment::Hold { duration_s: 10.0 },
//!     Segment::Accelerate { speed: 12.0, pace: Pace::Blend(8.0) },
//!     Segment::Turn {
//!         amount: Amount::By(-1.0),
//!         tightness: Tightness::Radius(30.0),
//!         blend_s: 1.5,
//!     },
//!     Segment::Accelerate { speed: 0.0, pace: Pace::Blend(6.0) },
//!     Segment::Hold { duration_s: 10.0 },
//! ];
//! let compiler = Compiler::new(start, AttitudeRule::Upright, &segments)?;
//! let last = compiler.clone().last().expect("there are pieces")?;
//! assert_eq!(last.end_s, compiler.duration_s()?);
//! assert!((last.end_s - (10.0 + 8.0 + 2.5 + 1.5 + 6.0 + 10.0)).abs() < 1e-12);
//! # Ok::<(), schuler::trajectory::segment::compile::SegmentError>(())
//! ```

pub mod check;
mod climb;
pub mod extent;
pub mod segment;
mod turn;

use super::attitude::AttitudeRule;
use super::fault::Fault;
use super::flow::Track;
use super::flyer::Flyer;
use super::state::State;
use crate::earth::Geodetic;
use crate::trajectory::hermite::TERMS;
use crate::trajectory::piecewise::piece::Piece;
use check::Known;
use core::f64::consts::{FRAC_PI_2, TAU};
use core::fmt::{self, Display, Formatter};
use segment::Segment;

/// Where and how a path begins.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Start {
    /// The place.
    pub position: Geodetic<f64>,
    /// Course, from north to east, rad; the heading of what stands.
    pub course: f64,
    /// Speed along the path, m/s.
    pub speed: f64,
}

/// A segment that cannot be flown.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SegmentError {
    /// Its index, from 0; none if it is the start.
    pub index: Option<usize>,
    /// What is wrong.
    pub fault: Fault,
}

impl Display for SegmentError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self.index {
            Some(index) => write!(f, "segment {index} {}", self.fault),
            None => write!(f, "the start {}", self.fault),
        }
    }
}

impl core::error::Error for SegmentError {}

/// When a segment is flown, and how it ends.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Span {
    /// Its index, from 0.
    pub index: usize,
    /// When it begins, s.
    pub start_s: f64,
    /// When it ends, s.
    pub end_s: f64,
    /// The state in which it ends.
    pub state: State,
}

/// An iterator over the pieces of a path by segments, from t = 0 on.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Compiler<'a> {
    segments: &'a [Segment],
    start: Flyer,
    flyer: Flyer,
    /// Number of segments that have begun.
    begun: usize,
    failed: bool,
}

impl<'a> Compiler<'a> {
    /// From a start, straight and level.
    ///
    /// # Errors
    ///
    /// [`SegmentError`] with the first segment whose numbers are not possible at the speed that it begins
    /// with. What depends on the place is seen when its pieces are made.
    pub fn new(
        start: Start,
        rule: AttitudeRule,
        segments: &'a [Segment],
    ) -> Result<Self, SegmentError> {
        let Start { position, course, speed } = start;
        let mut known = Known { speed, altitude: position.altitude, rule }
            .check()
            .map_err(|fault| SegmentError { index: None, fault })?;
        let angles = position.latitude.abs() <= FRAC_PI_2
            && position.longitude.abs() <= TAU
            && course.abs() <= TAU;
        if !angles {
            return Err(SegmentError { index: None, fault: Fault::Angle });
        }
        for (index, segment) in segments.iter().enumerate() {
            let failed = |fault| SegmentError { index: Some(index), fault };
            known = segment.check(known).map_err(failed)?;
        }
        let start = State { speed, ..State::at_rest(Track::new(position, course)) };
        let flyer = Flyer::new(start, 0.0, rule);
        Ok(Self { segments, start: flyer, flyer, begun: 0, failed: false })
    }

    /// The next piece; none after the last, or after an error.
    pub fn next_piece(&mut self) -> Option<Result<Piece<TERMS>, SegmentError>> {
        while !self.failed {
            let result = match self.flyer.next_piece() {
                Some(result) => result.map(Some),
                None => {
                    let segment = self.segments.get(self.begun)?;
                    self.begun += 1;
                    let controls = segment.controls(self.flyer.state());
                    controls.and_then(|controls| self.flyer.begin(controls)).map(|()| None)
                }
            };
            match result {
                Ok(Some(piece)) => return Some(Ok(piece)),
                Ok(None) => {}
                Err(fault) => {
                    self.failed = true;
                    return Some(Err(SegmentError { index: self.segment(), fault }));
                }
            }
        }
        None
    }

    /// The index of the segment that the last piece is of.
    pub fn segment(&self) -> Option<usize> {
        self.begun.checked_sub(1)
    }

    /// When each segment is flown and how it ends; the path is followed without making pieces.
    pub fn spans(&self) -> Spans<'a> {
        Spans { segments: self.segments, flyer: self.start, index: 0 }
    }

    /// How long the path takes, s: to the end of the last of its [`spans`](Self::spans).
    ///
    /// # Errors
    ///
    /// [`SegmentError`] as of them.
    pub fn duration_s(&self) -> Result<f64, SegmentError> {
        self.spans().try_fold(0.0, |_, span| Ok(span?.end_s))
    }
}

impl Iterator for Compiler<'_> {
    type Item = Result<Piece<TERMS>, SegmentError>;

    fn next(&mut self) -> Option<Self::Item> {
        self.next_piece()
    }
}

/// An iterator over the [`Span`]s of a path.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Spans<'a> {
    segments: &'a [Segment],
    flyer: Flyer,
    index: usize,
}

impl Iterator for Spans<'_> {
    type Item = Result<Span, SegmentError>;

    fn next(&mut self) -> Option<Self::Item> {
        let (index, flyer) = (self.index, &mut self.flyer);
        let segment = self.segments.get(index)?;
        self.index = index + 1;
        let start_s = flyer.time_s();
        let begun = segment.controls(flyer.state()).and_then(|controls| flyer.begin(controls));
        if let Err(fault) = begun {
            self.index = self.segments.len();
            return Some(Err(SegmentError { index: Some(index), fault }));
        }
        flyer.finish();
        Some(Ok(Span { index, start_s, end_s: flyer.time_s(), state: *flyer.state() }))
    }
}
