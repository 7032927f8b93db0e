//! A measurement taken: what was expected, the verdict, and the feedback.

use super::expected::Expected;
use super::instant::Instant;
use super::measured::{Kind, Measured, Sensor};
use super::navigator::Aided;
use super::path::{Path, judge};
use super::settings::Lockout;
use super::state::AidedState;
use super::step::Ahead;
use super::verdict::{Step, Verdict, Witness};
use crate::aiding::filter::{Fading, Filter};
use crate::aiding::gate::{Gate, Judged};
use crate::aiding::model::FIRST_EXTRA;
use crate::aiding::surroundings::{Pose, Surroundings};
use crate::aiding::transition::{Stretch, Transition};
use crate::math::real::{Real, Scalar};
use crate::math::vector::Vector;
use crate::strapdown::block::body::BodyMotion;
use crate::strapdown::correction::Correction;
use crate::strapdown::mechanization::Mechanization;

impl<R, M, const N: usize, const P: usize, const E: usize, const L: usize, const Q: usize>
    Aided<M, N, P, E, L, Q>
where
    R: Scalar + Real<Mask = bool>,
    M: Mechanization<Real = R, Body = BodyMotion<R>>,
{
    /// Judges a measurement, and feeds back what it says.
    #[inline(never)]
    pub(super) fn take(
        &self,
        state: &mut AidedState<M, N, P, E, L, Q>,
        measured: &Measured<R>,
        witness: &mut impl Witness<R, N, P, E>,
    ) {
        if state.search.goes_on() && matches!(measured.kind, Kind::Speed | Kind::NonHolonomic) {
            // Half a turn off, wheels do not slip sideways either.
            state.tally_mut(measured.sensor()).note_aside();
            state.taken.note(measured.at, measured.kind);
            return;
        }
        let ahead = (state.stretch.time_s > R::ZERO).then(|| self.ahead(state));
        let mut filter = ahead.as_ref().map_or(state.filter, |ahead| ahead.filter);
        let solution = self.solution(state);
        let locality = state.reference.locality(&solution.position);
        let late = self.places.latency.and_then(|state| filter.extras().get(state - FIRST_EXTRA));
        let late = late.copied().unwrap_or(R::ZERO) / self.interval.hi;
        let at = measured.at.shifted(-late);
        let entry = ahead.as_ref().map(|ahead| &ahead.entry);
        let Some((moment, path)) = self.past(state, entry, &at, &locality) else {
            state.transport.late = state.transport.late.saturating_add(1);
            return;
        };
        let extras = *filter.extras();
        let expected = Expected {
            moment: &moment,
            locality: &locality,
            places: self.places,
            extras: &extras,
            levers_b: [
                self.settings.lever_b,
                self.settings.odometer_lever_b,
                self.settings.barometer_lever_b,
            ],
        };
        let usual = self.limits.of(measured.kind);
        // While the heading is looked for, what the receiver says is believed; others are refused if they do not fit.
        let searching = state.search.goes_on();
        let believed = searching && measured.sensor() == Sensor::Gnss;
        let limit = if believed { R::of(1e30) } else { usual };
        let judged = consider(&mut filter, &path, &expected, measured, limit);
        let fits = judged.nis < usual;
        let gate = Gate { limit, patience: self.settings.patience };
        let locks_out =
            !judged.accepted && state.tally(measured.sensor()).is_out_of_patience(&gate);
        let doubted = (locks_out && !searching && self.settings.lockout == Lockout::Inflate)
            .then(|| most_likely(&filter, &path, &expected, measured));
        // What does not fit while the heading is looked for says that the heading is far off.
        let turned = believed
            && !fits
            && self.turn(state, &moment, &expected.innovations(measured), measured, witness);
        let accepted = turned
            || judged.accepted
                && self.feed(state, filter, ahead.as_ref(), &judged, &locality.here, witness);
        let degrees = measured.degrees();
        let tally = state.tally_mut(measured.sensor());
        let locked_out = if believed && !fits {
            tally.note_aside();
            false
        } else {
            tally.note(&gate, accepted, judged.nis, degrees)
        };
        state.taken.note(measured.at, measured.kind);
        let age_s = Instant::of_sample(state.integrated).since(&measured.at) * self.interval.hi;
        let Measured { at, kind, .. } = *measured;
        let nis = judged.nis;
        witness.judged(&Verdict { at, kind, age_s, nis, limit, accepted, locked_out });
        if let Some(doubted) = doubted {
            self.doubt(state, ahead.as_ref(), &doubted, witness);
        }
        if accepted && !turned {
            self.search(state, measured, fits, witness);
        }
    }

    /// Takes estimated errors off the state. False if the mechanization refuses that: nothing has changed then.
    fn feed(
        &self,
        state: &mut AidedState<M, N, P, E, L, Q>,
        filter: Filter<R, N, P, E>,
        ahead: Option<&Ahead<R, N, P, E>>,
        judged: &Judged<R, N>,
        here: &Surroundings<R>,
        witness: &mut impl Witness<R, N, P, E>,
    ) -> bool {
        let mut filter = filter;
        let pose = Pose::of(&self.solution(state));
        let correction = filter.feed(&self.model, &judged.errors, &pose, here);
        if self.mechanization.correct(&mut state.navigator, &correction).is_err() {
            return false;
        }
        if let Some(ahead) = ahead {
            self.commit(state, ahead, witness);
        }
        state.filter = filter;
        let corrected = self.solution(state);
        if let Some(newest) = state.ring.newest_mut() {
            newest.correct(&judged.errors, &corrected);
        }
        witness.corrected(state.integrated, &judged.errors, state.filter.covariance());
        if state.search.goes_on() {
            let Correction { position_ned, velocity_ned, attitude_ned } = correction;
            state.search.turned(attitude_ned.z);
            let level = Vector { z: R::ZERO, ..attitude_ned };
            let sizes = [position_ned, velocity_ned, level].map(Vector::norm);
            for (sum, size) in state.corrected.iter_mut().zip(sizes) {
                *sum = *sum + size;
            }
        }
        true
    }

    /// After a lockout: errors that would explain the last measurement become an uncertainty.
    fn doubt(
        &self,
        state: &mut AidedState<M, N, P, E, L, Q>,
        ahead: Option<&Ahead<R, N, P, E>>,
        along: &[R; N],
        witness: &mut impl Witness<R, N, P, E>,
    ) {
        if !along.iter().all(|x| x.is_within(R::of(1e6))) {
            return;
        }
        if let Some(ahead) = ahead {
            self.commit(state, ahead, witness);
        }
        let before = *state.filter.covariance();
        state.filter.covariance_mut().add_rank_one(R::ONE, *along);
        witness.stepped(&Step {
            samples: state.integrated,
            before: &before,
            transition: &Transition::new(&Stretch::NONE),
            fading: &Fading::NONE,
            after: state.filter.covariance(),
        });
    }
}

