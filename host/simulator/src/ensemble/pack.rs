//! Runs in lanes. A lane whose run has failed continues as a copy of one whose run has not.

use super::held::Held;
use super::runs::{Failure, Group};
use crate::lanes::abreast::{Refused, SideBySide, replaced};
use crate::lanes::pack::Lanes;
use crate::lanes::sensors::{Sensors, in_lanes, same};
use crate::source::Source;
use crate::timing;
use schuler::sample::Increment;
use schuler::solution::Solution;
use schuler::strapdown::limits::Rejected;
use std::ops::Range;
use std::slice;

/// Samples that pass from the sensors to the navigator at once: they stay in the first cache.
const PIECE: usize = 64;

/// Runs abreast. Idle lanes, where there are fewer runs than lanes, take the samples of another one.
pub(super) struct Pack<'a, P: Lanes<N>, const N: usize> {
    abreast: Box<dyn SideBySide<P, N>>,
    source: &'a Source,
    /// `None` where they are perfect.
    sensors: Option<Sensors<P, N>>,
    runs: Vec<Run>,
    /// Samples taken.
    taken: u64,
}

/// What a lane flies.
struct Run {
    number: u64,
    failure: Option<Failure>,
    /// Samples in which a sensor was at its limit, until the run failed.
    saturated: u64,
}

impl<'a, P: Lanes<N>, const N: usize> Pack<'a, P, N> {
    /// Runs of these numbers, at their start.
    pub fn new(abreast: Box<dyn SideBySide<P, N>>, source: &'a Source, runs: Range<u64>) -> Self {
        let sensors = source.start_lanes(runs.start);
        let run = |number| Run { number, failure: None, saturated: 0 };
        Self { abreast, source, sensors, runs: runs.map(run).collect(), taken: 0 }
    }

    /// What the sensors make of perfect increments, piece by piece.
    fn measure(
        &mut self,
        perfect: &[Increment<f64>],
        mut take: impl FnMut(&mut Self, &mut [Increment<P>]) -> bool,
    ) {
        // Made for the call, not kept by every group of runs.
        let terms = self.source.emulator.as_ref().map(in_lanes);
        let mut measured = Vec::with_capacity(PIECE);
        for perfect in perfect.chunks(PIECE) {
            let Some(by) = self.flying() else { return };
            measured.clear();
            match (&terms, &mut self.sensors) {
                (Some(terms), Some(sensors)) => sensors.read(terms, perfect, &mut measured),
                _ => measured.extend(perfect.iter().map(same)),
            }
            for lane in (0..N).filter(|&lane| !self.flies(lane)) {
                for sample in &mut measured {
                    *sample = replaced(sample, lane, by);
                }
            }
            if !take(self, &mut measured) {
                return;
            }
        }
    }

    /// Whether a lane's run goes on.
    fn flies(&self, lane: usize) -> bool {
        self.runs.get(lane).is_some_and(|run| run.failure.is_none())
    }

    /// The first lane whose run goes on.
    fn flying(&self) -> Option<usize> {
        (0..N).find(|&lane| self.flies(lane))
    }

    /// Takes what was measured.
    fn push(&mut self, measured: &[Increment<P>], held: Option<&Held>) -> Result<(), Refused> {
        let Some(held) = held else { return self.abreast.push(measured) };
        for (taken, sample) in measured.iter().enumerate() {
            let before = self.abreast.integrated();
            let at = |reason| Refused { taken, reason };
            self.abreast.push(slice::from_ref(sample)).map_err(|refused| at(refused.reason))?;
            let reached = self.abreast.integrated();
            if reached != before {
                let [altitude_m, down_m_s] = held.at(reached);
                self.abreast.hold_vertical(altitude_m, down_m_s).map_err(at)?;
            }
        }
        Ok(())
    }

    /// Takes a piece of what was measured; whether any run goes on.
    fn take(&mut self, measured: &mut [Increment<P>], held: Option<&Held>) -> bool {
        let mut from = 0;
        while let Err(refused) = self.push(measured.get(from..).unwrap_or(&[]), held) {
            from += refused.taken;
            if !self.part(measured, from, refused.reason) {
                return false;
            }
        }
        self.taken += measured.len() as u64;
        true
    }

    /// Ends the runs that refuse a measured sample, or all where it is no run's own matter. Whether any
    /// goes on.
    fn part(&mut self, measured: &mut [Increment<P>], from: usize, why: Rejected) -> bool {
        let alone = match measured.get(from) {
            Some(sample) if why != Rejected::Held => self.abreast.refusals(sample),
            _ => [None; N],
        };
        let refusals = if alone.iter().all(Option::is_none) { [Some(why); N] } else { alone };
        let sample = self.taken + from as u64 + 1;
        let saturated = self.sensors.as_ref().map_or([0; N], Sensors::saturated);
        let lanes = self.runs.iter_mut().zip(refusals).zip(saturated);
        for ((run, why), saturated) in lanes.filter(|((run, _), _)| run.failure.is_none()) {
            run.saturated = saturated;
            run.failure = why.map(|why| Failure { run: run.number, sample, why });
        }
        let Some(by) = self.flying() else { return false };
        for lane in (0..N).filter(|&lane| refusals[lane].is_some()) {
            self.abreast.replace(lane, by);
            for sample in measured.iter_mut().skip(from) {
                *sample = replaced(sample, lane, by);
            }
        }
        true
    }
}

impl<P: Lanes<N>, const N: usize> Group for Pack<'_, P, N> {
    fn fly(&mut self, perfect: &[Increment<f64>], held: Option<&Held>) {
        self.measure(perfect, |pack, measured| pack.take(measured, held));
    }

    fn failures(&self) -> Vec<Failure> {
        self.runs.iter().filter_map(|run| run.failure).collect()
    }

    fn goes_on(&self) -> bool {
        self.flying().is_some()
    }

    fn finish(&mut self) {
        self.abreast.finish();
    }

    fn integrated(&self) -> u64 {
        self.abreast.integrated()
    }

    fn solutions(&self) -> Vec<Option<Solution<f64>>> {
        let all = self.abreast.solutions();
        let runs = self.runs.iter().zip(all);
        runs.map(|(run, solution)| run.failure.is_none().then_some(solution)).collect()
    }

    fn saturated(&self) -> u64 {
        let until_now = self.sensors.as_ref().map_or([0; N], Sensors::saturated);
        let runs = self.runs.iter().zip(until_now);
        runs.map(|(run, until_now)| run.failure.map_or(until_now, |_| run.saturated)).sum()
    }

    fn navigation_ns(&mut self, before: &[Increment<f64>], perfect: &[Increment<f64>]) -> f64 {
        // What cannot be right was refused in the flight itself.
        self.fly(before, None);
        let mut samples = Vec::new();
        self.measure(perfect, |_, measured| {
            samples.extend_from_slice(measured);
            true
        });
        timing::per_sample((perfect.len() * N) as u64, &mut || {
            std::hint::black_box(self.abreast.fly_copy(&samples));
        })
    }
}
