//! A navigator that goes on where an alignment ends.

use super::outcome::{self, Outcome};
use super::setup::Setup;
use crate::navigator::begun::Begun;
use crate::navigator::{self, Navigate, Unavailable};
use crate::plan::Plan;
use crate::scene::{Alignment, Scene};
use crate::simulate::start;
use crate::source::Source;
use schuler::math::compensated::Pair;
use schuler::sample::Increment;
use schuler::solution::Solution;

/// How a run of a scene begins.
pub struct Beginning {
    /// The navigator.
    pub navigator: Box<dyn Navigate>,
    /// Where it begins.
    pub initial: Solution<f64>,
    /// Samples before that.
    pub before: u64,
    /// What the alignment found, if there was one.
    pub outcome: Option<Outcome>,
}

/// Begins a run: from what the scene says that is known, or where its alignment ends.
pub fn begin(
    scene: &Scene,
    source: &Source,
    plan: &Plan,
    run: u64,
) -> Result<Beginning, Unavailable> {
    let interval = Pair::new(scene.rate_hz).reciprocal();
    let starts = |initial: &Solution<f64>| {
        navigator::start(&scene.navigator, plan.window, plan.order, interval, initial)
    };
    let Some(alignment) = scene.alignment else {
        let initial = start::of_run(&source.initial(0), scene, run);
        return Ok(Beginning { navigator: starts(&initial)?, initial, before: 0, outcome: None });
    };
    let outcome = align(scene, source, alignment, run)?;
    let found = &outcome.aligned;
    let [[gyro, _], [force, _]] = [found.gyro_bias, found.accelerometer_bias];
    let bias = Increment { angle_b: gyro * interval.hi, velocity_b: force * interval.hi };
    let navigator = Begun {
        navigator: starts(&outcome.solution)?,
        before: outcome.samples,
        bias,
        interval_s: interval.hi,
    };
    Ok(Beginning {
        navigator: Box::new(navigator),
        initial: outcome.solution,
        before: outcome.samples,
        outcome: Some(outcome),
    })
}

fn align(
    scene: &Scene,
    source: &Source,
    alignment: Alignment,
    run: u64,
) -> Result<Outcome, Unavailable> {
    let setup = Setup::new(scene, source, alignment)
        .map_err(|error| Unavailable::NoAlignment(error.complaint))?;
    outcome::of_run(&setup, source, run, None).map_err(|(sample, why)| Unavailable::Alignment {
        run,
        sample,
        why,
    })
}