/// The errors that explain a measurement that was refused: of all that do, those that the filter finds most likely.
fn most_likely<R, const N: usize, const P: usize, const E: usize, const L: usize>(
    filter: &Filter<R, N, P, E>,
    path: &Path<'_, R, N, E, L>,
    expected: &Expected<'_, R>,
    measured: &Measured<R>,
) -> [R; N]
where
    R: Scalar + Real<Mask = bool>,
{
    // A measurement that is nearly without noise is explained whole: x = PHᵀ(HPHᵀ)⁻¹y.
    let surely = |sigma: Vector<R>| sigma * R::of(1e-3);
    let sure = Measured {
        position_sigma: surely(measured.position_sigma),
        velocity_sigma: surely(measured.velocity_sigma),
        ..*measured
    };
    let mut errors = consider(&mut { *filter }, path, expected, &sure, R::of(1e30)).errors;
    // Lever arm, latency and the like do not leave what they were.
    errors.iter_mut().skip(FIRST_EXTRA).for_each(|x| *x = R::ZERO);
    errors
}

/// Judges a measurement of any kind.
fn consider<R, const N: usize, const P: usize, const E: usize, const L: usize>(
    filter: &mut Filter<R, N, P, E>,
    path: &Path<'_, R, N, E, L>,
    expected: &Expected<'_, R>,
    measured: &Measured<R>,
    limit: R,
) -> Judged<R, N>
where
    R: Scalar + Real<Mask = bool>,
{
    match measured.kind {
        Kind::Position => judge(filter, path, expected.position(measured), limit),
        Kind::Velocity => judge(filter, path, expected.velocity(measured), limit),
        Kind::PositionVelocity => judge(filter, path, expected.position_velocity(measured), limit),
        Kind::Height => judge(filter, path, expected.height(measured), limit),
        Kind::Speed => judge(filter, path, expected.speed(measured), limit),
        Kind::ZeroVelocity => judge(filter, path, expected.zero_velocity(measured), limit),
        Kind::NonHolonomic => judge(filter, path, expected.non_holonomic(measured), limit),
    }
}
