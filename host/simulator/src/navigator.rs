//! The core's navigators behind one interface: frame, precision, algorithm and window are chosen at run time.
//! Whoever flies one calls a function that is compiled here, once for all.
//!
//! | file | what it has |
//! |---|---|
//! | `available` | which algorithms, precisions, frames and windows go together |
//! | `flying` | a mechanization in flight |
//! | [`begun`] | a navigator that an alignment comes before |
//! | [`compared`] | arithmetics that are there to be compared with |
//! | [`rates`] | Runge-Kutta on instantaneous rates |
//! | [`stepping`] | step by step, for audits |

mod available;
pub mod begun;
pub mod compared;
mod flying;
pub mod rates;
pub mod stepping;

pub use available::{Unavailable, check, terms, unknown, windows};
pub use flying::{finish, push};

use flying::Flying;

use crate::flight::Edges;
use crate::lanes::abreast::Refused;
use crate::scene::{Navigator, WindowShape};

use schuler::flight::catalogue::{Catalogue, Entry, Every, Visitor};
use schuler::flight::configuration::{Algorithm, Configuration};
use schuler::math::compensated::Pair;
use schuler::sample::Increment;
use schuler::solution::Solution;
use schuler::strapdown::correction::{Correction, CorrectionError};
use schuler::strapdown::limits::Rejected;

/// Who reads rows: how many samples lie behind the row, and the navigation there.
pub type Reader<'a> = dyn FnMut(u64, &Solution<f64>) + 'a;

/// A navigator in flight. Samples come in double precision and are narrowed with a carried rest.
pub trait Navigate: Send {
    /// Takes a sample, and reads the rows that it completes.
    fn push(&mut self, sample: &Increment<f64>, read: &mut Reader) -> Result<(), Rejected>;
    /// Takes a sample of an interval of its own in seconds, and reads the rows that it completes.
    fn push_over(
        &mut self,
        sample: &Increment<f64>,
        interval_s: f64,
        read: &mut Reader,
    ) -> Result<(), Rejected>;
    /// Takes samples without reading a row; stops before one that is refused.
    fn fly(&mut self, samples: &[Increment<f64>]) -> Result<(), Refused>;
    /// Navigation at the end of the last block.
    fn solution(&self) -> Solution<f64>;
    /// Completes the rows that wait for samples.
    fn finish(&mut self, read: &mut Reader);
    /// Sets height and vertical velocity at the end of the last block.
    fn hold_vertical(&mut self, altitude_m: f64, down_m_s: f64) -> Result<(), Rejected>;
    /// Corrects the state at the end of the last block.
    fn correct(&mut self, correction: &Correction<f64>) -> Result<(), CorrectionError>;
    /// Samples integrated so far.
    fn integrated(&self) -> u64;
    /// How long the windows at the edges were so far; `None` for textbook.
    fn edges(&self) -> Option<Edges>;
    /// Digest of every state so far.
    fn digest(&self) -> u64;
    /// Flies samples from the start again, after those `before`, without reading a row: what a stage
    /// costs. Only what comes after `before` is flown each time that it is called.
    fn fly_unread(
        &self,
        before: &[Increment<f64>],
        samples: &[Increment<f64>],
    ) -> Box<dyn FnMut() + '_>;
}

impl Navigator {
    /// As the catalogue has it, with a window for the taylor algorithm.
    pub fn configuration(&self, window: WindowShape) -> Configuration {
        let &Self { precision, frame: axes, algorithm, .. } = self;
        let window = match algorithm {
            Algorithm::Taylor => window,
            Algorithm::Textbook => Configuration::ONE_SAMPLE,
        };
        Configuration { precision, axes, algorithm, window }
    }
}

/// Starts the navigator that is asked for, with the window and the order of series that are given.
pub fn start(
    navigator: &Navigator,
    shape: WindowShape,
    order: usize,
    interval_s: Pair<f64>,
    initial: &Solution<f64>,
) -> Result<Box<dyn Navigate>, Unavailable> {
    let asked = navigator.configuration(shape);
    let started = Every::visit(&asked, Start { order, interval_s, initial });
    started.unwrap_or_else(|| Err(unknown(&asked)))
}

/// The start of a navigator by its type.
struct Start<'a> {
    order: usize,
    interval_s: Pair<f64>,
    initial: &'a Solution<f64>,
}

impl Visitor for Start<'_> {
    type Result = Result<Box<dyn Navigate>, Unavailable>;

    fn visit<M: Entry>(self) -> Self::Result {
        let interval_s = Pair::narrow(self.interval_s);
        let mechanization = M::AnyInterval::configured(interval_s, self.order)?;
        Ok(Flying::boxed(mechanization, interval_s, self.initial)?)
    }
}
