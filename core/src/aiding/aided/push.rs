//! Samples in: blocks chained to steps, and at their ends the measurements that are due.

use super::fault::AidedFault;
use super::instant::Instant;
use super::navigator::Aided;
use super::state::AidedState;
use super::verdict::Witness;
use crate::math::real::{Real, Scalar};
use crate::math::vector::Vector;
use crate::sample::Increment;
use crate::strapdown::block::body::BodyMotion;
use crate::strapdown::mechanization::Mechanization;

impl<R, M, const N: usize, const P: usize, const E: usize, const L: usize, const Q: usize>
    Aided<M, N, P, E, L, Q>
where
    R: Scalar + Real<Mask = bool>,
    M: Mechanization<Real = R, Body = BodyMotion<R>>,
{
    /// Takes a sample. At the end of a block, measurements that are due are taken too.
    ///
    /// # Errors
    ///
    /// [`AidedFault::Rejected`] if the mechanization refuses it; the state is then unchanged.
    pub fn push(
        &self,
        state: &mut AidedState<M, N, P, E, L, Q>,
        sample: Increment<R>,
    ) -> Result<(), AidedFault> {
        self.push_seen(state, sample, &mut ())
    }

    /// The same, seen by a witness.
    ///
    /// # Errors
    ///
    /// As of [`push`](Self::push).
    #[inline]
    pub fn push_seen(
        &self,
        state: &mut AidedState<M, N, P, E, L, Q>,
        sample: Increment<R>,
        witness: &mut impl Witness<R, N, P, E>,
    ) -> Result<(), AidedFault> {
        let interval_s = self.interval.hi;
        let sample = state.filter.without_biases(&sample, interval_s);
        let before = state.integrated;
        let AidedState { navigator, stretch, rates, block_s, integrated, ring, .. } = state;
        let see = |now: u64, body: &BodyMotion<R>, _: &M::Frame| {
            let samples = R::count(now.saturating_sub(*integrated) as u32);
            let time_s = samples * interval_s;
            stretch.add(body, time_s);
            follow(rates, *block_s, body, time_s);
            if *integrated == 0
                && let (Some(start), [mean, _]) = (ring.newest_mut(), *rates)
            {
                start.rate_ib_b = mean;
            }
            (*integrated, *block_s) = (now, time_s);
        };
        self.mechanization.push_blocks(navigator, sample, see).map_err(AidedFault::Rejected)?;
        state.pushed = state.pushed.saturating_add(1);
        if state.integrated == before {
            return Ok(());
        }
        // Half a sample early is on time.
        if state.stretch.time_s + interval_s * R::HALF > self.settings.step_s {
            self.step(state, witness);
        }
        self.settle(state, witness);
        Ok(())
    }

    /// Integrates the samples that wait for look-ahead, and takes every measurement up to there.
    pub fn finish(
        &self,
        state: &mut AidedState<M, N, P, E, L, Q>,
        witness: &mut impl Witness<R, N, P, E>,
    ) {
        let interval_s = self.interval.hi;
        let AidedState { navigator, stretch, rates, block_s, integrated, .. } = state;
        self.mechanization.finish_blocks(navigator, |now, body, _| {
            let samples = R::count(now.saturating_sub(*integrated) as u32);
            let time_s = samples * interval_s;
            stretch.add(body, time_s);
            follow(rates, *block_s, body, time_s);
            (*integrated, *block_s) = (now, time_s);
        });
        while state.queue.first().is_some_and(|first| has_passed(state.integrated, &first.at)) {
            if let Some(measured) = state.queue.take() {
                self.take(state, &measured, witness);
            }
        }
        if state.stretch.time_s > R::ZERO {
            self.step(state, witness);
        }
    }
}

/// Whether a time is not after the end of so many samples.
fn has_passed<R: Scalar>(integrated: u64, at: &Instant<R>) -> bool {
    !Instant::of_sample(integrated).is_before(at)
}

/// The mean rate over a block, and the rate at its end by a straight line through its own mean and the last one's.
fn follow<R: Scalar>(rates: &mut [Vector<R>; 2], last_s: R, body: &BodyMotion<R>, time_s: R) {
    let [last, _] = *rates;
    // sin ½θ·n = v:  θ = 2v(1 + |v|²/6 + …)
    let v = body.rotation.v;
    let mean = v * ((R::TWO + v.dot(v) * R::ratio(1, 3)) / time_s);
    let slope = if last_s > R::ZERO { time_s / (time_s + last_s) } else { R::ZERO };
    *rates = [mean, mean + (mean - last) * slope];
}
