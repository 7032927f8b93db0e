//! The last steps of a filter: where the vehicle was at the end of each, how it moved there, and what was corrected.

use crate::aiding::filter::Fading;
use crate::aiding::transition::Stretch;
use crate::earth::Geodetic;
use crate::math::compensated::Pair;
use crate::math::quaternion::Quaternion;
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::record::{Record, record};
use crate::solution::Solution;

/// A step.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Entry<R, const N: usize, const E: usize> {
    /// Samples at its end.
    pub samples: u64,
    /// Position at its end, after the corrections there.
    pub position: Geodetic<Pair<R>>,
    /// Velocity, north, east, down, m/s.
    pub velocity_ned: Vector<R>,
    /// Attitude, body → north, east, down.
    pub attitude: Quaternion<R>,
    /// ω_ibᵇ at its end, rad/s.
    pub rate_ib_b: Vector<R>,
    /// The body's motion over it.
    pub stretch: Stretch<R>,
    /// What biases and further states faded by.
    pub fading: Fading<R, E>,
    /// The errors that were taken off at its end.
    pub errors: [R; N],
}

impl<R: Real, const N: usize, const E: usize> Entry<R, N, E> {
    /// Nothing.
    const NONE: Self = {
        let zero = Pair::new(R::ZERO);
        Self {
            samples: 0,
            position: Geodetic { latitude: zero, longitude: zero, altitude: zero },
            velocity_ned: Vector::ZERO,
            attitude: Quaternion::IDENTITY,
            rate_ib_b: Vector::ZERO,
            stretch: Stretch::NONE,
            fading: Fading::NONE,
            errors: [R::ZERO; N],
        }
    };

    /// A step that ends with a solution.
    pub fn new(
        samples: u64,
        solution: &Solution<R>,
        rate_ib_b: Vector<R>,
        stretch: &Stretch<R>,
        fading: &Fading<R, E>,
    ) -> Self {
        Self {
            samples,
            rate_ib_b,
            stretch: *stretch,
            fading: *fading,
            errors: [R::ZERO; N],
            ..Self::NONE
        }
        .at(solution)
    }

    /// With another solution at its end.
    fn at(self, solution: &Solution<R>) -> Self {
        Self {
            position: solution.position,
            velocity_ned: solution.velocity_ned.map(|c| c.hi),
            attitude: solution.attitude.map(|c| c.hi),
            ..self
        }
    }

    /// After errors were taken off: the solution is the corrected one.
    pub fn correct(&mut self, errors: &[R; N], solution: &Solution<R>) {
        for (sum, error) in self.errors.iter_mut().zip(errors) {
            *sum = *sum + *error;
        }
        *self = self.at(solution);
    }
}

/// The last `L` steps.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Ring<R, const N: usize, const E: usize, const L: usize> {
    entries: [Entry<R, N, E>; L],
    /// Where the next one goes.
    next: usize,
    count: usize,
}

impl<R: Real, const N: usize, const E: usize, const L: usize> Ring<R, N, E, L> {
    /// With the start as the only entry.
    pub fn new(start: Entry<R, N, E>) -> Self {
        let mut ring = Self { entries: [Entry::NONE; L], next: 0, count: 0 };
        ring.push(start);
        ring
    }

    /// Adds a step; the oldest gives way.
    pub fn push(&mut self, entry: Entry<R, N, E>) {
        if let Some(slot) = self.entries.get_mut(self.next) {
            *slot = entry;
        }
        self.next = if self.next + 1 < L { self.next + 1 } else { 0 };
        self.count = (self.count + 1).min(L);
    }

    /// From the oldest to the newest.
    pub fn forward(&self) -> impl Iterator<Item = &Entry<R, N, E>> {
        let (newer, older) = self.entries.split_at_checked(self.next).unwrap_or((&[], &[]));
        let older = if self.count < L { &[] } else { older };
        older.iter().chain(newer)
    }

    /// The newest.
    pub fn newest_mut(&mut self) -> Option<&mut Entry<R, N, E>> {
        let last = if self.next == 0 { L.saturating_sub(1) } else { self.next - 1 };
        self.entries.get_mut(last)
    }

    /// Samples at the end of the oldest.
    pub fn oldest(&self) -> u64 {
        self.forward().next().map_or(0, |entry| entry.samples)
    }

    /// Whether a restored one is sound.
    pub fn is_plausible(&self) -> bool {
        let most = R::of(1e7);
        self.next < L.max(1)
            && self.count <= L
            && self.forward().all(|entry| {
                let Geodetic { latitude, longitude, altitude } = entry.position;
                latitude.hi.is_within(most)
                    && longitude.hi.is_within(most)
                    && altitude.hi.is_within(most)
                    && entry.velocity_ned.is_within(most)
                    && entry.attitude.v.is_within(R::TWO)
                    && entry.rate_ib_b.is_within(most)
                    && entry.errors.iter().all(|x| x.is_within(most))
            })
    }
}

impl<R: Record, const N: usize, const E: usize> Record for Entry<R, N, E> {
    record!(samples, position, velocity_ned, attitude, rate_ib_b, stretch, fading, errors);
}

impl<R: Record, const N: usize, const E: usize, const L: usize> Record for Ring<R, N, E, L> {
    record!(entries, next, count);
}
