//! The filter's step, and the measurements that are due.

use super::expected::Expected;
use super::instant::Instant;
use super::locality::{Locality, Reference};
use super::measured::{Kind, Measured};
use super::moment::Moment;
use super::navigator::Aided;
use super::path::{Path, judge};
use super::ring::{Entry, Ring};
use super::state::AidedState;
use super::verdict::{Step, Verdict, Witness};
use crate::aiding::alignment::search::Found;
use crate::aiding::filter::{Fading, Filter};
use crate::aiding::gate::Gate;
use crate::aiding::model::FIRST_EXTRA;
use crate::aiding::surroundings::Pose;
use crate::aiding::transition::{Stretch, Transition};
use crate::math::real::{Real, Scalar};
use crate::strapdown::block::body::BodyMotion;
use crate::strapdown::mechanization::Mechanization;

/// The filter at the end of the last block, before that is made the state's.
struct Ahead<R: Real, const N: usize, const P: usize, const E: usize> {
    filter: Filter<R, N, P, E>,
    entry: Entry<R, N, E>,
    transition: Transition<R>,
    fading: Fading<R, E>,
    reference: Reference<R>,
}

impl<R, M, const N: usize, const P: usize, const E: usize, const L: usize, const Q: usize>
    Aided<M, N, P, E, L, Q>
