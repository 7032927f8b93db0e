//! What a missing sample does: it ends the run, or it is filled from its neighbours.

use crate::scene::Gap;
use schuler::sample::Increment;

/// A sample is missing, and the scene does not bridge gaps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Missing;

/// Fills gaps in a stream, or refuses them.
#[derive(Clone, Copy, Debug)]
pub struct Bridge {
    policy: Gap,
    last: Option<Increment<f64>>,
    missing: u64,
    /// Samples that were missing so far.
    pub lost: u64,
}

impl Bridge {
    /// At the start of a stream.
    pub fn new(policy: Gap) -> Self {
        Self { policy, last: None, missing: 0, lost: 0 }
    }

    /// Takes the next sample, or its absence, and passes on what can be: a gap is filled along the
    /// straight line between its neighbours, once the second is there.
    pub fn take<E: From<Missing>>(
        &mut self,
        sample: Option<Increment<f64>>,
        mut pass: impl FnMut(&Increment<f64>) -> Result<(), E>,
    ) -> Result<(), E> {
        let Some(sample) = sample else {
            if self.policy == Gap::Error {
                return Err(Missing.into());
            }
            self.missing += 1;
            self.lost += 1;
            return Ok(());
        };
        let before = self.last.unwrap_or(sample);
        self.fill(before, sample, &mut pass)?;
        self.last = Some(sample);
        pass(&sample)
    }

    /// Fills what is missing at the end of the stream: with the last sample there was; if there was none,
    /// that is refused.
    pub fn finish<E: From<Missing>>(
        &mut self,
        mut pass: impl FnMut(&Increment<f64>) -> Result<(), E>,
    ) -> Result<(), E> {
        match self.last {
            Some(last) => self.fill(last, last, &mut pass),
            None if self.missing > 0 => Err(Missing.into()),
            None => Ok(()),
        }
    }

    fn fill<E>(
        &mut self,
        before: Increment<f64>,
        after: Increment<f64>,
        pass: &mut impl FnMut(&Increment<f64>) -> Result<(), E>,
    ) -> Result<(), E> {
        let steps = (self.missing + 1) as f64;
        for step in 1..=self.missing {
            let part = step as f64 / steps;
            let angle = after.angle_b - before.angle_b;
            let velocity = after.velocity_b - before.velocity_b;
            pass(&Increment {
                angle_b: before.angle_b + angle * part,
                velocity_b: before.velocity_b + velocity * part,
            })?;
        }
        self.missing = 0;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use schuler::math::vector::Vector;

    fn ramp(k: f64) -> Increment<f64> {
        Increment { angle_b: Vector::new(k, 2.0 * k, -k), velocity_b: Vector::new(1.0 - k, k, 0.5) }
    }

    fn collect(policy: Gap, stream: &[Option<f64>]) -> Result<(Vec<Increment<f64>>, u64), Missing> {
        let mut bridge = Bridge::new(policy);
        let mut passed = Vec::new();
        for sample in stream {
            bridge.take(sample.map(ramp), |s| {
                passed.push(*s);
                Ok::<(), Missing>(())
            })?;
        }
        bridge.finish(|s| {
            passed.push(*s);
            Ok::<(), Missing>(())
        })?;
        Ok((passed, bridge.lost))
    }

    #[test]
    fn a_straight_line_is_restored_and_counted() {
        let (passed, lost) =
            collect(Gap::Bridge, &[Some(0.0), None, None, None, Some(4.0), Some(5.0)]).unwrap();
        assert_eq!(lost, 3);
        assert_eq!(passed, [0.0, 1.0, 2.0, 3.0, 4.0, 5.0].map(ramp));
    }

    #[test]
    fn the_ends_are_held() {
        let (passed, lost) = collect(Gap::Bridge, &[None, Some(1.0), None]).unwrap();
        assert_eq!((passed, lost), (vec![ramp(1.0); 3], 2));
    }

    #[test]
    fn a_gap_is_refused_where_the_scene_says_so() {
        assert_eq!(collect(Gap::Error, &[Some(0.0), None]), Err(Missing));
    }
}
