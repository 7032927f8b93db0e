//! The choice of a window for a path in pieces: each is flown over its beginning, its liveliest minutes and its end.
//!
//! The truth is at hand, so what a window leaves of a manoeuvre shows in the flight itself. What it leaves of
//! attitude, velocity and position grows by the unaided laws up to the end of the flight. Nothing here
//! depends on a clock.

use super::candidate::Candidate;
use super::growth::{self, Rate};
use super::trial::Tried;
use crate::course::Path;
use crate::lively;
use crate::navigator;
use crate::scene::{Navigator, Precision, Scene};
use crate::source::Source;
use schuler::drift::compare::drift;
use schuler::math::compensated::Pair;
use schuler::sample::Increment;
use schuler::solution::Solution;

/// Length of a passage, s, and its samples at most.
const PASSAGE_S: f64 = 60.0;
const MOST_SAMPLES: u64 = 6000;
/// Minutes about lively pieces.
const LIVELY: usize = 2;
/// Samples of the beginning and of the end.
const EDGE: u64 = 600;
/// Every so many samples a row is compared: a number that no block's length divides.
const STRIDE: u64 = 7;
/// Times worse than the best that is as good: roundings differ by as much.
const NEAR: f64 = 1.5;

/// Samples and truth of a part of the flight.
struct Passage {
    begin_s: f64,
    initial: Solution<f64>,
    samples: Vec<Increment<f64>>,
    /// Of every row that is compared, by its number within the passage.
    truth: Vec<(u64, Solution<f64>)>,
}

impl Passage {
    fn new(source: &Source, first: u64, count: u64) -> Self {
        let compared = |n: &u64| n.is_multiple_of(STRIDE) || *n == count;
        Self {
            begin_s: source.time_s(first),
            initial: source.initial(first),
            samples: (first + 1..=first + count).map(|n| source.perfect_sample(n)).collect(),
            truth: (1..=count).filter(compared).map(|n| (n, source.truth(first + n))).collect(),
        }
    }
}

/// Passages of a flight.
pub struct Flown {
    navigator: Navigator,
    interval_s: Pair<f64>,
    duration_s: f64,
    passages: Vec<Passage>,
}

impl Flown {
    /// Of a scene on a path, in double precision with perfect sensors whatever it has.
    pub fn new(scene: &Scene, source: &Source, path: &Path) -> Self {
        let all = scene.samples();
        let length = ((PASSAGE_S * scene.rate_hz) as u64).clamp(1, MOST_SAMPLES);
        let mut starts = vec![(0, EDGE.min(all)), (all.saturating_sub(EDGE), EDGE.min(all))];
        let mut lively = 0;
        for [from_s, to_s] in lively::pieces(&source.course, path) {
            let middle = (0.5 * (from_s + to_s) * scene.rate_hz) as u64;
            let first = middle.saturating_sub(length / 2).min(all.saturating_sub(length));
            let is_new = starts.iter().all(|&(start, _)| start.abs_diff(first) >= length / 2);
            if is_new && middle <= all {
                starts.push((first, length.min(all)));
                lively += 1;
            }
            if lively == LIVELY {
                break;
            }
        }
        Self {
            navigator: Navigator { precision: Precision::F64, ..scene.navigator },
            interval_s: Pair::new(scene.rate_hz).reciprocal(),
            duration_s: all as f64 / scene.rate_hz,
            passages: starts.into_iter().map(|(n, count)| Passage::new(source, n, count)).collect(),
        }
    }

    /// The cheapest window that is as good as the best, or that leaves no more than it may: with how many
    /// were flown, and with what the best leaves, m.
    pub fn choose(&self, candidates: &[Candidate], most_m: f64) -> (Option<Tried>, usize, f64) {
        let flown: Vec<_> = candidates.iter().filter_map(|one| self.try_one(one)).collect();
        let best_m = flown.iter().map(|one| one.predicted_m).fold(f64::INFINITY, f64::min);
        let enough_m = most_m.max(NEAR * best_m);
        let chosen = flown.iter().find(|one| one.predicted_m <= enough_m);
        (chosen.copied(), flown.len(), enough_m)
    }

    /// What a window leaves; `None` where the navigator refuses.
    fn try_one(&self, candidate: &Candidate) -> Option<Tried> {
        let mut predicted_m = 0.0;
        for passage in &self.passages {
            predicted_m += self.fly(passage, candidate)?;
        }
        Some(Tried { shape: candidate.shape, order: candidate.terms, predicted_m })
    }

    /// The largest error of a row, or what the last one leads to; 0 where the navigator cannot start there.
    fn fly(&self, passage: &Passage, candidate: &Candidate) -> Option<f64> {
        let (shape, order) = (candidate.shape, candidate.terms);
        let started =
            navigator::start(&self.navigator, shape, order, self.interval_s, &passage.initial);
        // None begins at a pole in local-level axes.
        let Ok(mut navigator) = started else { return Some(0.0) };
        let mut waiting = passage.truth.iter().peekable();
        let (mut most_m, mut last) = (0.0_f64, Rate::default());
        let mut row = |n: u64, computed: &Solution<f64>| {
            if waiting.peek().is_some_and(|(number, _)| *number == n)
                && let Some((_, truth)) = waiting.next()
            {
                let apart = drift(computed, truth);
                most_m = most_m.max(apart.position_ned.norm());
                last = Rate {
                    time_s: passage.begin_s + n as f64 * self.interval_s.hi,
                    tilt: apart.attitude_ned,
                    acceleration: apart.velocity_ned,
                    velocity: apart.position_ned,
                };
            }
        };
        for sample in &passage.samples {
            navigator.push(sample, &mut row).ok()?;
        }
        navigator.finish(&mut row);
        Some(most_m.max(growth::position_m(&last, &[], self.duration_s)))
    }
}
