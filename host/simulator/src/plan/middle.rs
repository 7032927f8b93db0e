//! The errors of a passage without their oscillation: weighted means over its middle, and over its halves.

use super::growth::Rate;
use schuler::drift::compare::{Drift, drift};
use schuler::earth::{EQUATORIAL_GRAVITY, SEMI_MAJOR_AXIS};
use schuler::math::real::Real;
use schuler::math::vector::Vector;
use schuler::solution::Solution;

/// sin²πx: the weight of what lies at a part x of a span, which leaves little of swings that the span holds
/// one or two of.
fn hann(x: f64) -> f64 {
    let (sine, _) = Real::sin_cos(core::f64::consts::PI * x);
    sine * sine
}

/// sin⁴πx, which leaves next to nothing of swings that the span holds three or more of.
pub fn taper(x: f64) -> f64 {
    let hann = hann(x);
    hann * hann
}

/// Weighed errors.
#[derive(Clone, Copy, Default)]
struct Sum {
    weight: f64,
    tilt: Vector<f64>,
    velocity: Vector<f64>,
    position: Vector<f64>,
    /// The true velocity, m/s.
    flown: Vector<f64>,
}

impl Sum {
    fn add(&mut self, weight: f64, drift: &Drift, flown: Vector<f64>) {
        self.weight += weight;
        self.tilt = self.tilt + drift.attitude_ned * weight;
        self.velocity = self.velocity + drift.velocity_ned * weight;
        self.position = self.position + drift.position_ned * weight;
        self.flown = self.flown + flown * weight;
    }

    fn mean(&self) -> Self {
        let per = if self.weight > 0.0 { 1.0 / self.weight } else { 0.0 };
        Self {
            weight: 1.0,
            tilt: self.tilt * per,
            velocity: self.velocity * per,
            position: self.position * per,
            flown: self.flown * per,
        }
    }
}

/// Means over the middle of a passage, and over its halves, by a weight.
#[derive(Clone, Copy, Default)]
struct Means {
    whole: Sum,
    halves: [Sum; 2],
}

/// What a passage tells.
#[derive(Clone, Copy, Debug)]
pub struct Told {
    /// The mean tilt, and those of velocity and position in the places of what is added to them.
    pub middle: Rate,
    /// What tilt, velocity and position gain a second beyond what the tilt makes of the velocity and that
    /// of the position.
    pub added: Rate,
}

/// The weights.
const TAPERS: [fn(f64) -> f64; 2] = [hann, taper];

/// The errors of a passage of some samples.
pub struct Middle {
    count: f64,
    interval_s: f64,
    means: [Means; 2],
    /// The last error before the end: its sample, position and velocity.
    before: Option<(u64, Vector<f64>, Vector<f64>)>,
    /// The largest error of a position, m: of those after the one before the end, beyond what that one leads
    /// to.
    pub most_m: f64,
}

impl Means {
    fn told(&self, time_s: f64, span_s: f64) -> Told {
        let Sum { tilt, velocity, position, .. } = self.whole.mean();
        let middle = Rate { time_s, tilt, acceleration: velocity, velocity: position };
        let [first, second] = self.halves.map(|half| half.mean());
        // δv̇ = θ × f,  f = v̇ − g
        let fallen = Vector::new(0.0, 0.0, EQUATORIAL_GRAVITY * span_s);
        let tilted = ((first.tilt + second.tilt) * 0.5).cross(second.flown - first.flown - fallen);
        let per_s = 1.0 / span_s;
        let moved = (second.position - first.position)
            - (second.velocity + first.velocity) * (0.5 * span_s);
        // Positions are rounded, the true ones and the computed ones: what is no more tells nothing.
        let rounding_m = f64::EPSILON * SEMI_MAJOR_AXIS;
        let told = (1.0 - rounding_m / moved.norm()).max(0.0);
        let added = Rate {
            time_s,
            tilt: (second.tilt - first.tilt) * per_s,
            acceleration: (second.velocity - first.velocity - tilted) * per_s,
            velocity: moved * (told * per_s),
        };
        Told { middle, added }
    }
}

impl Middle {
    /// Nothing yet of so many samples.
    pub fn new(samples: usize, interval_s: f64) -> Self {
        let (means, before) = Default::default();
        Self { count: samples as f64, interval_s, means, before, most_m: 0.0 }
    }

    /// The end of a block, at the end of a sample, from 1.
    pub fn add(&mut self, n: u64, computed: &Solution<f64>, truth: &Solution<f64>) {
        let drift = drift(computed, truth);
        let flown = truth.velocity_ned.map(|v| v.hi);
        let x = n as f64 / self.count;
        for (means, weight) in self.means.iter_mut().zip(TAPERS) {
            means.whole.add(weight(x), &drift, flown);
            let [first, second] = &mut means.halves;
            let half = if x <= 0.5 { first } else { second };
            half.add(weight(2.0 * x), &drift, flown);
        }
        self.see_drift(n, &drift);
    }

    /// A row within a block: its errors come and go.
    pub fn see(&mut self, n: u64, computed: &Solution<f64>, truth: &Solution<f64>) {
        self.see_drift(n, &drift(computed, truth));
    }

    fn see_drift(&mut self, n: u64, drift: &Drift) {
        let mut off = drift.position_ned;
        if let Some((last, position, velocity)) = self.before {
            off = off - position - velocity * (n.saturating_sub(last) as f64 * self.interval_s);
        }
        let off_m = off.norm();
        self.most_m = if off_m.is_nan() { f64::INFINITY } else { self.most_m.max(off_m) };
    }

    /// The end of the sample before the end: what comes after it counts.
    pub fn begin_end(&mut self, n: u64, computed: &Solution<f64>, truth: &Solution<f64>) {
        let drift = drift(computed, truth);
        self.before = Some((n, drift.position_ned, drift.velocity_ned));
        self.most_m = 0.0;
    }

    /// What it tells, by either weight.
    pub fn told(&self) -> [Told; 2] {
        let span_s = 0.5 * self.count * self.interval_s;
        self.means.map(|means| means.told(span_s, span_s))
    }
}
