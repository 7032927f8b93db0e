//! A heading that is not known at the start: when the errors were too large for a linear filter, it starts again.
//!
//! A filter is linear about its attitude. If the heading turned out to be wrong by an angle θ, terms of the order of θ² were
//! left out on the way, and what the filter then claims to know is worth no more. So whenever its heading has become
//! five times surer, this is compared with what it claims, and if it is more, the filter starts again from the attitude
//! that it has found.
//!
//! ```
//! use schuler::aiding::alignment::search::{Found, Search};
//!
//! let mut search = Search::new(1.8_f64);
//! // It turned by two radians, and claims to know the heading to 0.3.
//! search.turned(2.0);
//! assert_eq!(search.judge(0.3), Found::Again(1.0));
//! // The second time it turned by 0.1 rad.
//! let mut search = Search::new(1.0);
//! search.turned(0.1);
//! assert_eq!(search.judge(0.15), Found::Going);
//! ```

use crate::math::real::Scalar;
use crate::record::{Record, record};

/// How much surer a heading must have become before it is judged.
const SURER: f64 = 0.2;
/// A first heading of a standard deviation below this is known, rad.
const KNOWN: f64 = 0.1;
/// A heading that was looked for is found at this standard deviation, rad.
const FOUND: f64 = 0.03;

/// How far the heading has turned since the start, and when it is judged next.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Search<R> {
    turned: R,
    /// At this standard deviation, rad; 0 if the heading is known.
    at: R,
}

/// What becomes of an alignment.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Found<R> {
    /// It goes on.
    Going,
    /// It starts again from its attitude, with a heading of this standard deviation, rad.
    Again(R),
}

impl<R: Scalar> Search<R> {
    /// From a first heading of a standard deviation, rad.
    pub fn new(sigma: R) -> Self {
        let at = if sigma > R::of(KNOWN) { sigma * R::of(SURER) } else { R::ZERO };
        Self { turned: R::ZERO, at }
    }

    /// Whether the heading is still looked for. Meanwhile nothing is refused: the filter may be wrong, not the
    /// measurement.
    pub fn goes_on(&self) -> bool {
        self.at > R::ZERO
    }

    /// The heading was corrected by an angle, rad.
    pub fn turned(&mut self, angle: R) {
        self.turned = self.turned + angle;
    }

    /// Ends the search if the heading is claimed to be known to a standard deviation, rad, that is small enough.
    pub fn settle(&mut self, sigma: R) {
        if sigma <= R::of(FOUND) && self.turned * self.turned <= sigma {
            self.at = R::ZERO;
        }
    }

    /// Judges a heading that is claimed to be known to a standard deviation, rad.
    pub fn judge(&mut self, sigma: R) -> Found<R> {
        if !self.goes_on() || sigma > self.at {
            return Found::Going;
        }
        if self.turned * self.turned > sigma {
            let half = self.turned.abs() * R::HALF;
            let twice = sigma + sigma;
            return Found::Again(if half > twice { half } else { twice });
        }
        self.at = if sigma > R::of(FOUND) { sigma * R::of(SURER) } else { R::ZERO };
        Found::Going
    }
}

impl<R: Record> Record for Search<R> {
    record!(turned, at);
}
