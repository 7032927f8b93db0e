//! The time of navigation in lanes and alone: the same samples, alternately, on one core.

use schuler_simulator::ensemble::group::{Ground, Unit};
use schuler_simulator::navigator::Unavailable;
use schuler_simulator::quartile::quartile;
use schuler_simulator::timing;

/// Samples of a pass, at most: those of eight runs stay in the second cache.
const SAMPLES: u64 = 640;
/// Samples flown before, of a flight that has as many again: its first block costs more, and once only.
const BEFORE: u64 = 64;
/// How often abreast and alone take turns.
const TURNS: usize = 15;

/// Navigation under way, at block ends with no row read, ns per sample and run, in a unit and alone: the
/// median over the turns.
pub fn navigation_ns(ground: &Ground, unit: Unit) -> Result<[f64; 2], Unavailable> {
    let samples = ground.scene.samples();
    let before = BEFORE.min(samples / 2);
    let perfect = timing::perfect(ground.source, samples.min(before + SAMPLES));
    let (before, timed) = perfect.split_at(before as usize);
    let mut turns = [[0.0; TURNS]; 2];
    for turn in 0..TURNS {
        for (ns, unit) in turns.iter_mut().zip([unit, Unit::Alone]) {
            if let Some(mut group) = ground.start(unit, 0..unit.runs() as u64)? {
                ns[turn] = group.navigation_ns(before, timed);
            }
        }
    }
    Ok(turns.map(|ns| quartile(&ns, 2)))
}
