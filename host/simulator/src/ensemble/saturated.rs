//! How often sensors were at their limit, whatever the runs were flown in.
//!
//! A group senses some samples beyond the one at which a run fails, and how many depends on the group. The runs of
//! such a group are sensed once more, each up to its own end.

use super::group::Ground;
use super::runs::{Failure, Group};
use std::ops::Range;

/// Samples in which a sensor was at its limit, over the runs of all groups; of a run that failed, up to the
/// sample that it did not take.
pub(super) fn in_all(
    ground: &Ground,
    groups: &[Box<dyn Group + '_>],
    ranges: &[Range<u64>],
    failed: &[Failure],
) -> u64 {
    let scene = ground.scene;
    if scene.gyro.saturation.is_none() && scene.accelerometer.saturation.is_none() {
        return 0;
    }
    let end = |run: u64| {
        let failure = failed.iter().find(|failure| failure.run == run);
        failure.map_or(scene.samples(), |failure| failure.sample)
    };
    let once_more = |run: u64| {
        let mut stream = ground.source.start(run);
        for sample in 1..=end(run) {
            stream.sense(&ground.source.perfect_sample(sample));
        }
        stream.saturated()
    };
    let has_failed = |runs: &Range<u64>| failed.iter().any(|failure| runs.contains(&failure.run));
    let of_groups = groups.iter().zip(ranges).map(|(group, runs)| match has_failed(runs) {
        true => runs.clone().map(once_more).sum(),
        false => group.saturated(),
    });
    of_groups.sum()
}
