//! The navigators: those of the core's catalogue that are audited.

use crate::recording::{Reader, Stage};
use crate::truth::{Flown, Refused};
use schuler::flight::catalogue::{Audited, Catalogue as _, Entry, Visitor};
use schuler::flight::configuration::Configuration;
use schuler::flight::from_double::FromDouble;
use schuler::flight::plan::HIGHEST_ORDER;

/// Visits every one of them.
pub fn each(mut visit: impl FnMut(&Configuration)) {
    Audited::each(&mut |configuration| visit(&configuration));
}

/// Flies one, from the true state and with the samples that the sensors deliver.
pub fn fly(
    configuration: &Configuration,
    flown: &Flown,
    reader: &mut dyn Reader,
) -> Result<(), Refused> {
    Audited::visit(configuration, Fly(flown, reader)).unwrap_or(Err(Refused))
}

struct Fly<'a, 'b>(&'a Flown<'b>, &'a mut dyn Reader);

impl Visitor for Fly<'_, '_> {
    type Result = Result<(), Refused>;

    fn visit<M: Entry>(self) -> Self::Result {
        let Self(flown, reader) = self;
        let started = FromDouble::<M>::start(flown.interval_s, HIGHEST_ORDER, &flown.initial);
        let mut flying = started.map_err(|_| Refused)?;
        let [mut body, mut nav] = ["body", "nav"].map(Stage::new);
        let mut see = |sample, motion: &M::Body, frame: &M::Frame| {
            body.row(sample, motion, reader);
            nav.row(sample, frame, reader);
        };
        for sample in flown.samples {
            let mut push = |m: &M, state: &mut M::State, sample| {
                m.push_blocks(state, sample, &mut see)
            };
            flying.push_by(sample, &mut push).map_err(|_| Refused)?;
        }
        flying.flight.finish_by(|m, state| m.finish_blocks(state, &mut see));
        body.end(reader);
        nav.end(reader);
        Ok(())
    }
}
