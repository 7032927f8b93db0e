//! What is seen of a filter: its verdicts, its new starts, and its steps for a smoother.

use super::report::Judgement;
use super::smoother::Steps;
use schuler::aiding::aided::verdict::{Step, Verdict, Witness};
use schuler::aiding::covariance::ud::Ud;
use schuler::math::real::Scalar;

/// What is seen of the filter.
pub struct Seen {
    /// Samples per second.
    pub rate_hz: f64,
    /// Every measurement.
    pub judged: Vec<Judgement>,
    /// When the filter started again, s.
    pub restarts: Vec<f64>,
    /// For a smoother.
    pub steps: Option<Steps>,
}

impl<R: Scalar, const N: usize, const P: usize, const E: usize> Witness<R, N, P, E> for Seen {
    fn judged(&mut self, verdict: &Verdict<R>) {
        let &Verdict { at, kind, nis, accepted, locked_out, .. } = verdict;
        let time_s = (at.samples as f64 + at.part.widen()) / self.rate_hz;
        self.judged.push(Judgement { time_s, kind, nis: nis.widen(), accepted, locked_out });
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
