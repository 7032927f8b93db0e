//! The state of an aided navigator: `Copy`, in the record list, and checked after it was restored.

use super::anchor::Anchor;
use super::instant::Instant;
use super::locality::Reference;
use super::measured::{Kind, Sensor};
use super::queue::Queue;
use super::ring::Ring;
use super::tally::{Tally, Transport};
use crate::aiding::alignment::search::Search;
use crate::aiding::filter::Filter;
use crate::aiding::transition::Stretch;
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::record::{Record, record};
use crate::strapdown::mechanization::Mechanization;

/// The measurements that were taken last, so that none is taken twice.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct Taken<R, const Q: usize> {
    last: [(Instant<R>, Kind); Q],
    count: usize,
}

impl<R: Real + PartialEq, const Q: usize> Taken<R, Q> {
    pub const NONE: Self = Self { last: [(Instant::of_sample(0), Kind::Position); Q], count: 0 };

    /// Notes one.
    pub fn note(&mut self, at: Instant<R>, kind: Kind) {
        self.last.rotate_right(1);
        if let Some(newest) = self.last.first_mut() {
            *newest = (at, kind);
        }
        self.count = (self.count + 1).min(Q);
    }

    /// Whether one was taken.
    pub fn has(&self, at: &Instant<R>, kind: Kind) -> bool {
        self.last.iter().take(self.count).any(|(time, known)| time == at && *known == kind)
    }
}

/// A running aided navigator.
#[derive(Clone, Copy)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AidedState<
    M: Mechanization,
    const N: usize,
    const P: usize,
    const E: usize,
    const L: usize,
    const Q: usize,
> {
    pub(super) navigator: M::State,
    pub(super) filter: Filter<M::Real, N, P, E>,
    /// The body's motion since the filter's last step.
    pub(super) stretch: Stretch<M::Real>,
    /// ω_ibᵇ: its mean over the last block, and at the block's end, rad/s.
    pub(super) rates: [Vector<M::Real>; 2],
    /// The last block's duration, s.
    pub(super) block_s: M::Real,
    /// Samples up to the end of the last block.
    pub(super) integrated: u64,
    /// Samples taken.
    pub(super) pushed: u64,
    pub(super) reference: Reference<M::Real>,
    pub(super) ring: Ring<M::Real, N, E, L>,
    pub(super) queue: Queue<M::Real, Q>,
    pub(super) taken: Taken<M::Real, Q>,
    pub(super) search: Search<M::Real>,
    /// Position, velocity and level corrected since the filter started, in any direction: m, m/s, rad.
    pub(super) corrected: [M::Real; 3],
    pub(super) anchor: Anchor<M::Real>,
    pub(super) tallies: [Tally<M::Real>; 5],
    pub(super) transport: Transport,
}

impl<
    M: Mechanization,
    const N: usize,
    const P: usize,
    const E: usize,
    const L: usize,
    const Q: usize,
> AidedState<M, N, P, E, L, Q>
{
    /// The navigator's state.
    pub fn navigator(&self) -> &M::State {
        &self.navigator
    }

    /// The filter at its last step.
    pub fn filter(&self) -> &Filter<M::Real, N, P, E> {
        &self.filter
    }

    /// Samples up to the end of the last block.
    pub fn integrated(&self) -> u64 {
        self.integrated
    }

    /// Counts of a sensor.
    pub fn tally(&self, sensor: Sensor) -> &Tally<M::Real> {
        let [gnss, barometer, odometer, zero_velocity, non_holonomic] = &self.tallies;
        match sensor {
            Sensor::Gnss => gnss,
            Sensor::Barometer => barometer,
            Sensor::Odometer => odometer,
            Sensor::ZeroVelocity => zero_velocity,
            Sensor::NonHolonomic => non_holonomic,
        }
    }

    /// The same, to write.
    pub(super) fn tally_mut(&mut self, sensor: Sensor) -> &mut Tally<M::Real> {
        let [gnss, barometer, odometer, zero_velocity, non_holonomic] = &mut self.tallies;
        match sensor {
            Sensor::Gnss => gnss,
            Sensor::Barometer => barometer,
            Sensor::Odometer => odometer,
            Sensor::ZeroVelocity => zero_velocity,
            Sensor::NonHolonomic => non_holonomic,
        }
    }

    /// What transport did to measurements.
    pub fn transport(&self) -> &Transport {
        &self.transport
    }

    /// Measurements that wait.
    pub fn queue(&self) -> &Queue<M::Real, Q> {
        &self.queue
    }

    /// Whether the heading is still looked for; meanwhile nothing is refused.
    pub fn looks_for_heading(&self) -> bool
    where
        M::Real: crate::math::real::Scalar,
    {
        self.search.goes_on()
    }
}

impl<R: Record, const Q: usize> Record for Taken<R, Q> {
    fn record(&self, _: &'static str, read: &mut impl FnMut(&'static str, u64)) {
        for (at, kind) in &self.last {
            at.record("taken", read);
            kind.record("kind", read);
        }
        self.count.record("count", read);
    }
    fn restore(&mut self, _: &'static str, write: &mut impl FnMut(&'static str, u64) -> u64) {
        for (at, kind) in &mut self.last {
            at.restore("taken", write);
            kind.restore("kind", write);
        }
        self.count.restore("count", write);
    }
}

impl<
    M: Mechanization<State: Record>,
    const N: usize,
    const P: usize,
    const E: usize,
    const L: usize,
    const Q: usize,
> Record for AidedState<M, N, P, E, L, Q>
where
    M::Real: Record,
{
    record!(
        navigator, filter, stretch, rates, block_s, integrated, pushed, reference, ring, queue,
        taken, search, corrected, anchor, tallies, transport
    );
}
