//! The choice: the cheapest window without loss of accuracy, or else the best.

use super::candidate::Candidate;
use super::growth::{self, Rate};
use super::passage::Passages;
use super::step;
use super::trial::{Flight, Trial, Tried};
use schuler::trajectory::Trajectory;
use std::cell::OnceCell;

/// Times better that a window must be without what is added steadily, for a longer beginning to be flown.
const HIDDEN: f64 = 1.5;
/// Times worse than the best that is as good.
const NEAR: f64 = 1.25;
/// Times worse that a window may be before one is flown that looks one way.
const MUCH: f64 = 2.0;

impl<T: Trajectory<f64>> Trial<'_, T> {
    /// Tries windows, the cheapest first, until one leaves no more than it may: that one, or else the best,
    /// with how many were tried, on stretches or flown.
    pub fn choose(
        &self,
        passages: &Passages,
        candidates: &[Candidate],
        most_m: f64,
    ) -> (Option<Tried>, usize) {
        let enough_m = self.enough_m(most_m);
        let mut flown = Vec::new();
        let mut waiting = Vec::new();
        let is_taken =
            |candidate: &&Candidate| self.is_taken(candidate.shape.block) || passages.is_whole;
        let longer = OnceCell::new();
        let longer = || longer.get_or_init(|| passages.longer());
        for candidate in candidates.iter().filter(is_taken) {
            let blocks = self.of_window(candidate, candidate.terms);
            if !passages.is_whole && !self.is_lossless(candidate, &blocks, most_m) {
                waiting.push((candidate, blocks));
                continue;
            }
            let Some(mut one) = self.fly(passages, candidate, &blocks) else { continue };
            if one.tried.predicted_m > enough_m && one.least_m <= enough_m && !passages.is_whole {
                one.again(self.fly(longer(), candidate, &blocks));
            }
            let first = one.tried;
            flown.push(one);
            if first.predicted_m <= enough_m {
                return (Some(first), flown.len() + waiting.len());
            }
        }
        let tried = flown.len() + waiting.len();
        let others = waiting.into_iter();
        flown.extend(
            others.filter_map(|(candidate, blocks)| self.fly(passages, candidate, &blocks)),
        );
        let place = |one: &Flown| candidates.iter().position(|c| c.shape == one.tried.shape);
        flown.sort_by_key(place);
        let mut best = best(&flown, enough_m);
        // What is left of a swing may hide what is much better: a longer beginning tells.
        if let Some(first) = best
            && flown.iter().any(|one| HIDDEN * one.least_m < first.predicted_m)
            && !passages.is_whole
        {
            let may_do = |one: &&mut Flown| {
                one.tried.shape == first.shape || HIDDEN * one.least_m < first.predicted_m
            };
            for one in flown.iter_mut().filter(may_do) {
                let blocks = std::mem::take(&mut one.blocks);
                one.again(self.fly(longer(), &one.candidate, &blocks));
            }
            best = self::best(&flown, enough_m);
        }
        (best, tried)
    }

    /// Whether what a window's blocks and steps add is no more than it may be.
    fn is_lossless(&self, candidate: &Candidate, blocks: &[Rate], most_m: f64) -> bool {
        let Flight { motion, interval_s, earth_fixed, .. } = *self.flight;
        let blocks_m = growth::position_m(&Rate::default(), blocks, self.duration_s);
        let step = || {
            let block = candidate.shape.block;
            step::position_m(motion, interval_s, block, self.duration_s, earth_fixed)
        };
        blocks_m <= most_m && blocks_m + step() <= most_m
    }

    fn fly(&self, passages: &Passages, candidate: &Candidate, blocks: &[Rate]) -> Option<Flown> {
        let left = passages.fly(candidate, candidate.terms)?;
        let [predicted_m, least_m] = self.predicted_m(&left, blocks, passages.is_whole);
        Some(Flown {
            candidate: *candidate,
            tried: Tried { shape: candidate.shape, order: candidate.terms, predicted_m },
            least_m,
            end_m: left.end_m,
            blocks: blocks.to_vec(),
        })
    }
}

/// A window that was flown.
struct Flown {
    candidate: Candidate,
    tried: Tried,
    /// What it leaves if nothing is added after the beginning, m.
    least_m: f64,
    /// What the end's edge adds, m.
    end_m: f64,
    /// What its blocks add.
    blocks: Vec<Rate>,
}

impl Flown {
    /// Takes what a longer beginning tells.
    fn again(&mut self, longer: Option<Self>) {
        if let Some(longer) = longer {
            self.tried.predicted_m = longer.tried.predicted_m + self.end_m;
        }
    }
}

/// The first of those that are near the best.
fn best(flown: &[Flown], enough_m: f64) -> Option<Tried> {
    // Windows that look one way take noise along: only where they are much better.
    let is_balanced = |one: &Tried| one.shape.history == one.shape.lookahead;
    let least = |balanced: bool| {
        let of_kind = flown.iter().map(|one| &one.tried).filter(|one| is_balanced(one) == balanced);
        of_kind.fold(f64::INFINITY, |best, one| best.min(one.predicted_m))
    };
    let (balanced_m, other_m) = (least(true), least(false));
    let balanced = MUCH * other_m >= balanced_m;
    let best_m = if balanced { balanced_m } else { other_m };
    let most_m = enough_m.max(NEAR * best_m);
    let near = |one: &&Tried| one.predicted_m <= most_m && (!balanced || is_balanced(one));
    flown.iter().map(|one| &one.tried).find(near).copied()
}
