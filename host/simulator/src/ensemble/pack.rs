//! Runs in lanes. A lane whose run has failed continues as a copy of one whose run has not.

use super::held::Held;
use super::runs::{Failure, Group};
use crate::lanes::abreast::{Abreast, Packed, Refused, pack, replaced};
use crate::source::{Samples, Source};
use crate::timing;
use schuler::output::Output;
use schuler::sample::Increment;
use schuler::solution::Solution;
use schuler::strapdown::block::window::Window;
use schuler::strapdown::limits::Rejected;
use std::array;
use std::ops::Range;
use std::slice;

/// Samples that pass from the sensors to the navigator at once: they stay in the first cache.
const PIECE: usize = 64;

/// Runs abreast; with fewer than lanes, the last one flies in the idle ones too.
pub(super) struct Pack<'a, F: Packed<N>, W: Window, const N: usize> {
    abreast: Abreast<F, W, N>,
    runs: Vec<Run<'a>>,
    /// Samples taken.
    taken: u64,
    measured: Vec<Increment<F::Real>>,
}

/// What a lane flies.
struct Run<'a> {
    number: u64,
    stream: Samples<'a>,
    failure: Option<Failure>,
}

impl<'a, F: Packed<N>, W: Window, const N: usize> Pack<'a, F, W, N> {
    /// Runs of these numbers, at their start.
    pub fn new(abreast: Abreast<F, W, N>, source: &'a Source, runs: Range<u64>) -> Self {
        let run = |number| Run { number, stream: source.start(number), failure: None };
        Self { abreast, runs: runs.map(run).collect(), taken: 0, measured: Vec::new() }
    }

    fn measure(&mut self, perfect: &[Increment<f64>]) {
        self.measured.clear();
        for perfect in perfect {
            let mut last = *perfect;
            let lanes: [_; N] = array::from_fn(|lane| {
                if let Some(Run { stream, failure: None, .. }) = self.runs.get_mut(lane) {
                    last = stream.sense(perfect);
                }
                last
            });
            self.measured.push(pack(&lanes));
        }
    }

    /// Takes what was measured from a sample on.
    fn push(&mut self, from: usize, held: Option<&Held>) -> Result<(), Refused> {
        let measured = self.measured.get(from..).unwrap_or(&[]);
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

    /// Ends the runs that refuse a measured sample, or all where it is no run's own matter. Whether any
    /// goes on.
    fn part(&mut self, from: usize, why: Rejected) -> bool {
        let alone = match self.measured.get(from) {
            Some(sample) if why != Rejected::Held => self.abreast.refusals(sample),
            _ => [None; N],
        };
        let refusals = if alone.iter().all(Option::is_none) { [Some(why); N] } else { alone };
        let sample = self.taken + from as u64 + 1;
        let lanes = self.runs.iter_mut().zip(refusals);
        for (run, why) in lanes.filter(|(run, _)| run.failure.is_none()) {
            run.failure = why.map(|why| Failure { run: run.number, sample, why });
        }
        let Some(by) = self.runs.iter().position(|run| run.failure.is_none()) else { return false };
        for lane in (0..N).filter(|&lane| refusals[lane].is_some()) {
            self.abreast.replace(lane, by);
            for sample in self.measured.iter_mut().skip(from) {
                *sample = replaced(sample, lane, by);
            }
        }
        true
    }
}

impl<F, W, const N: usize> Group for Pack<'_, F, W, N>
where
    F: Packed<N>,
    W: Window,
    Self: Send,
{
    fn fly(&mut self, perfect: &[Increment<f64>], held: Option<&Held>) {
        for perfect in perfect.chunks(PIECE) {
            if !self.goes_on() {
                return;
            }
            self.measure(perfect);
            let mut from = 0;
            while let Err(refused) = self.push(from, held) {
                from += refused.taken;
                if !self.part(from, refused.reason) {
                    return;
                }
            }
            self.taken += perfect.len() as u64;
        }
    }

    fn failures(&self) -> Vec<Failure> {
        self.runs.iter().filter_map(|run| run.failure).collect()
    }

    fn goes_on(&self) -> bool {
        self.runs.iter().any(|run| run.failure.is_none())
    }

    fn finish(&mut self) {
        self.abreast.finish();
    }

    fn integrated(&self) -> u64 {
        self.abreast.integrated()
    }

    fn solutions(&self) -> Vec<Option<Solution<f64>>> {
        let all = self.abreast.output();
        let runs = self.runs.iter().zip(&all);
        runs.map(|(run, output)| run.failure.is_none().then(|| output.wide())).collect()
    }

    fn saturated(&self) -> u64 {
        self.runs.iter().map(|run| run.stream.saturated()).sum()
    }

    fn navigation_ns(&mut self, before: &[Increment<f64>], perfect: &[Increment<f64>]) -> f64 {
        // What cannot be right was refused in the flight itself.
        self.fly(before, None);
        self.measure(perfect);
        timing::per_sample((perfect.len() * N) as u64, &mut || {
            let mut abreast = self.abreast;
            let _ = abreast.push(&self.measured);
            std::hint::black_box(&abreast);
        })
    }
}
