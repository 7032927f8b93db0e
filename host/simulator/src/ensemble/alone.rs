//! One run by itself.

use super::held::Held;
use super::runs::{Failure, Group};
use crate::lanes::abreast::Refused;
use crate::navigator::Navigate;
use crate::source::{Samples, Source};
use crate::timing;
use schuler::sample::Increment;
use schuler::solution::Solution;
use std::slice;

/// One run by itself.
pub(super) struct Alone<'a> {
    navigator: Box<dyn Navigate>,
    run: u64,
    stream: Samples<'a>,
    /// Samples before its first one.
    before: u64,
    /// Samples taken.
    taken: u64,
    failure: Option<Failure>,
}

impl<'a> Alone<'a> {
    /// The run of a number, with a navigator at its start.
    /// It begins after samples that an alignment has taken.
    pub fn new(navigator: Box<dyn Navigate>, source: &'a Source, run: u64, before: u64) -> Self {
        Self { navigator, run, stream: source.start(run), before, taken: 0, failure: None }
    }

    fn measure(&mut self, perfect: &[Increment<f64>]) -> Vec<Increment<f64>> {
        perfect.iter().map(|perfect| self.stream.sense(perfect)).collect()
    }

    fn push(&mut self, measured: &[Increment<f64>], held: Option<&Held>) -> Result<(), Refused> {
        let Some(held) = held else { return self.navigator.fly(measured) };
        for (taken, sample) in measured.iter().enumerate() {
            let before = self.navigator.integrated();
            let at = |reason| Refused { taken, reason };
            self.navigator.fly(slice::from_ref(sample)).map_err(|refused| at(refused.reason))?;
            let reached = self.navigator.integrated();
            if reached != before {
                let [altitude_m, down_m_s] = held.at(reached);
                self.navigator.hold_vertical(altitude_m, down_m_s).map_err(at)?;
            }
        }
        Ok(())
    }
}

impl Group for Alone<'_> {
    fn fly(&mut self, perfect: &[Increment<f64>], held: Option<&Held>) {
        if self.failure.is_some() {
            return;
        }
        let measured = self.measure(perfect);
        let passed = self.before.saturating_sub(self.taken).min(measured.len() as u64);
        let flown = &measured[passed as usize..];
        if let Err(Refused { taken, reason }) = self.push(flown, held) {
            let sample = self.taken + passed + taken as u64 + 1;
            self.failure = Some(Failure { run: self.run, sample, why: reason });
        }
        self.taken += perfect.len() as u64;
    }

    fn failures(&self) -> Vec<Failure> {
        self.failure.into_iter().collect()
    }

    fn goes_on(&self) -> bool {
        self.failure.is_none()
    }

    fn finish(&mut self) {
        self.navigator.finish(&mut |_, _| {});
    }

    fn integrated(&self) -> u64 {
        self.navigator.integrated()
    }

    fn solutions(&self) -> Vec<Option<Solution<f64>>> {
        vec![self.goes_on().then(|| self.navigator.solution())]
    }

    fn saturated(&self) -> u64 {
        self.stream.saturated()
    }

    fn navigation_ns(&mut self, before: &[Increment<f64>], perfect: &[Increment<f64>]) -> f64 {
        let (before, measured) = (self.measure(before), self.measure(perfect));
        let mut pass = self.navigator.fly_unread(&before, &measured);
        timing::per_sample(measured.len() as u64, &mut pass)
    }
}
