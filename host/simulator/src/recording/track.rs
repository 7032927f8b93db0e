//! A computed motion that can be asked for at any time.

use crate::flight::Nine;
use schuler::drift::compare::{Drift, drift};
use schuler::math::vector::Vector;
use schuler::solution::Solution;

/// States with their times, s, in order.
#[derive(Clone, Debug, Default)]
pub struct Track {
    times_s: Vec<f64>,
    states: Vec<Solution<f64>>,
    /// What is claimed of each, where anything is.
    sigmas: Vec<Nine>,
}

impl Track {
    /// Adds a later state; one of no later time is left out.
    pub fn push(&mut self, time_s: f64, state: &Solution<f64>) {
        if self.times_s.last().is_none_or(|last_s| time_s > *last_s) {
            self.times_s.push(time_s);
            self.states.push(*state);
        }
    }

    /// The last state as it is corrected, with what is claimed of it.
    pub fn claim(&mut self, state: &Solution<f64>, sigma: Nine) {
        if let Some(last) = self.states.last_mut() {
            *last = *state;
            self.sigmas.resize(self.states.len() - 1, sigma);
            self.sigmas.push(sigma);
        }
    }

    /// What is claimed of the row nearest to a time; `None` where nothing is.
    pub fn claimed(&self, time_s: f64) -> Option<&Nine> {
        self.sigmas.get(self.nearest(time_s))
    }

    /// First and last time, s.
    pub fn span_s(&self) -> Option<[f64; 2]> {
        Some([*self.times_s.first()?, *self.times_s.last()?])
    }

    /// The row nearest to a time.
    fn nearest(&self, time_s: f64) -> usize {
        let after = self.times_s.partition_point(|t| *t < time_s);
        let off = |i: usize| self.times_s.get(i).map_or(f64::INFINITY, |t| (t - time_s).abs());
        let before = after.saturating_sub(1);
        if off(before) <= off(after) { before } else { after }
    }

    /// The state of the nearest row, and how long before the time it is, s.
    pub fn near(&self, time_s: f64) -> Option<(&Solution<f64>, f64)> {
        let base = self.nearest(time_s);
        Some((self.states.get(base)?, time_s - self.times_s.get(base)?))
    }

    /// The state at a time within the span, s: at a row the row itself, between rows the polynomial of third
    /// degree through the four next ones, of each component's difference from the nearest.
    pub fn at(&self, time_s: f64) -> Option<Solution<f64>> {
        let [first_s, last_s] = self.span_s()?;
        let base = self.nearest(time_s);
        let (state, base_s) = (self.states.get(base)?, *self.times_s.get(base)?);
        if time_s == base_s {
            return Some(*state);
        }
        // Ends may be off by the rounding of times.
        let slack_s = 1e-9 * (1.0 + last_s.abs());
        if time_s < first_s - slack_s || time_s > last_s + slack_s {
            return None;
        }
        let left = if time_s < base_s { base.saturating_sub(2) } else { base.saturating_sub(1) };
        let left = left.min(self.times_s.len().saturating_sub(4));
        let nodes = left..(left + 4).min(self.times_s.len());
        let mut sum = Drift::default();
        for node in nodes.clone() {
            if node == base {
                continue;
            }
            // Lagrange: w_i = Π_j (t − t_j)/(t_i − t_j)
            let own_s = self.times_s[node];
            let others =
                nodes.clone().filter(|&other| other != node).map(|other| self.times_s[other]);
            let weight: f64 = others.map(|t| (time_s - t) / (own_s - t)).product();
            let step = drift(&self.states[node], state);
            let add = |sum: Vector<f64>, step: Vector<f64>| sum + step * weight;
            sum = Drift {
                position_ned: add(sum.position_ned, step.position_ned),
                velocity_ned: add(sum.velocity_ned, step.velocity_ned),
                attitude_ned: add(sum.attitude_ned, step.attitude_ned),
            };
        }
        Some(sum.added_to(state))
    }
}
