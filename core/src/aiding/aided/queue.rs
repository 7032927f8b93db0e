//! Measurements that wait: sorted by time and sensor, so that their order does not depend on how they came.
//!
//! ```
//! use schuler::aiding::aided::instant::Instant;
//! use schuler::aiding::aided::measured::Measured;
//! use schuler::aiding::aided::queue::Queue;
//!
//! let mut queue = Queue::<f64, 4>::EMPTY;
//! for sample in [30, 10, 20] {
//!     queue.put(&Measured::zero_velocity(Instant::of_sample(sample), 0.1))?;
//! }
//! assert_eq!(queue.first().map(|first| first.at.samples), Some(10));
//! # Ok::<(), schuler::aiding::aided::fault::AidedFault>(())
//! ```

use super::fault::AidedFault;
use super::instant::Instant;
use super::measured::{Kind, Measured};
use crate::earth::Geodetic;
use crate::math::compensated::Pair;
use crate::math::real::{Real, Scalar};
use crate::math::vector::Vector;
use crate::record::{Record, record};

/// At most `Q` measurements, the earliest first.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Queue<R, const Q: usize> {
    waiting: [Measured<R>; Q],
    count: usize,
}

impl<R: Real, const Q: usize> Queue<R, Q> {
    const NONE: Measured<R> = {
        let zero = Pair::new(R::ZERO);
        Measured {
            at: Instant::of_sample(0),
            kind: Kind::Position,
            position: Geodetic { latitude: zero, longitude: zero, altitude: zero },
            velocity: Vector::ZERO,
            position_sigma: Vector::ZERO,
            velocity_sigma: Vector::ZERO,
        }
    };
    /// Nothing waits.
    pub const EMPTY: Self = Self { waiting: [Self::NONE; Q], count: 0 };

    /// Those that wait.
    pub fn waiting(&self) -> &[Measured<R>] {
        self.waiting.get(..self.count).unwrap_or(&[])
    }

    /// The earliest.
    pub fn first(&self) -> Option<&Measured<R>> {
        self.waiting().first()
    }

    /// Takes the earliest out.
    pub fn take(&mut self) -> Option<Measured<R>> {
        let first = *self.first()?;
        self.waiting.rotate_left(1);
        self.count = self.count.saturating_sub(1);
        if let Some(last) = self.waiting.get_mut(Q.saturating_sub(1)) {
            *last = Self::NONE;
        }
        Some(first)
    }
}

impl<R: Scalar, const Q: usize> Queue<R, Q> {
    /// Puts one in its place.
    ///
    /// # Errors
    ///
    /// [`AidedFault::Again`] if it waits already, [`AidedFault::Full`] if there is no room.
    pub fn put(&mut self, measured: &Measured<R>) -> Result<(), AidedFault> {
        let waiting = self.waiting();
        if waiting.iter().any(|other| other.repeats(&measured.at, measured.kind)) {
            return Err(AidedFault::Again);
        }
        if self.count >= Q {
            return Err(AidedFault::Full);
        }
        let place = waiting.iter().take_while(|other| other.is_before(measured)).count();
        let mut rest = *measured;
        self.count += 1;
        for slot in self.waiting.iter_mut().take(self.count).skip(place) {
            rest = core::mem::replace(slot, rest);
        }
        Ok(())
    }

    /// Whether a restored one is sound.
    pub(super) fn is_plausible(&self) -> bool {
        self.count <= Q && self.waiting().iter().all(|measured| measured.admit().is_ok())
    }
}

impl<R: Record, const Q: usize> Record for Queue<R, Q> {
    record!(waiting, count);
}
