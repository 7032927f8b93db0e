//! Trial flights: windows on stretches of the motion, each block against the true one.
//!
//! What a window's blocks miss, resolved in north, east and down, grows into a position by the unaided
//! growth laws. The cheapest window whose position stays below what one rounding costs is flown; where
//! there is none, the best. Nothing here knows a clock: every machine chooses the same.

use super::candidate::Candidate;
use super::growth::{self, Rate};
use super::reference::{MARGIN, Miss, Part, Stretch};
use super::step;
use schuler::imu;
use schuler::math::quaternion::Quaternion;
use schuler::math::vector::Vector;
use schuler::sample::Increment;
use schuler::strapdown::gate::MOST_TURN;
use schuler::strapdown::plan::Shape;
use schuler::trajectory::{Motion, Trajectory};

/// Samples of a stretch: whole blocks of every window but those of three and twelve.
const STRETCH: usize = 40;
/// Stretches at least and at most, and the share of the flight that they are.
const FEWEST: u64 = 8;
const MOST: u64 = 48;
const SHARE: u64 = 50;
/// Samples after which the blocks of every window begin anew together.
const TOGETHER: u64 = 120;
/// Times that the turning is looked at.
const LOOKS: u32 = 256;

/// A flight to plan for.
pub struct Flight<'a, T> {
    /// Its motion.
    pub motion: &'a T,
    /// Seconds between samples.
    pub interval_s: f64,
    /// Its length in samples.
    pub samples: u64,
    /// Whether it is navigated in Earth-fixed axes.
    pub earth_fixed: bool,
    /// The longest reciprocal of an angular frequency of the motion, s; 0 where nothing swings.
    pub wave_s: f64,
}

/// What a trial found of a window.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tried {
    /// The window.
    pub shape: Shape,
    /// The order of its series.
    pub order: usize,
    /// The position that its truncation leads to at the end, m.
    pub predicted_m: f64,
}

/// Stretches of a flight, ready to be flown by any window.
pub struct Trial<'a, T> {
    flight: &'a Flight<'a, T>,
    duration_s: f64,
    stretches: Vec<(f64, Stretch)>,
    /// The largest turn about an axis in a sample, rad: by the motion's bound, and as seen.
    turns: [f64; 2],
}

/// The fractional parts of n·golden ratio: spread evenly, and in step with nothing.
fn golden(n: u64) -> f64 {
    let x = (n + 1) as f64 * 0.618_033_988_749_894_9;
    x - x.floor()
}

impl<'a, T: Trajectory<f64>> Trial<'a, T> {
    /// Picks stretches and integrates their truth.
    pub fn new(flight: &'a Flight<'a, T>) -> Self {
        let Flight { motion, interval_s, samples, .. } = *flight;
        let duration_s = samples as f64 * interval_s;
        let count = (samples / (SHARE * STRETCH as u64)).clamp(FEWEST, MOST);
        let share = samples / count;
        let grid = if share >= 2 * TOGETHER { TOGETHER } else { STRETCH as u64 };
        let stretches = (0..count)
            .map(|n| {
                let within = share.saturating_sub(STRETCH as u64) as f64 * golden(n);
                let first = (n * samples / count + within as u64) / grid * grid;
                let centre_s = (n as f64 + 0.5) * duration_s / count as f64;
                (centre_s, Stretch::new(motion, interval_s, first, STRETCH))
            })
            .collect();
        let seen = (0..LOOKS).map(|n| {
            let part = (f64::from(n) + golden(n.into())) / f64::from(LOOKS);
            let rates = imu::rates(&motion.at(part * duration_s));
            rates.rate_ib_b.into_array().into_iter().fold(0.0, |most: f64, w| most.max(w.abs()))
        });
        let seen = seen.fold(0.0, f64::max);
        let turns = [motion.bound().angular_rate, 1.25 * seen].map(|w| w * interval_s);
        Self { flight, duration_s, stretches, turns }
    }

    /// Whether a navigator takes every sample in blocks of so many.
    pub fn is_taken(&self, block: usize) -> bool {
        let [bound, seen] = self.turns;
        bound.min(seen) * block as f64 <= MOST_TURN
    }

    /// What a window's blocks add, stretch by stretch.
    fn of_window(&self, candidate: &Candidate, order: usize) -> Vec<Rate> {
        self.rates(candidate, |window, half_s, part| {
            (candidate.integrate)(window, half_s, order).map(|body| part.miss(&body))
        })
    }

    /// What its blocks add with a series of a lower order, against their own with the highest.
    fn of_order(&self, candidate: &Candidate, order: usize) -> Vec<Rate> {
        self.rates(candidate, |window, half_s, part| {
            let low = part.miss(&(candidate.integrate)(window, half_s, order)?);
            let high = part.miss(&(candidate.integrate)(window, half_s, candidate.terms)?);
            Some(low.less(&high))
        })
    }

    fn rates(
        &self,
        candidate: &Candidate,
        miss: impl Fn(&[Increment<f64>], f64, &Part) -> Option<Miss>,
    ) -> Vec<Rate> {
        let (history, block, lookahead) = candidate.shape;
        let half_s = 0.5 * block as f64 * self.flight.interval_s;
        let of_stretch = |(time_s, stretch): &(f64, Stretch)| {
            let mut mean = Mean::new(&self.flight.motion.at(stretch.begin_s));
            for (n, part) in Part::blocks(&stretch.parts, block).iter().enumerate() {
                let begin = MARGIN + n * block - history;
                let end = begin + history + block + lookahead;
                let window = stretch.samples.get(begin..end).unwrap_or(&[]);
                if let Some(miss) = miss(window, half_s, part) {
                    mean.add(&miss, part);
                }
            }
            mean.rate(*time_s, 2.0 * half_s)
        };
        self.stretches.iter().map(of_stretch).collect()
    }