where
    R: Scalar + Real<Mask = bool>,
    M: Mechanization<Real = R, Body = BodyMotion<R>>,
{
    /// The filter carried on to the end of the last block.
    fn ahead(&self, state: &AidedState<M, N, P, E, L, Q>) -> Ahead<R, N, P, E> {
        let solution = self.solution(state);
        let mut reference = state.reference;
        let Locality { here, .. } = reference.follow(&solution.position);
        let gradient = here.gradient_b(&Pose::of(&solution));
        let transition = Transition::new(&state.stretch).with_gradient(&gradient);
        let mut filter = state.filter;
        let fading = filter.advance(&self.model, &transition);
        let [_, rate] = state.rates;
        let entry = Entry::new(state.integrated, &solution, rate, &state.stretch, &fading);
        Ahead { filter, entry, transition, fading, reference }
    }

    /// The filter at the end of the last block.
    pub(super) fn filter_now(&self, state: &AidedState<M, N, P, E, L, Q>) -> Filter<R, N, P, E> {
        if state.stretch.time_s > R::ZERO { self.ahead(state).filter } else { state.filter }
    }

    /// Makes it the state's.
    fn commit(
        &self,
        state: &mut AidedState<M, N, P, E, L, Q>,
        ahead: &Ahead<R, N, P, E>,
        witness: &mut impl Witness<R, N, P, E>,
    ) {
        witness.stepped(&Step {
            samples: state.integrated,
            before: state.filter.covariance(),
            transition: &ahead.transition,
            fading: &ahead.fading,
            after: ahead.filter.covariance(),
        });
        state.filter = ahead.filter;
        state.reference = ahead.reference;
        state.ring.push(ahead.entry);
        state.stretch = Stretch::NONE;
    }

    /// A step of the filter.
    #[inline(never)]
    pub(super) fn step(
        &self,
        state: &mut AidedState<M, N, P, E, L, Q>,
        witness: &mut impl Witness<R, N, P, E>,
    ) {
        let ahead = self.ahead(state);
        self.commit(state, &ahead, witness);
    }

    /// Takes the measurements that are due at the end of the last block; [`push`](Self::push) has done so. For one
    /// that came after its block.
    #[inline(never)]
    pub fn settle(
        &self,
        state: &mut AidedState<M, N, P, E, L, Q>,
        witness: &mut impl Witness<R, N, P, E>,
    ) {
        while state.queue.first().is_some_and(|first| self.due(&first.at) <= state.integrated) {
            if let Some(measured) = state.queue.take() {
                self.take(state, &measured, witness);
            }
        }
    }

    /// The vehicle at a time, and the steps since then; nothing if that is not remembered.
    fn past<'a>(
        &self,
        state: &'a AidedState<M, N, P, E, L, Q>,
        ahead: Option<&'a Entry<R, N, E>>,
        at: &Instant<R>,
        locality: &Locality<R>,
    ) -> Option<(Moment<R>, Path<'a, R, N, E, L>)> {
        let entries = || state.ring.forward().chain(ahead);
        let passed = |entry: &&Entry<R, N, E>| !at.is_before(&Instant::of_sample(entry.samples));
        let start = entries().take_while(passed).last()?;
        let after = at.since(&Instant::of_sample(start.samples));
        let path = |fraction| Path { ring: &state.ring, ahead, start: start.samples, fraction };
        if after <= R::ZERO {
            return Some((Moment::at_end(start), path(R::ZERO)));
        }
        let Some(end) = entries().find(|entry| entry.samples > start.samples) else {
            // Only a latency that is estimated below 0 leads beyond the present.
            let mut moment = Moment::at_end(start);
            moment.way_ned = moment.pose.velocity_ned * (after * self.interval.hi);
            return Some((moment, path(R::ZERO)));
        };
        let length = R::count(end.samples.saturating_sub(start.samples) as u32);
        let fraction = after / length;
        Some((Moment::within(start, end, fraction, locality), path(fraction)))
    }

    /// Judges a measurement, and feeds back what it says.
    #[inline(never)]
    pub(super) fn take(
        &self,
        state: &mut AidedState<M, N, P, E, L, Q>,
        measured: &Measured<R>,
        witness: &mut impl Witness<R, N, P, E>,
    ) {
        let ahead = (state.stretch.time_s > R::ZERO).then(|| self.ahead(state));
        let mut filter = ahead.as_ref().map_or(state.filter, |ahead| ahead.filter);
        let solution = self.solution(state);
        let locality = { state.reference }.follow(&solution.position);
        let late = self.places.latency.and_then(|state| filter.extras().get(state - FIRST_EXTRA));
        let late = late.copied().unwrap_or(R::ZERO) / self.interval.hi;
        let at = measured.at.shifted(-late);
        let entry = ahead.as_ref().map(|ahead| &ahead.entry);
        let Some((moment, path)) = self.past(state, entry, &at, &locality) else {
            state.transport.late = state.transport.late.saturating_add(1);
            return;
        };
        let limit =
            if state.search.goes_on() { R::of(1e30) } else { self.limits.of(measured.kind) };
        let (judged, along) = {
            let extras = *filter.extras();
            let expected = Expected {
                moment: &moment,
                locality: &locality,
                places: self.places,
                extras: &extras,
                levers_b: [self.settings.lever_b, self.settings.odometer_lever_b],
            };
            let filter = &mut filter;
            match measured.kind {
                Kind::Position => judge(filter, &path, expected.position(measured), limit),
                Kind::Velocity => judge(filter, &path, expected.velocity(measured), limit),
                Kind::PositionVelocity => {
                    judge(filter, &path, expected.position_velocity(measured), limit)
                }
                Kind::Height => judge(filter, &path, expected.height(measured), limit),
                Kind::Speed => judge(filter, &path, expected.speed(measured), limit),
                Kind::ZeroVelocity => judge(filter, &path, expected.zero_velocity(measured), limit),
                Kind::NonHolonomic => judge(filter, &path, expected.non_holonomic(measured), limit),
            }
        };
        let mut accepted = judged.accepted;
        if accepted {
            let pose = Pose::of(&solution);
            let correction = filter.feed(&self.model, &judged.errors, &pose, &locality.here);
            accepted = self.mechanization.correct(&mut state.navigator, &correction).is_ok();
            if accepted {
                if let Some(ahead) = &ahead {
                    self.commit(state, ahead, witness);
                }
                state.filter = filter;
                let corrected = self.solution(state);
                if let Some(newest) = state.ring.newest_mut() {
                    newest.correct(&judged.errors, &corrected);
                }
                witness.corrected(state.integrated, &judged.errors, state.filter.covariance());
                state.search.turned(correction.attitude_ned.z);
            }
        }
        let gate = Gate { limit, patience: self.settings.patience };
        let degrees = measured.degrees();
        let locked_out =
            state.tally_mut(measured.sensor()).note(&gate, accepted, judged.nis, degrees);
        state.taken.note(measured.at, measured.kind);
        let age_s = Instant::of_sample(state.integrated).since(&measured.at) * self.interval.hi;
        let Measured { at, kind, .. } = *measured;
        let nis = judged.nis;
        witness.judged(&Verdict { at, kind, age_s, nis, limit, accepted, locked_out });
        if locked_out {
            self.doubt(state, ahead.as_ref(), &along, witness);
        }
        if accepted {
            self.search(state, witness);
        }
    }

    /// After a lockout: the last innovation becomes an uncertainty.
    fn doubt(
        &self,
        state: &mut AidedState<M, N, P, E, L, Q>,
        ahead: Option<&Ahead<R, N, P, E>>,
        along: &[R; N],
        witness: &mut impl Witness<R, N, P, E>,
    ) {
        let sound = along.iter().all(|x| x.is_within(R::of(1e6)));
        if !sound || self.settings.lockout == super::settings::Lockout::Keep {
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

    /// Starts again where a heading that was not known has turned too far for a linear filter.
    fn search(
        &self,
        state: &mut AidedState<M, N, P, E, L, Q>,
        witness: &mut impl Witness<R, N, P, E>,
    ) {
        if !state.search.goes_on() {
            return;
        }
        let solution = self.solution(state);
        let pose = Pose::of(&solution);
        let [_, _, down] = pose.body_to_ned.rows;
        if let Found::Again(heading_rad) = state.search.judge(state.filter.sigma_about(down)) {
            state.filter = self.filter(&pose, heading_rad);
            state.search = crate::aiding::alignment::search::Search::new(heading_rad);
            let [_, rate] = state.rates;
            let entry =
                Entry::new(state.integrated, &solution, rate, &Stretch::NONE, &Fading::NONE);
            state.ring = Ring::new(entry);
            witness.restarted(state.integrated);
        }
    }
}
