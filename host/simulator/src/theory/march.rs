//! Steps through a course by Kutta's 3/8 rule, whose stages lie at thirds of the step.

use super::course::{Course, Covariance, Instant};
use super::moments::{Fast, Moments};
use schuler::drift::linear::ErrorState;

/// The longest step over the time since the start: moments begin as powers of time, up to the sixth.
const STEP_OVER_TIME: f64 = 0.2;
/// The first step over the sample interval, so that the first sample has those powers too.
const FIRST_STEP: f64 = 0.125;
/// Instants of a step, at thirds.
pub const NODES: usize = 4;

/// The moments at both ends of the current step.
#[derive(Clone)]
pub struct March {
    /// Start of the step, s.
    pub start_s: f64,
    /// Its length, s.
    pub step_s: f64,
    /// The course at thirds of the step.
    pub nodes: [Instant; NODES],
    start: Moments,
    start_rate: Moments,
    end: Moments,
    end_rate: Moments,
    /// How many biases have their own covariance with the error; the others are faster than a step.
    slow: usize,
    fast: Fast,
    /// Of the stages: moments, and the rates of the second and third.
    work: [Moments; 3],
}

impl March {
    /// Before the first step.
    pub fn new(course: &Course) -> Self {
        let slow = course.sources.biases.len();
        let fast = Fast::new(&course.sources, slow, course.sources.lags.len());
        let cross = vec![ErrorState::default(); slow];
        let behind = vec![ErrorState::default(); course.sources.lags.len()];
        let rest = Moments { cross, behind, ..Moments::default() };
        let covariance = course.initial_covariance;
        let start = Moments { mean: course.initial, covariance, ..rest.clone() };
        let origin = course.instant(0.0);
        let mut start_rate = rest.clone();
        start.rate(&origin, course, &fast, &mut start_rate);
        Self {
            start_s: 0.0,
            step_s: 0.0,
            nodes: [origin; NODES],
            end: start.clone(),
            end_rate: start_rate.clone(),
            start,
            start_rate,
            slow,
            fast,
            work: [rest.clone(), rest.clone(), rest],
        }
    }

    /// The end of the current step, s.
    pub fn end_s(&self) -> f64 {
        self.start_s + self.step_s
    }

    /// The next step.
    pub fn step(&mut self, course: &Course) {
        self.start_s = self.end_s();
        std::mem::swap(&mut self.start, &mut self.end);
        std::mem::swap(&mut self.start_rate, &mut self.end_rate);
        let h = self.length(course);
        self.step_s = h;
        let [.., origin] = self.nodes;
        let later = |third: f64| course.instant(self.start_s + h * third / 3.0);
        self.nodes = [origin, later(1.0), later(2.0), later(3.0)];

        if self.outgrow(course, h) {
            self.start.rate(&origin, course, &self.fast, &mut self.start_rate);
        }

        let [_, at_third, at_two_thirds, at_end] = &self.nodes;
        let (y0, k1) = (&self.start, &self.start_rate);
        let [y, k2, k3] = &mut self.work;
        let rate = |y: &Moments, at: &Instant, k: &mut Moments| y.rate(at, course, &self.fast, k);
        // k₂ = f(y₀ + h k₁/3)
        y.copy(y0);
        y.advance(k1, h / 3.0);
        rate(y, at_third, k2);
        // k₃ = f(y₀ + h(k₂ − k₁/3))
        y.copy(y0);
        y.advance(k1, -h / 3.0);
        y.advance(k2, h);
        rate(y, at_two_thirds, k3);
        // k₄ = f(y₀ + h(k₁ − k₂ + k₃))
        let k4 = &mut self.end_rate;
        y.copy(y0);
        y.advance(k1, h);
        y.advance(k2, -h);
        y.advance(k3, h);
        rate(y, at_end, k4);
        // y₁ = y₀ + h(k₁ + 3k₂ + 3k₃ + k₄)/8
        self.end.copy(y0);
        for (k, weight) in [(k1, 1.0), (k2, 3.0), (k3, 3.0), (k4, 1.0)] {
            self.end.advance(k, h * weight / 8.0);
        }
        self.end.rate(at_end, course, &self.fast, &mut self.end_rate);
    }

    /// Of the step that begins at its start.
    fn length(&self, course: &Course) -> f64 {
        let sources = &course.sources;
        let h = (STEP_OVER_TIME * self.start_s)
            .max(FIRST_STEP * sources.sample_interval_s)
            .min(course.longest_step_s);
        // Behind a bandwidth another law begins with the second sample.
        let left_s = sources.sample_interval_s - self.start_s;
        let is_within = sources.are_filtered() && left_s > 1e-9 * sources.sample_interval_s;
        if is_within { h.min(left_s) } else { h }
    }

    /// Biases and lags that a step of length h has outgrown follow at once from now on; whether there are any.
    fn outgrow(&mut self, course: &Course, h: f64) -> bool {
        let sources = &course.sources;
        let lagging = sources.lags[..self.start.behind.len()].partition_point(|l| l.lag_s >= h);
        let slow = sources.biases[..self.slow].partition_point(|b| b.correlation_s >= h);
        if slow == self.slow && lagging == self.start.behind.len() {
            return false;
        }
        self.slow = slow;
        self.fast = Fast::new(sources, slow, lagging);
        self.start.cross.truncate(slow);
        self.start.behind.truncate(lagging);
        true
    }

    /// The moments at the end of the current step.
    pub fn end(&self) -> &Moments {
        &self.end
    }

    /// Mean and covariance of the error within the step, by Hermite's cubic.
    pub fn error_at(&self, time_s: f64) -> (ErrorState<f64>, Covariance) {
        let h = self.step_s;
        let s = if h > 0.0 { (time_s - self.start_s) / h } else { 0.0 };
        // y = (1−s)²(1+2s) y₀ + s(1−s)² h y₀′ + s²(3−2s) y₁ − s²(1−s) h y₁′
        let r = 1.0 - s;
        let (a, b) = (r * r * (1.0 + 2.0 * s), s * s * (3.0 - 2.0 * s));
        let (c, d) = (s * r * r * h, -(s * s * r * h));
        let (y0, k0, y1, k1) = (&self.start, &self.start_rate, &self.end, &self.end_rate);
        let mean = y0.mean * a + k0.mean * c + y1.mean * b + k1.mean * d;
        let entry = |i: usize, j: usize| {
            let of = |moments: &Moments| moments.covariance[i][j];
            of(y0) * a + of(k0) * c + of(y1) * b + of(k1) * d
        };
        (mean, std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j))))
    }
}
