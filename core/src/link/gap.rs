//! Missing samples: they end the run, or are filled from their neighbours.
//!
//! ```
//! use schuler::link::gap::{Bridge, Missing, Policy};
//! use schuler::math::vector::Vector;
//! use schuler::sample::Increment;
//!
//! let sample = |x: f64| Increment { angle_b: Vector::new(x, 0.0, 0.0), velocity_b: Vector::ZERO };
//! let mut bridge = Bridge::new(Policy::Bridge);
//! let mut passed = Vec::new();
//! for came in [Some(sample(1.0)), None, Some(sample(3.0))] {
//!     bridge.take(came, |increment| -> Result<(), Missing> {
//!         passed.push(increment.angle_b.x);
//!         Ok(())
//!     })?;
//! }
//! assert_eq!(passed, [1.0, 2.0, 3.0]);
//! # Ok::<(), Missing>(())
//! ```

use super::counters::count;
use crate::math::real::Real;
use crate::record::Record;
use crate::sample::Increment;

/// The largest number of consecutive samples that are bridged: the length of the record of received samples.
pub const MOST_BRIDGED: u32 = 31;

/// The policy for missing samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Policy {
    /// It is refused.
    Refuse,
    /// It is filled from its neighbours.
    Bridge,
}

/// A sample is missing, and gaps are not bridged, or there is nothing to bridge from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Missing;

impl core::fmt::Display for Missing {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("a sample is missing, and the gap cannot be bridged")
    }
}

impl core::error::Error for Missing {}

/// Fills gaps in a stream, or refuses them.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bridge<R> {
    policy: Policy,
    last: Option<Increment<R>>,
    /// Samples missing since the last.
    missing: u32,
    lost: u32,
}

impl<R: Real> Bridge<R> {
    /// At the start of a stream.
    pub fn new(policy: Policy) -> Self {
        Self { policy, last: None, missing: 0, lost: 0 }
    }

    /// Samples that were missing so far.
    pub fn lost(&self) -> u32 {
        self.lost
    }

    /// Whether it is plausible after this number of samples, of which at most `most` are missing in a row.
    pub(super) fn is_plausible(&self, samples: u32, most: u32) -> bool {
        let largest = R::of(1e6);
        let finite = |last: Increment<R>| {
            last.angle_b.is_within(largest) & last.velocity_b.is_within(largest)
        };
        self.missing <= most && self.lost <= samples && self.last.is_none_or(finite)
    }

    /// Takes the next sample, or its absence, and passes on what can be: a gap is filled along the
    /// straight line between its neighbours, once the second is there.
    ///
    /// # Errors
    ///
    /// [`Missing`] if gaps are not bridged or cannot be; otherwise the errors of the receiver of samples.
    pub fn take<E: From<Missing>>(
        &mut self,
        sample: Option<Increment<R>>,
        mut pass: impl FnMut(&Increment<R>) -> Result<(), E>,
    ) -> Result<(), E> {
        let Some(sample) = sample else {
            if self.policy == Policy::Refuse {
                return Err(Missing.into());
            }
            // One less than all, so that the sample after them has a number, too.
            let next = self.missing.checked_add(1).filter(|&missing| missing < u32::MAX);
            self.missing = next.ok_or(Missing)?;
            count(&mut self.lost);
            return Ok(());
        };
        let before = self.last.unwrap_or(sample);
        self.last = Some(sample);
        self.fill(before, sample, true, &mut pass)
    }

    /// Fills what is missing at the end of the stream: with the last sample there was; if there was none,
    /// that is refused.
    ///
    /// # Errors
    ///
    /// [`Missing`] if gaps are not bridged or cannot be; otherwise the errors of the receiver of samples.
    pub fn finish<E: From<Missing>>(
        &mut self,
        mut pass: impl FnMut(&Increment<R>) -> Result<(), E>,
    ) -> Result<(), E> {
        match self.last {
            Some(last) => self.fill(last, last, false, &mut pass),
            None if self.missing > 0 => Err(Missing.into()),
            None => Ok(()),
        }
    }

    /// Passes on what is missing, and the sample after it if it `came`.
    #[inline]
    fn fill<E>(
        &mut self,
        before: Increment<R>,
        after: Increment<R>,
        came: bool,
        pass: &mut impl FnMut(&Increment<R>) -> Result<(), E>,
    ) -> Result<(), E> {
        let missing = core::mem::take(&mut self.missing);
        let steps = R::count(missing + 1);
        for step in 1..=missing + u32::from(came) {
            let sample = if step > missing {
                after
            } else {
                let part = R::count(step) / steps;
                let angle = after.angle_b - before.angle_b;
                let velocity = after.velocity_b - before.velocity_b;
                Increment {
                    angle_b: before.angle_b + angle * part,
                    velocity_b: before.velocity_b + velocity * part,
                }
            };
            pass(&sample)?;
        }
        Ok(())
    }
}

impl<R: Real + Record> Record for Bridge<R> {
    fn record(&self, _: &'static str, read: &mut impl FnMut(&'static str, u64)) {
        u32::from(self.last.is_some()).record("has_last", read);
        self.last.unwrap_or(Increment::ZERO).record("last", read);
        self.missing.record("missing", read);
        self.lost.record("lost", read);
    }
    fn restore(&mut self, _: &'static str, write: &mut impl FnMut(&'static str, u64) -> u64) {
        let mut has_last = u32::from(self.last.is_some());
        has_last.restore("has_last", write);
        let mut last = self.last.unwrap_or(Increment::ZERO);
        last.restore("last", write);
        self.last = (has_last != 0).then_some(last);
        self.missing.restore("missing", write);
        self.lost.restore("lost", write);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::vector::Vector;

    fn ramp<R: Real>(k: u32) -> Increment<R> {
        let k = R::count(k);
        Increment {
            angle_b: Vector::new(k, R::TWO * k, -k),
            velocity_b: Vector::new(R::ONE - k, k, R::HALF),
        }
    }

    /// What a stream becomes, and how many samples it lacked.
    fn collect<R: Real, const N: usize>(
        policy: Policy,
        stream: &[Option<u32>],
    ) -> Result<([Increment<R>; N], u32), Missing> {
        let mut bridge = Bridge::new(policy);
        let mut passed = [Increment::ZERO; N];
        let mut slots = passed.iter_mut();
        let mut pass = |sample: &Increment<R>| {
            *slots.next().expect("as many as expected") = *sample;
            Ok::<(), Missing>(())
        };
        for sample in stream {
            bridge.take(sample.map(ramp), &mut pass)?;
        }
        bridge.finish(&mut pass)?;
        assert!(slots.next().is_none());
        Ok((passed, bridge.lost()))
    }

    #[test]
    fn a_straight_line_is_restored_and_counted() {
        let stream = [Some(0), None, None, None, Some(4), Some(5)];
        let expected = [0, 1, 2, 3, 4, 5];
        assert_eq!(collect(Policy::Bridge, &stream), Ok((expected.map(ramp::<f64>), 3)));
        assert_eq!(collect(Policy::Bridge, &stream), Ok((expected.map(ramp::<f32>), 3)));
    }

    #[test]
    fn the_ends_are_held() {
        let stream = [None, Some(1), None];
        assert_eq!(collect(Policy::Bridge, &stream), Ok(([ramp::<f64>(1); 3], 2)));
        assert_eq!(collect::<f64, 0>(Policy::Bridge, &[None]), Err(Missing));
    }

    #[test]
    fn a_gap_is_refused_where_it_shall_be() {
        assert_eq!(collect::<f64, 1>(Policy::Refuse, &[Some(0), None]), Err(Missing));
    }
}
