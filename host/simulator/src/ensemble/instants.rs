//! The instants at which runs are read: ends of blocks, the nearest to the times that are wanted.

use super::group::Ground;

/// How many samples are to be taken until the blocks nearest to so many equally spaced times are complete:
/// increasing, all of the flight's at last.
pub fn equal(ground: &Ground, instants: u64) -> Vec<u64> {
    let samples = ground.scene.samples() as f64;
    let wanted = (1..instants).map(|instant| samples * instant as f64 / instants as f64);
    stops(ground, wanted)
}

/// The same of chosen times, s, and of the end.
pub fn at(ground: &Ground, times_s: &[f64]) -> Vec<u64> {
    stops(ground, times_s.iter().map(|time_s| time_s * ground.scene.rate_hz))
}

fn stops(ground: &Ground, wanted: impl Iterator<Item = f64>) -> Vec<u64> {
    let samples = ground.scene.samples();
    let (block, ahead) = (ground.plan.window.block as u64, ground.plan.window.lookahead as u64);
    let nearest = |sample: f64| (sample / block as f64).round() as u64 * block + ahead;
    let mut stops: Vec<u64> =
        wanted.map(nearest).filter(|&stop| stop > ahead && stop < samples).collect();
    stops.push(samples);
    stops.sort_unstable();
    stops.dedup();
    stops
}
