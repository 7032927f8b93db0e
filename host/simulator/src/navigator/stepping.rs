//! The navigators that are audited, shown step by step.

use super::{Unavailable, unknown};
use schuler::flight::catalogue::{Audited, Catalogue as _, Entry, Visitor};
use schuler::flight::configuration::Configuration;
use schuler::flight::from_double::FromDouble;
use schuler::flight::plan::HIGHEST_ORDER;
use schuler::math::compensated::Pair;
use schuler::math::real::Scalar;
use schuler::record::Record;
use schuler::sample::Increment;
use schuler::solution::Solution;
use schuler::strapdown::limits::{Rejected, StartError};
use schuler::strapdown::mechanization::Mechanization;

/// A state's words, each with its field.
pub type Words = Vec<(&'static str, u64)>;

/// Who sees a step: the number of samples at its end, the body's motion over it, the frame after it.
pub type See<'a> = dyn FnMut(u64, &Words, &Words) + 'a;

/// The words of a state.
pub fn words<S: Record>(state: &S) -> Words {
    let mut words = Vec::new();
    state.record("", &mut |name, bits| words.push((name, bits)));
    words
}

/// A navigator in flight.
pub trait Steps {
    /// Takes a sample and shows the steps that it completes.
    fn push(&mut self, sample: &Increment<f64>, see: &mut See) -> Result<(), Rejected>;
    /// Completes the steps that wait for samples.
    fn finish(&mut self, see: &mut See);
    /// Sets height and vertical velocity.
    fn hold_vertical(&mut self, altitude_m: f64, down_m_s: f64) -> Result<(), Rejected>;
}

/// Every navigator that is audited.
pub fn all() -> Vec<Configuration> {
    let mut all = Vec::new();
    Audited::each(&mut |one| all.push(one));
    all
}

/// Starts one with an interval in seconds from an initial solution.
pub fn start(
    configuration: &Configuration,
    interval_s: Pair<f64>,
    initial: &Solution<f64>,
) -> Result<Box<dyn Steps>, Unavailable> {
    let started = Audited::visit(configuration, Start(interval_s, initial));
    Ok(started.ok_or_else(|| unknown(configuration))??)
}

/// The start of a navigator by its type, its series of full order.
struct Start<'a>(Pair<f64>, &'a Solution<f64>);

impl Visitor for Start<'_> {
    type Result = Result<Box<dyn Steps>, StartError>;

    fn visit<M: Entry>(self) -> Self::Result {
        let Self(interval_s, initial) = self;
        // The bits are the same, and the host's navigators are there already.
        let mechanization = M::any_interval(Pair::narrow(interval_s), HIGHEST_ORDER)?;
        Ok(Box::new(Stepping(FromDouble::new(mechanization, initial)?)))
    }
}

/// A mechanization with its state.
struct Stepping<M: Mechanization>(FromDouble<M>);

impl<M> Steps for Stepping<M>
where
    M: Mechanization<Real: Scalar, Frame: Record, Body: Record>,
{
    fn push(&mut self, sample: &Increment<f64>, see: &mut See) -> Result<(), Rejected> {
        self.0.push_by(sample, &mut |m, state, sample| {
            m.push_blocks(state, sample, |n, body, frame| see(n, &words(body), &words(frame)))
        })
    }

    fn finish(&mut self, see: &mut See) {
        self.0.flight.finish_by(|m, state| {
            m.finish_blocks(state, |n, body, frame| see(n, &words(body), &words(frame)));
        });
    }

    fn hold_vertical(&mut self, altitude_m: f64, down_m_s: f64) -> Result<(), Rejected> {
        self.0.hold_vertical(altitude_m, down_m_s)
    }
}
