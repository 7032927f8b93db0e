//! What a run does and what it can leave out, decided once; and what each part costs.

use crate::flight::{Skipped, StageTimes};
use crate::navigator::Navigate;
use crate::scene::{Algorithm, Precision, Scene, WindowShape};
use crate::source::{Source, SourceError};
use schuler::imu::Quadrature;
use schuler::sample::Increment;
use schuler::strapdown::plan::{self, Shape};
use schuler::trajectory::Trajectory as _;
use std::hint::black_box;
use std::time::Instant;

/// Samples that a stage is timed over, at most, and how often.
const TIMED_SAMPLES: u64 = 2000;
const PASSES: usize = 7;

/// What a run does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plan {
    /// The taylor algorithm's window.
    pub window: WindowShape,
    /// The order of its series, at most.
    pub order: usize,
    /// Whether nothing may be skipped.
    force_all: bool,
}

impl From<Shape> for WindowShape {
    fn from((history, block, lookahead): Shape) -> Self {
        Self { history, block, lookahead }
    }
}

impl Plan {
    /// Of a scene; `force_all` skips nothing.
    pub fn new(scene: &Scene, source: &Source, force_all: bool) -> Self {
        let planned = || {
            if force_all {
                return plan::UNKNOWN.into();
            }
            let bandwidth = source.course.bound().bandwidth;
            let single = scene.navigator.precision == Precision::F32;
            plan::window(bandwidth, 1.0 / scene.rate_hz, single).into()
        };
        let window = scene.navigator.window.unwrap_or_else(planned);
        let order = if force_all {
            plan::HIGHEST_ORDER
        } else {
            let angular_rate = source.course.bound().angular_rate;
            plan::order(angular_rate, window.block as f64 / scene.rate_hz)
        };
        Self { window, order, force_all }
    }

    /// The window flown, if the algorithm has one.
    pub fn flown_window(&self, scene: &Scene) -> Option<WindowShape> {
        (scene.navigator.algorithm == Algorithm::Taylor).then_some(self.window)
    }

    /// What is skipped, each with what that saves.
    pub fn skipped(&self, scene: &Scene, source: &Source, no_theory: bool) -> Vec<Skipped> {
        let mut skipped = Vec::new();
        if self.force_all {
            return skipped;
        }
        let mut skip = |what: &str, why: &str, saved: String| {
            let (what, why) = (what.to_owned(), why.to_owned());
            skipped.push(Skipped { what, why, saved });
        };
        let forced = Source::new(scene, true);
        let finest = Quadrature::FINEST.evaluations();
        let used = source.quadrature.evaluations();
        let saved = |planned: f64, forced: &Result<Source, SourceError>, emulated: bool| {
            let all = forced.as_ref().map_or(planned, |source| source_time(source, emulated));
            format!("{:.0} ns per sample", (all - planned).max(0.0))
        };
        if source.is_constant() {
            skip(
                "evaluation of the motion",
                "every channel is constant, so one increment serves for all samples",
                saved(source_time(source, false), &forced, false),
            );
        } else if used < finest {
            skip(
                &format!("{} of {finest} evaluations of the motion per sample", finest - used),
                &format!("{used} reach the rounding floor for a motion this slow"),
                saved(source_time(source, false), &forced, false),
            );
        }
        if source.emulator.is_none() {
            let emulation = source_time(source, true) - source_time(source, false);
            skip(
                "the sensor emulator",
                "the scene's sensors are perfect",
                saved(source_time(source, false) + emulation.max(0.0), &forced, true),
            );
        }
        let window = self.window;
        let widest = WindowShape::from(plan::UNKNOWN);
        let is_planned = scene.navigator.window.is_none() && self.flown_window(scene).is_some();
        if is_planned && window != widest {
            let WindowShape { history, block, lookahead } = window;
            skip(
                "wider windows",
                &format!("{history},{block},{lookahead} reaches the rounding floor here"),
                format!("{} samples of history and look-ahead", widest.history + widest.lookahead),
            );
        }
        if no_theory {
            skip("theory", "the scene has no errors, so no drift is expected", "all of it".into());
        }
        skipped
    }

    /// What each stage costs alone.
    pub fn time(&self, scene: &Scene, source: &Source, navigator: &dyn Navigate) -> StageTimes {
        let samples = increments(source, timed(scene));
        let mut fly = navigator.fly_unread(&samples);
        StageTimes {
            trajectory_ns: source_time(source, false),
            emulate_ns: emulator_time(source, &samples),
            navigate_ns: per_sample(samples.len(), &mut fly),
        }
    }
}

fn timed(scene: &Scene) -> u64 {
    scene.samples().min(TIMED_SAMPLES)
}

/// The first perfect increments.
fn increments(source: &Source, samples: u64) -> Vec<Increment<f64>> {
    (1..=samples).map(|n| source.perfect(source.time_s(n - 1), source.time_s(n))).collect()
}

/// Nanoseconds per sample: the median of some passes.
fn per_sample(samples: usize, pass: &mut dyn FnMut()) -> f64 {
    let mut times: Vec<_> = (0..PASSES)
        .map(|_| {
            let start = Instant::now();
            pass();
            start.elapsed().as_secs_f64()
        })
        .collect();
    times.sort_by(f64::total_cmp);
    1e9 * times[PASSES / 2] / samples.max(1) as f64
}

/// Truth and perfect increments, with or without the emulator.
fn source_time(source: &Source, emulated: bool) -> f64 {
    const SAMPLES: u64 = 500;
    if emulated {
        return emulator_time(source, &increments(source, SAMPLES)) + source_time(source, false);
    }
    per_sample(SAMPLES as usize, &mut || {
        for n in 1..=SAMPLES {
            black_box(source.perfect(source.time_s(n - 1), source.time_s(n)));
        }
    })
}

/// The emulator alone.
fn emulator_time(source: &Source, samples: &[Increment<f64>]) -> f64 {
    let Some(emulator) = &source.emulator else { return 0.0 };
    per_sample(samples.len(), &mut || {
        let mut state = emulator.start(0, 0);
        for sample in samples {
            black_box(emulator.emulate(&mut state, sample));
        }
    })
}