    fn position_m(&self, rates: &[Rate]) -> f64 {
        growth::position_m(rates, self.duration_s, self.flight.wave_s)
    }

    /// What a window leaves with its whole series; of its steps in long blocks only where its fit is good
    /// enough for them.
    fn try_out(&self, candidate: &Candidate, most_m: f64, steps: &mut Steps) -> Tried {
        let (_, block, _) = candidate.shape;
        let order = candidate.terms;
        let mut predicted_m = self.position_m(&self.of_window(candidate, order));
        if block <= SHORT || predicted_m <= most_m {
            let Flight { motion, interval_s, earth_fixed, .. } = *self.flight;
            let flown = |&(of, _): &(usize, f64)| of == block;
            let known = steps.iter().copied().find(flown).unwrap_or_else(|| {
                let left_m =
                    step::position_m(motion, interval_s, block, self.duration_s, earth_fixed);
                steps.push((block, left_m));
                (block, left_m)
            });
            predicted_m += known.1;
        }
        Tried { shape: candidate.shape, order, predicted_m }
    }

    /// Tries windows, the cheapest first, until one leaves no more than it may: that one, or else the best,
    /// with all that were tried.
    pub fn choose(&self, candidates: &[Candidate], most_m: f64) -> (Option<Tried>, Vec<Tried>) {
        let mut steps = Vec::new();
        let mut tried = Vec::new();
        for candidate in candidates.iter().filter(|candidate| self.is_taken(candidate.shape.1)) {
            let one = self.try_out(candidate, most_m, &mut steps);
            tried.push(one);
            if one.predicted_m <= most_m {
                return (Some(one), tried);
            }
        }
        // Windows that look one way take noise along: only where they are much better.
        let least = |symmetric: bool| {
            let of_kind = |one: &&Tried| (one.shape.0 == one.shape.2) == symmetric;
            tried.iter().filter(of_kind).fold(f64::INFINITY, |best, one| best.min(one.predicted_m))
        };
        let (balanced_m, other_m) = (least(true), least(false));
        let balanced = 3.0 * other_m >= balanced_m;
        let best_m = if balanced { balanced_m } else { other_m };
        let near = |one: &&Tried| {
            one.predicted_m <= 1.25 * best_m && (!balanced || one.shape.0 == one.shape.2)
        };
        (tried.iter().find(near).copied(), tried)
    }

    /// The lowest order of a window's series that leaves no more than it may.
    pub fn order(&self, candidate: &Candidate, most_m: f64) -> usize {
        let enough = |&order: &usize| {
            order >= candidate.terms || self.position_m(&self.of_order(candidate, order)) <= most_m
        };
        candidate.orders().into_iter().find(enough).unwrap_or(candidate.terms)
    }

    /// What one rounding may cost over the flight, m.
    pub fn rounding_m(&self) -> f64 {
        growth::rounding_m(self.duration_s)
    }
}

/// What steps leave, m, by the samples of their block.
type Steps = Vec<(usize, f64)>;
/// Blocks whose step is always flown.
const SHORT: usize = 4;

/// A stretch's misses in north, east and down.
struct Mean {
    attitude: Quaternion<f64>,
    misses: Vec<(Miss, Vector<f64>)>,
}

impl Mean {
    fn new(motion: &Motion<f64>) -> Self {
        let attitude = motion.solution().attitude.map(|c| c.hi);
        Self { attitude, misses: Vec::new() }
    }

    fn add(&mut self, miss: &Miss, part: &Part) {
        let matrix = self.attitude.matrix(1.0);
        let turned = Miss {
            angle: matrix * miss.angle,
            velocity: matrix * miss.velocity,
            position: matrix * miss.position,
        };
        self.misses.push((turned, matrix * part.velocity()));
        self.attitude = self.attitude + self.attitude * part.rotation();
    }

    fn rate(&self, time_s: f64, block_s: f64) -> Rate {
        let zero = (Vector::ZERO, Vector::ZERO, Vector::ZERO, Vector::ZERO, Vector::ZERO);
        let (mut angle, mut velocity, mut position, mut tilts, mut gained) = zero;
        let mut rectified = Vector::ZERO;
        for (miss, gain) in &self.misses {
            // The tilt in the block's middle, times what it then gains.
            let tilt = angle + miss.angle * 0.5;
            rectified = rectified + tilt.cross(*gain);
            tilts = tilts + tilt;
            gained = gained + *gain;
            angle = angle + miss.angle;
            velocity = velocity + miss.velocity;
            position = position + miss.position;
        }
        let count = self.misses.len().max(1) as f64;
        // Tilt and gain that go together add up; their means are the tilt's own growth.
        rectified = rectified - tilts.cross(gained) * (1.0 / count);
        let per_s = 1.0 / (count * block_s);
        Rate {
            time_s,
            tilt: angle * per_s,
            acceleration: (velocity + rectified) * per_s,
            velocity: position * per_s,
        }
    }
}
