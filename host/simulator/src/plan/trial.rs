//! Trial flights: windows on stretches of the motion, each block against the true one, and in passages
//! flown by the navigator itself.
//!
//! The errors of a window's blocks, in north, east and down, grow into a position error by the unaided
//! growth laws, starting from the errors of the flight's beginning. Weighted means remove oscillations, whose errors
//! cancel except for the phase in which they began. Nothing here depends on a clock: every machine makes the
//! same choice.

use super::candidate::Candidate;
use super::growth::{self, Rate};
use super::mean::Mean;
use super::middle::Told;
use super::passage::{Left, Passages, WHOLE};
use super::reference::{MARGIN, Miss, Part, Stretch};
use crate::scene::WindowShape;
use schuler::math::compensated::Pair;
use schuler::math::vector::Vector;
use schuler::sample::Increment;
use schuler::strapdown::limits::MOST_TURN;
use schuler::trajectory::Trajectory;

/// Samples of a stretch: whole blocks of every window, which begin anew together.
const STRETCH: usize = 120;
/// Stretches at least and at most, and the share of the flight that they are.
const FEWEST: u64 = 4;
const MOST: u64 = 12;
const SHARE: u64 = 50;
/// Times that the turning is looked at.
const LOOKS: u32 = 256;
/// Groups of looks that are compared.
const GROUPS: usize = 4;

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
}

/// What a trial found of a window.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tried {
    /// The window.
    pub shape: WindowShape,
    /// The order of its series.
    pub order: usize,
    /// The position that its truncation leads to at the end, m.
    pub predicted_m: f64,
}

/// Stretches of a flight, ready to be flown by any window.
pub struct Trial<'a, T> {
    pub(super) flight: &'a Flight<'a, T>,
    pub(super) duration_s: f64,
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
        let count = match samples {
            // Passages are all of it.
            0..=WHOLE => 0,
            _ => (samples / (SHARE * STRETCH as u64)).clamp(FEWEST, MOST),
        };
        let share = samples / count.max(1);
        let grid = if share >= 2 * STRETCH as u64 { STRETCH as u64 } else { 4 };
        let stretches = (0..count)
            .map(|n| {
                let within = share.saturating_sub(STRETCH as u64) as f64 * golden(n);
                let first = (n * samples / count + within as u64) / grid * grid;
                let centre_s = (n as f64 + 0.5) * duration_s / count as f64;
                (centre_s, Stretch::new(motion, interval_s, first, STRETCH))
            })
            .collect();
        let mut most = [0.0_f64; GROUPS];
        for n in 0..LOOKS {
            let part = (f64::from(n) + golden(n.into())) / f64::from(LOOKS);
            let rate = motion.rates_at(Pair::new(part * duration_s)).rate_ib_b;
            if let Some(most) = most.get_mut(n as usize % GROUPS) {
                *most = rate.into_array().into_iter().fold(*most, |most, w| most.max(w.abs()));
            }
        }
        // What lies between the looks exceeds them by as much as some looks exceed others.
        let [least, seen] =
            [f64::min, f64::max].map(|of| most.into_iter().reduce(of).unwrap_or_default());
        let seen = 1.01 * seen + 2.0 * (seen - least);
        let turns = [motion.bound().angular_rate, seen].map(|w| w * interval_s);
        Self { flight, duration_s, stretches, turns }
    }

    /// Whether a navigator takes every sample in blocks of so many.
    pub fn is_taken(&self, block: usize) -> bool {
        let [bound, seen] = self.turns;
        bound.min(seen) * block as f64 <= MOST_TURN
    }

    /// What a window's blocks add, stretch by stretch.
    pub(super) fn of_window(&self, candidate: &Candidate, order: usize) -> Vec<Rate> {
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
        let WindowShape { history, block, lookahead } = candidate.shape;
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

    /// Where what is left of passages leads to together with what blocks add from then on; and without that.
    pub(super) fn predicted_m(&self, left: &Left, blocks: &[Rate], is_whole: bool) -> [f64; 2] {
        if is_whole {
            return [left.most_m; 2];
        }
        let still = Rate::default();
        let led_m =
            |begun: &Rate, rates: &[Rate]| growth::position_m(begun, rates, self.duration_s);
        // Stretches resolve what lies below rounding, passages what comes back after hundreds of samples, and
        // either weight other swings: each finds too much where another is better. Steps are in passages
        // alone.
        let by = |weight: usize| {
            let told = left.told.iter().filter_map(|told| told.get(weight));
            let added: Vec<_> = told.clone().map(|told| told.added).collect();
            let steps: Vec<_> =
                added.iter().map(|rate| Rate { tilt: Vector::ZERO, ..*rate }).collect();
            let begun = told.map(|told| told.middle).next().unwrap_or_default();
            let steady_m = led_m(&begun, blocks).min(led_m(&begun, &added));
            [steady_m.max(led_m(&still, &steps)), led_m(&begun, &[])]
        };
        let ([one_m, one_begun_m], [other_m, other_begun_m]) = (by(0), by(1));
        [one_m.min(other_m), one_begun_m.min(other_begun_m)]
            .map(|m| left.most_m.max(m) + left.end_m)
    }

    /// What a window may leave of what is flown, which has roundings of its own, m.
    pub fn enough_m(&self, most_m: f64) -> f64 {
        most_m + ROUNDINGS * growth::rounding_m(0.0) + 2.0 * self.rounding_m()
    }

    /// The lowest order of a window's series that leaves no more than it may of what the highest does.
    pub fn order(&self, passages: &Passages, candidate: &Candidate, most_m: f64) -> usize {
        let (enough_m, still) = (self.enough_m(most_m), Rate::default());
        let led_m =
            |begun: &Rate, rates: &[Rate]| growth::position_m(begun, rates, self.duration_s);
        let Some(whole) = passages.fly(candidate, candidate.terms) else { return candidate.terms };
        let is_enough = |order: usize| {
            if led_m(&still, &self.of_order(candidate, order)) > SERIES * most_m {
                return false;
            }
            let left = passages.fly(candidate, order);
            left.is_some_and(|left| {
                let apart = |(a, b): (&[Told; 2], &[Told; 2])| {
                    let of = |i: usize| Some(a.get(i)?.middle.less(&b.get(i)?.middle));
                    [0, 1].map(|i| of(i).map_or(0.0, |apart| led_m(&apart, &[])))
                };
                let apart_m = left.told.iter().zip(&whole.told).next().map_or([0.0; 2], apart);
                // A row within a block has the whole of what its series leaves.
                let rows_m = (left.most_m - whole.most_m).abs();
                let of_rows_m = SERIES * most_m + ROUNDINGS * growth::rounding_m(0.0);
                rows_m <= of_rows_m && apart_m.into_iter().fold(0.0, f64::max) <= enough_m
            })
        };
        let lower = candidate.orders().into_iter().filter(|&order| order < candidate.terms);
        let mut enough = lower.filter(|&order| is_enough(order));
        enough.next().unwrap_or(candidate.terms)
    }

    /// What one rounding may cost over the flight, m.
    pub fn rounding_m(&self) -> f64 {
        growth::rounding_m(self.duration_s)
    }
}

/// Roundings of coordinates that what is flown has of its own, the true ones and the computed ones.
const ROUNDINGS: f64 = 4.0;
/// What the rest of a series may leave of what a window may: it adds up, where roundings do not.
const SERIES: f64 = 0.25;
