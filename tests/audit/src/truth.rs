//! What all configurations share: the true motion, the perfect samples and those that sensors deliver.

use crate::recording::{Reader, Stage};
use crate::scene::{RUN, SEED, Scene};
use schuler::imu::instant;
use schuler::math::compensated::Pair;
use schuler::sample::Increment;
use schuler::solution::Solution;
use schuler::trajectory::Trajectory;

/// The core refused a scene, a start or a sample.
#[derive(Clone, Copy, Debug)]
pub struct Refused;

/// What a navigator is given.
pub struct Flown<'a> {
    /// The true state at time 0.
    pub initial: Solution<f64>,
    /// From sample to sample, s.
    pub interval_s: Pair<f64>,
    /// What the sensors deliver.
    pub samples: &'a [Increment<f64>],
}

/// Flies a scene into `samples`.
pub fn fly<'a>(
    scene: &Scene,
    samples: &'a mut [Increment<f64>],
    reader: &mut dyn Reader,
) -> Result<Flown<'a>, Refused> {
    let course = scene.course().ok_or(Refused)?;
    let quadrature = scene.quadrature(&course);
    let emulator = scene.emulator().map_err(|_| Refused)?;
    let mut state = emulator.start(SEED, RUN);
    let [mut trajectory, mut increments, mut noise] =
        ["trajectory", "increments", "noise"].map(Stage::new);
    let samples = samples.get_mut(..scene.samples() as usize).ok_or(Refused)?;
    for (sample, measured) in (1_u32..).zip(samples.iter_mut()) {
        let (number, rate_hz) = (u64::from(sample), f64::from(scene.rate_hz));
        let perfect = quadrature.sample(&course, number, rate_hz);
        *measured = emulator.emulate(&mut state, &perfect);
        let end_s = instant(sample.into(), rate_hz);
        trajectory.row(sample.into(), &course.at_instant(end_s), reader);
        increments.row(sample.into(), &perfect, reader);
        noise.row(sample.into(), measured, reader);
    }
    trajectory.end(reader);
    increments.end(reader);
    noise.end(reader);
    Ok(Flown { initial: course.at(0.0).initial(), interval_s: scene.interval_s(), samples })
}
