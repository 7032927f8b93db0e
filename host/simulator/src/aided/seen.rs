//! What is seen of a filter: its verdicts, its new starts, and its steps for a smoother.

use super::report::{Judgement, Report};
use super::smoother::Steps;
use schuler::aiding::aided::measured::Sensor;
use schuler::aiding::aided::state::AidedState;
use schuler::aiding::aided::verdict::{Step, Verdict, Witness};
use schuler::aiding::covariance::ud::Ud;
use schuler::math::real::Scalar;
use schuler::strapdown::mechanization::Mechanization;

/// What is seen of the filter.
pub struct Seen {
    /// Samples per second.
    rate_hz: f64,
    /// Every measurement.
    judged: Vec<Judgement>,
    /// When the filter started again, s.
    restarts: Vec<f64>,
    /// For a smoother.
    pub steps: Option<Steps>,
}

impl Seen {
    /// Nothing yet, beside samples of a rate in hertz; with steps for a smoother, if there is one.
    pub fn new(rate_hz: f64, steps: Option<Steps>) -> Self {
        Self { rate_hz, judged: Vec::new(), restarts: Vec::new(), steps }
    }

    /// Every measurement, in the order in which it was judged.
    pub fn judged(&self) -> &[Judgement] {
        &self.judged
    }

    /// What became of the measurements.
    pub fn report<
        M: Mechanization,
        const N: usize,
        const P: usize,
        const E: usize,
        const L: usize,
        const Q: usize,
    >(
        &self,
        state: &AidedState<M, N, P, E, L, Q>,
    ) -> Report {
        let lockouts = Sensor::ALL.map(|sensor| state.tally(sensor).lockouts());
        Report::new(&self.judged, &self.restarts, lockouts, *state.transport())
    }
}

impl<R: Scalar, const N: usize, const P: usize, const E: usize> Witness<R, N, P, E> for Seen {
    fn judged(&mut self, verdict: &Verdict<R>) {
        let &Verdict { at, kind, age_s, nis, limit, accepted, locked_out } = verdict;
        let time_s = (at.samples as f64 + at.part.widen()) / self.rate_hz;
        let [age_s, nis, limit] = [age_s, nis, limit].map(Scalar::widen);
        self.judged.push(Judgement { time_s, kind, age_s, nis, limit, accepted, locked_out });
    }

    fn stepped(&mut self, step: &Step<'_, R, N, P, E>) {
        if let Some(steps) = &mut self.steps {
            steps.add(step);
        }
    }

    fn corrected(&mut self, _: u64, errors: &[R; N], _: &Ud<R, N, P>) {
        if let Some(steps) = &mut self.steps {
            steps.correct(errors);
        }
    }

    fn restarted(&mut self, samples: u64) {
        if let Some(steps) = &mut self.steps {
            steps.restart();
        }
        self.restarts.push(samples as f64 / self.rate_hz);
    }
}
