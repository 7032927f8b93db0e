//! The filter's step, and the measurements that are due.

use super::instant::Instant;
use super::locality::{Locality, Reference};
use super::moment::Moment;
use super::navigator::Aided;
use super::path::Path;
use super::ring::Entry;
use super::state::AidedState;
use super::verdict::{Step, Witness};
use crate::aiding::filter::{Fading, Filter};
use crate::aiding::surroundings::Pose;
use crate::aiding::transition::{Stretch, Transition};
use crate::math::real::{Real, Scalar};
use crate::strapdown::block::body::BodyMotion;
use crate::strapdown::mechanization::Mechanization;

/// The filter at the end of the last block, before that is made the state's.
pub(super) struct Ahead<R: Real, const N: usize, const P: usize, const E: usize> {
    pub filter: Filter<R, N, P, E>,
    pub entry: Entry<R, N, E>,
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
    pub(super) fn ahead(&self, state: &AidedState<M, N, P, E, L, Q>) -> Ahead<R, N, P, E> {
        let solution = self.solution(state);
        let reference = state.reference.followed(&solution.position);
        let Locality { here, .. } = reference.locality(&solution.position);
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
    pub(super) fn commit(
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
    pub(super) fn past<'a>(
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
}
