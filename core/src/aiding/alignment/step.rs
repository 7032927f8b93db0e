//! A step of an alignment: the filter carried on, what the base measures, and when to start again.

use super::base::Base;
use super::fine::{Fine, FineState, STEP_S};
use super::search::Found;
use super::verdict::AlignmentFault;
use crate::aiding::gate::Rows;
use crate::aiding::measurement;
use crate::aiding::model::FIRST_EXTRA;
use crate::aiding::surroundings::Pose;
use crate::aiding::transition::{Stretch, Transition};
use crate::math::compensated::Pair;
use crate::math::real::{Real, Scalar};
use crate::math::vector::Vector;
use crate::output::Output;
use crate::solution::Solution;
use crate::strapdown::block::body::BodyMotion;
use crate::strapdown::mechanization::Mechanization;

/// Level is found at this standard deviation, rad, or taken as it is after a time, s.
const LEVEL: f64 = 5e-4;
const LEVEL_S: f64 = 10.0;

impl<R, M, const N: usize, const P: usize, const E: usize> Fine<M, N, P, E>
where
    R: Scalar + Real<Mask = bool>,
    M: Mechanization<Real = R, Body = BodyMotion<R>>,
{
    /// Measures the velocity relative to the Earth in north, east and down, m/s.
    ///
    /// # Errors
    ///
    /// [`AlignmentFault::Diverged`] if the mechanization refuses a correction: start again.
    pub fn measure_velocity(
        &self,
        state: &mut FineState<M, N, P, E>,
        velocity_ned: Vector<R>,
        sigma_m_s: R,
    ) -> Result<bool, AlignmentFault> {
        if state.stretch.time_s > R::ZERO {
            self.advance(state);
        }
        let pose = Pose::of(&self.mechanization.output(&state.navigator).solution());
        let innovation = pose.to_body(pose.velocity_ned - velocity_ned);
        let earth = pose.to_body(self.here.earth_rate_ned);
        let rows = measurement::zero_velocity(innovation, earth, sigma_m_s);
        let accepted = self.take(state, &rows, &pose)?;
        self.search(state, &pose)?;
        Ok(accepted)
    }

    /// Carries the filter on to the end of the last block.
    pub(super) fn advance(&self, state: &mut FineState<M, N, P, E>) -> Solution<R> {
        let solution = self.mechanization.output(&state.navigator).solution();
        let stretch = core::mem::replace(&mut state.stretch, Stretch::NONE);
        let gradient = self.here.gradient_b(&Pose::of(&solution));
        let transition = Transition::new(&stretch).with_gradient(&gradient);
        state.filter.advance(&self.settings.model, &transition);
        solution
    }

    /// A step of the filter, with the measurement that the base gives.
    #[inline(never)]
    pub(super) fn step(&self, state: &mut FineState<M, N, P, E>) -> Result<(), AlignmentFault> {
        let time_s = state.stretch.time_s;
        let solution = self.advance(state);
        let Some(displacement_m) = self.settings.base.displacement_m() else { return Ok(()) };
        let pose = Pose::of(&solution);
        let mut way = self.way(&solution);
        let mut resonator = None;
        if let (Base::Swaying { .. }, [x, y, z, ..]) =
            (&self.settings.base, state.filter.extras().as_slice())
        {
            way = way - Vector::new(*x, *y, *z);
            resonator = Some(FIRST_EXTRA);
        }
        // The same information per second, whatever the step is.
        let sigma = displacement_m * (R::of(STEP_S) / time_s).sqrt();
        let rows = measurement::displacement(pose.to_body(way), resonator, sigma);
        self.take(state, &rows, &pose)?;
        self.search(state, &pose)
    }

    /// Begins to look for the heading, and starts again where a heading that was not known has turned too far for a
    /// linear filter.
    fn search(
        &self,
        state: &mut FineState<M, N, P, E>,
        pose: &Pose<R>,
    ) -> Result<(), AlignmentFault> {
        if state.unsure > R::ZERO {
            let [north, east, _] = pose.body_to_ned.rows.map(|axis| state.filter.sigma_about(axis));
            let seconds = R::count(state.integrated as u32) * self.interval.hi;
            let level = R::of(LEVEL);
            if (north < level && east < level) || seconds > R::of(LEVEL_S) {
                let heading = Vector::new(R::ZERO, R::ZERO, state.unsure);
                let now = Pose::of(&self.mechanization.output(&state.navigator).solution());
                state.filter.add_uncertainty(6, heading, &now);
                state.unsure = R::ZERO;
            }
            return Ok(());
        }
        if !state.search.goes_on() {
            return Ok(());
        }
        let sigma = state.filter.sigma_about(pose.body_to_ned.rows[2]);
        if let Found::Again(heading_rad) = state.search.judge(sigma) {
            let found = self.mechanization.output(&state.navigator).solution();
            // A vehicle that goes nowhere is where it was.
            let at_rest = Solution::new(self.position, Vector::ZERO, found.euler());
            let moves = matches!(self.settings.base, Base::Moving);
            let again = self.start_unsure(if moves { &found } else { &at_rest }, heading_rad)?;
            let before = state.before.saturating_add(state.integrated);
            *state = FineState { before, ..again };
        }
        Ok(())
    }

    /// The way from the place, m.
    pub(super) fn way(&self, solution: &Solution<R>) -> Vector<R> {
        let start = Solution { position: self.position.map(Pair::new), ..*solution };
        self.here.way(&start, solution, self.cosine)
    }

    /// Takes a vector of measurements, and feeds back what it says.
    pub(super) fn take(
        &self,
        state: &mut FineState<M, N, P, E>,
        rows: &Rows<R, N, 3>,
        pose: &Pose<R>,
    ) -> Result<bool, AlignmentFault> {
        let limit = if state.search.goes_on() { R::of(1e30) } else { self.gate.limit };
        let judged = state.filter.measure(rows, limit);
        if state.watch.note(&self.gate, judged.accepted, judged.nis) && state.moved == 0 {
            state.moved = state.before.saturating_add(state.integrated);
        }
        if !judged.accepted {
            return Ok(false);
        }
        let filter = &mut state.filter;
        let correction = filter.feed(&self.settings.model, &judged.errors, pose, &self.here);
        self.mechanization
            .correct(&mut state.navigator, &correction)
            .map_err(|_| AlignmentFault::Diverged)?;
        state.search.turned(correction.attitude_ned.z);
        Ok(true)
    }
}
