//! The beginning of a flight and its end, or all of a short one, flown by the navigator itself: with its
//! windows at the edges, its steps and its rows.
//!
//! Stretches show what later blocks add. The error of an edge, and the phase in which the errors of an
//! oscillating motion begin, show only in the flight's own beginning; the error of the steps shows in
//! passages of some length.

use super::candidate::Candidate;
use super::middle::{Middle, Told};
use crate::navigator;
use crate::scene::{Navigator, Precision, Scene, WindowShape};
use crate::source::Source;
use schuler::flight::plan;
use schuler::math::compensated::Pair;
use schuler::sample::Increment;
use schuler::solution::Solution;

/// Samples of the beginning and of the end; a flight that is no longer than both is flown whole.
const BEGINNING: u64 = 600;
const END: u64 = 300;
pub const WHOLE: u64 = BEGINNING + END;
/// Samples of a longer beginning, at most.
const LONGER: u64 = 4800;
/// Samples of a block whose rows within it count.
const LONG: usize = 6;

/// What a window leaves of the passages of a flight.
#[derive(Clone, Debug)]
pub struct Left {
    /// The largest error of a position in the beginning, m.
    pub most_m: f64,
    /// What the end's edge adds, m.
    pub end_m: f64,
    /// What each passage tells, by either weight.
    pub told: Vec<[Told; 2]>,
}

/// Samples and truth of a part of a flight.
struct Passage {
    first: u64,
    initial: Solution<f64>,
    samples: Vec<Increment<f64>>,
    truth: Vec<Solution<f64>>,
}

impl Passage {
    fn new(source: &Source, first: u64, count: u64) -> Self {
        let numbers = first + 1..=first + count;
        Self {
            first,
            initial: source.initial(first),
            samples: numbers.clone().map(|n| source.perfect_sample(n)).collect(),
            truth: numbers.map(|n| source.truth(n)).collect(),
        }
    }
}

/// A flight's beginning and end, or all of it in one.
pub struct Passages<'a> {
    scene: &'a Scene,
    source: &'a Source,
    navigator: Navigator,
    interval_s: Pair<f64>,
    passages: Vec<Passage>,
    /// Whether they are all of the flight.
    pub is_whole: bool,
}

impl<'a> Passages<'a> {
    /// Of a scene with perfect sensors and double precision, whatever it has.
    pub fn new(scene: &'a Scene, source: &'a Source) -> Self {
        let all = scene.samples();
        let is_whole = all <= WHOLE;
        let navigator = Navigator { precision: Precision::F64, ..scene.navigator };
        let interval_s = Pair::new(scene.rate_hz).reciprocal();
        let mut passages = vec![Passage::new(source, 0, if is_whole { all } else { BEGINNING })];
        if !is_whole {
            let end = Passage::new(source, all - END, END);
            // None begins at a pole in local-level axes.
            let (window, order) = (plan::UNKNOWN, plan::HIGHEST_ORDER);
            if navigator::start(&navigator, window, order, interval_s, &end.initial).is_ok() {
                passages.push(end);
            }
        }
        Self { scene, source, navigator, interval_s, passages, is_whole }
    }

    /// A longer beginning of the same flight, or all of it, without its end.
    pub fn longer(&self) -> Self {
        let all = self.scene.samples();
        Self {
            navigator: self.navigator,
            passages: vec![Passage::new(self.source, 0, all.min(LONGER))],
            is_whole: all <= LONGER,
            ..*self
        }
    }

    /// Flies them; `None` where the navigator refuses.
    pub fn fly(&self, candidate: &Candidate, order: usize) -> Option<Left> {
        let flown = self.passages.iter().map(|passage| self.fly_one(passage, candidate, order));
        let flown: Vec<_> = flown.collect::<Option<_>>()?;
        let most_m = flown.first()?.most_m;
        let end_m = flown.get(1).map_or(0.0, |end| end.most_m);
        Some(Left { most_m, end_m, told: flown.iter().map(Middle::told).collect() })
    }

    fn fly_one(&self, passage: &Passage, candidate: &Candidate, order: usize) -> Option<Middle> {
        let WindowShape { history, block, lookahead } = candidate.shape;
        let (shape, start) = (candidate.shape, &passage.initial);
        let mut navigator =
            navigator::start(&self.navigator, shape, order, self.interval_s, start).ok()?;
        let all = passage.samples.len();
        let mut middle = Middle::new(all, self.interval_s.hi);
        let is_end = passage.first > 0;
        let truth = |n: u64| (n as usize).checked_sub(1).and_then(|n| passage.truth.get(n));
        // Rows within short blocks are as good as their ends.
        let edge = 2 * (history + block + lookahead);
        let is_read = block >= LONG && !is_end;
        let unread = if is_read { 0 } else { all.saturating_sub(edge) / block * block };
        let (unread, read) = passage.samples.split_at(unread);
        let mut reached = 0;
        for block in unread.chunks(block) {
            navigator.fly(block).ok()?;
            if navigator.integrated() > reached {
                reached = navigator.integrated();
                middle.add(reached, &navigator.solution(), truth(reached)?);
            }
        }
        if is_end && reached > 0 {
            middle.begin_end(reached, &navigator.solution(), truth(reached)?);
        }
        let mut row = |n: u64, computed: &Solution<f64>| match truth(n) {
            Some(truth) if n.is_multiple_of(block as u64) => middle.add(n, computed, truth),
            Some(truth) => middle.see(n, computed, truth),
            None => {}
        };
        for sample in read {
            navigator.push(sample, &mut row).ok()?;
        }
        if is_end || self.is_whole {
            navigator.finish(&mut row);
        }
        Some(middle)
    }
}
