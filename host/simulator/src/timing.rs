//! The time of each stage of a run alone: nanoseconds per sample, over a bounded prefix in memory.

use crate::flight::StageTimes;
use crate::navigator::Navigate;
use crate::quartile::quartile;
use crate::scene::Scene;
use crate::source::{Source, emulate};
use schuler::sample::Increment;
use std::hint::black_box;
use std::time::Instant;

/// Samples that a stage is timed over, at most, and how often: the median counts.
const SAMPLES: u64 = 2000;
const PASSES: usize = 7;

/// Every stage of a run.
pub fn stages(scene: &Scene, source: &Source, navigator: &dyn Navigate) -> StageTimes {
    let samples = perfect(source, scene.samples().min(SAMPLES));
    StageTimes {
        trajectory_ns: trajectory(source, samples.len() as u64),
        emulate_ns: emulator(source, &samples),
        navigate_ns: navigation(navigator, &samples),
    }
}

/// The first perfect increments.
pub fn perfect(source: &Source, samples: u64) -> Vec<Increment<f64>> {
    source.perfect_samples(1..samples + 1)
}

/// Truth and perfect increments.
pub fn trajectory(source: &Source, samples: u64) -> f64 {
    per_sample(samples, &mut || {
        black_box(source.perfect_samples(1..samples + 1));
    })
}

/// The emulator; nothing where there is none.
pub fn emulator(source: &Source, samples: &[Increment<f64>]) -> f64 {
    let Some(emulator) = &source.emulator else { return 0.0 };
    per_sample(samples.len() as u64, &mut || {
        let mut state = emulator.start(0, 0);
        for sample in samples {
            black_box(emulate(emulator, &mut state, sample));
        }
    })
}

/// Navigation at block ends, no row read.
pub fn navigation(navigator: &dyn Navigate, samples: &[Increment<f64>]) -> f64 {
    per_sample(samples.len() as u64, &mut navigator.fly_unread(&[], samples))
}

/// Nanoseconds per sample of a pass over so many.
pub fn per_sample(samples: u64, pass: &mut dyn FnMut()) -> f64 {
    let times: Vec<_> = (0..PASSES)
        .map(|_| {
            let start = Instant::now();
            pass();
            start.elapsed().as_secs_f64()
        })
        .collect();
    1e9 * quartile(&times, 2) / samples.max(1) as f64
}
