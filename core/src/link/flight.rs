//! One mechanization in flight at the end of a link: bridging, navigation, digest.
//!
//! Target and host fly the same code, so that the same samples leave the same bits.
//!
//! ```
//! use schuler::link::flight::{LinkedFlight, Taken};
//! use schuler::link::gap::Policy;
//! use schuler::prelude::*;
//!
//! let level = Euler { roll: 0.0, pitch: 0.0, yaw: 0.0 };
//! let start = Solution::new(Geodetic::default(), Vector::ZERO, level);
//! let navigator = Navigator4::<f64>::from_rate_hz(100.0)?;
//! let mut flight = LinkedFlight::new(navigator, start, Policy::Bridge)?;
//! let push = Navigator4::<f64>::push;
//! assert_eq!(flight.take(1, Increment::ZERO, push), Ok(Taken::Flown));
//! assert_eq!(flight.take(1, Increment::ZERO, push), Ok(Taken::Again));
//! // The second sample never came.
//! assert_eq!(flight.take(3, Increment::ZERO, push), Ok(Taken::Flown));
//! assert_eq!((flight.taken(), flight.came(), flight.bridged()), (3, 0b101, 1));
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```

use super::count::Count;
use super::frame::Writer;
use super::gap::{Bridge, MOST_BRIDGED, Policy};
use super::message::Start;
use super::refusal::Refusal;
use crate::flight::catalogue::Entry;
use crate::flight::flight::Flight;
use crate::record::{Record, record};
use crate::sample::Increment;
use crate::solution::Solution;
use crate::strapdown::limits::Rejected;
use crate::strapdown::plausible::Damaged;

/// Samples that wait to be integrated, at most: no window has more.
pub(super) const MOST_WAITING: u64 = 64;

/// A flight with what the link needs beside it.
#[derive(Clone, Copy)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LinkedFlight<M: Entry> {
    flight: Flight<M>,
    bridge: Bridge<M::Real>,
    count: Count,
}

/// What became of a sample that was not refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Taken {
    /// It was flown.
    Flown,
    /// It had been taken before.
    Again,
}

impl<M: Entry> LinkedFlight<M> {
    /// As a host asks for it.
    pub fn start(start: &Start) -> Result<Self, Refusal> {
        let (interval_s, initial) = start.beginning()?;
        Self::new(M::configured(interval_s, start.order.into())?, initial, start.gap)
    }

    /// From an initial solution.
    pub fn new(mechanization: M, initial: Solution<M::Real>, gap: Policy) -> Result<Self, Refusal> {
        let flight = Flight::new(mechanization, &initial)?;
        Ok(Self { flight, bridge: Bridge::new(gap), count: Count::default() })
    }

    /// Takes the sample of a number, from 1; `push` is [`Mechanization::push`] or one that reads rows.
    /// Refused, it leaves everything as it was.
    ///
    /// [`Mechanization::push`]: crate::strapdown::mechanization::Mechanization::push
    #[inline]
    pub fn take(
        &mut self,
        number: u32,
        sample: Increment<M::Real>,
        push: impl FnMut(&M, &mut M::State, Increment<M::Real>) -> Result<(), Rejected>,
    ) -> Result<Taken, Refusal> {
        let Some(missing) = self.count.before(number)? else { return Ok(Taken::Again) };
        let before = (self.flight, self.bridge);
        let flown = self.fly(missing, Some(sample), push);
        if flown.is_err() {
            (self.flight, self.bridge) = before;
            return flown.map(|()| Taken::Flown);
        }
        self.count.take(number, missing);
        Ok(Taken::Flown)
    }

    /// Ends the stream after this number of samples: those that never came are filled with the last,
    /// and the samples that wait for look-ahead are flown.
    pub fn finish(
        &mut self,
        samples: u32,
        push: impl FnMut(&M, &mut M::State, Increment<M::Real>) -> Result<(), Rejected>,
        finish: impl FnOnce(&M, &mut M::State),
    ) -> Result<Taken, Refusal> {
        let Some(missing) = self.count.before_end(samples)? else { return Ok(Taken::Again) };
        let before = (self.flight, self.bridge);
        let flown = self.fly(missing, None, push);
        if flown.is_err() {
            (self.flight, self.bridge) = before;
            return flown.map(|()| Taken::Flown);
        }
        self.flight.finish_by(finish);
        self.count.end(samples, missing);
        Ok(Taken::Flown)
    }

    /// Flies a sample after those that are missing before it; none ends the stream.
    #[inline]
    fn fly(
        &mut self,
        missing: u32,
        sample: Option<Increment<M::Real>>,
        mut push: impl FnMut(&M, &mut M::State, Increment<M::Real>) -> Result<(), Rejected>,
    ) -> Result<(), Refusal> {
        let Self { flight, bridge, .. } = self;
        let mut pass =
            |sample: &Increment<M::Real>| flight.push_by(*sample, &mut push).map_err(Refusal::from);
        for _ in 0..missing {
            bridge.take(None, &mut pass)?;
        }
        match sample {
            Some(_) => bridge.take(sample, &mut pass),
            None => bridge.finish(&mut pass),
        }
    }

    /// Sets height (m) and vertical velocity (down, m/s).
    pub fn hold(&mut self, altitude: M::Real, down: M::Real) -> Result<(), Refusal> {
        Ok(self.flight.hold_vertical(altitude, down)?)
    }

    /// Whether what was written back over it can be a flight's state: before anything else is done with it.
    pub fn check(&self) -> Result<(), Damaged> {
        self.flight.check()?;
        let waiting = u64::from(self.taken()).checked_sub(self.integrated());
        let sound = waiting.is_some_and(|samples| samples <= MOST_WAITING)
            && self.bridge.is_plausible(self.taken(), MOST_BRIDGED)
            && self.count.is_plausible();
        if sound { Ok(()) } else { Err(Damaged) }
    }

    /// Number of the last sample taken, or filled in.
    pub fn taken(&self) -> u32 {
        self.count.taken()
    }

    /// Of the last 32 samples a bit each, the newest lowest: whether it came.
    pub fn came(&self) -> u32 {
        self.count.came()
    }

    /// Samples filled in.
    pub fn bridged(&self) -> u32 {
        self.bridge.lost()
    }

    /// Samples that lie behind the solution.
    pub fn integrated(&self) -> u64 {
        self.flight.integrated()
    }

    /// Digest of every state so far.
    pub fn digest(&self) -> u64 {
        self.flight.digest()
    }

    /// Navigation at the end of the last block.
    pub fn output(&self) -> M::Output {
        self.flight.output()
    }

    /// Writes where it stands, as [`Standing`](super::message::Standing).
    pub fn write(&self, to: &mut Writer) {
        self.count.write(self.integrated(), to);
        to.u64(self.digest());
        self.output().record("", &mut |_, bits| to.bits::<M::Real>(bits));
    }
}

/// The whole state, without the configuration and the policy.
impl<M: Entry> Record for LinkedFlight<M> {
    record!(flight; bridge, count);
}
