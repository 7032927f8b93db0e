//! The held vertical, computed once for all runs.

use crate::source::Source;
use std::sync::OnceLock;

/// Height (m) and vertical velocity (down, m/s) of the truth at the ends of some samples.
pub struct Held<'a> {
    source: &'a Source,
    /// The number of the first of them.
    first: u64,
    verticals: Vec<OnceLock<[f64; 2]>>,
}

impl<'a> Held<'a> {
    /// At the ends of samples of these numbers, each worked out when a run asks first.
    pub fn new(source: &'a Source, samples: std::ops::RangeInclusive<u64>) -> Self {
        let (first, last) = samples.into_inner();
        let verticals = (first..=last).map(|_| OnceLock::new()).collect();
        Self { source, first, verticals }
    }

    /// At the end of a sample.
    pub fn at(&self, sample: u64) -> [f64; 2] {
        let work_out = || {
            let truth = self.source.truth(sample);
            [truth.position.altitude.hi, truth.velocity_ned.z.hi]
        };
        let place = sample.checked_sub(self.first).and_then(|place| usize::try_from(place).ok());
        match place.and_then(|place| self.verticals.get(place)) {
            Some(vertical) => *vertical.get_or_init(work_out),
            None => work_out(),
        }
    }
}
