//! The plan of a run: what it computes and what it can skip. The saving is measured.

mod candidate;
mod choice;
mod growth;
mod mean;
mod middle;
mod passage;
mod path;
mod reference;
mod step;
mod trial;

use crate::course::Path;
use crate::flight::{Planned, Skipped};
use crate::navigator::{self, Navigate};
use crate::scene::{Algorithm, Axes, Precision, Scene, WindowShape};
use crate::source::Source;
use crate::theory::Theory;
use crate::timing;
use candidate::Candidate;
use passage::Passages;
use schuler::flight::catalogue::{Catalogue as _, Every};
use schuler::flight::plan;
use schuler::math::compensated::Pair;
use schuler::trajectory::Trajectory as _;
use trial::{Flight, Trial};

/// Samples that what is skipped is measured over, at most.
const SKIPPED_SAMPLES: u64 = 500;

/// What a run does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plan {
    /// The taylor algorithm's window.
    pub window: WindowShape,
    /// The order of its series, at most.
    pub order: usize,
    /// What the trial flights found; nothing was tried for an algorithm without windows.
    pub trial: Option<Planned>,
    /// Whether nothing may be skipped.
    force_all: bool,
}

/// Whether a window looks at fewer samples beside its block.
fn is_cheaper(window: WindowShape, other: WindowShape) -> bool {
    window.history + window.lookahead < other.history + other.lookahead
}

/// What an aided navigator flies: a filter corrects it at the end of each block, so it cannot look ahead.
pub const AIDED: WindowShape = WindowShape::new(0, 4, 0);

/// Twelve samples about a block of four.
const WIDEST: WindowShape = WindowShape::new(4, 4, 4);

/// What truncation may cost, in roundings of double precision. In single precision the sums keep some
/// eight bits more than one of its numbers, two-float products another four.
fn share_of_rounding(precision: Precision) -> f64 {
    let single = f64::from(f32::EPSILON) / f64::EPSILON;
    match precision {
        Precision::F64 => 1.0,
        Precision::F32 => single / 256.0,
        Precision::F32x2 => single / 4096.0,
    }
}

/// The windows to try, the cheapest first.
fn candidates(scene: &Scene, source: &Source) -> Vec<Candidate> {
    let precision = scene.navigator.precision;
    let is_perfect = scene.gyro == Default::default() && scene.accelerometer == Default::default();
    let is_still = source.course.bound().bandwidth == 0.0;
    let is_fit = |candidate: &Candidate| {
        let WindowShape { block, .. } = candidate.shape;
        // Long blocks round more at once in single precision, always the same way where nothing changes.
        let long = match precision {
            Precision::F64 => usize::MAX,
            _ if is_still => 4,
            _ => 12,
        };
        let is_rounded = block > long || block as f64 > scene.rate_hz && block > 4;
        let is_available = Every::has(&scene.navigator.configuration(candidate.shape));
        // One-sided windows amplify noise.
        let is_quiet = is_perfect || candidate.is_symmetric();
        // A flight shorter than a block would be nothing but its end.
        let is_whole = block as u64 <= scene.samples().max(4);
        is_whole && is_available && is_quiet && (precision == Precision::F64 || !is_rounded)
    };
    Candidate::all().filter(is_fit).collect()
}

impl Plan {
    /// Of a scene; `force_all` skips nothing.
    ///
    /// In a simulation the truth is at hand, so windows are tried on parts of it; sensor errors leave the
    /// choice to the motion.
    pub fn new(scene: &Scene, source: &Source, force_all: bool) -> Self {
        let navigator = &scene.navigator;
        if navigator.algorithm != Algorithm::Taylor {
            let (window, order) = (plan::UNKNOWN, plan::HIGHEST_ORDER);
            return Self { window, order, trial: None, force_all };
        }
        if scene.aiding.is_there() {
            return Self { window: AIDED, order: plan::HIGHEST_ORDER, trial: None, force_all };
        }
        // A run that skips nothing chooses by the same samples.
        let plain = if force_all { Source::new(scene, false).ok() } else { None };
        let source = plain.as_ref().unwrap_or(source);
        if let Some(path) = source.course.path()
            && source.course.bound().bandwidth > 0.0
        {
            return Self::of_path(scene, source, path, force_all);
        }
        let flight = Flight {
            motion: &source.course,
            interval_s: 1.0 / scene.rate_hz,
            samples: scene.samples(),
            earth_fixed: navigator.frame == Axes::EarthFixed,
        };
        let trial = Trial::new(&flight);
        let passages = Passages::new(scene, source);
        let most_m = trial.rounding_m() * share_of_rounding(navigator.precision);
        let asked = navigator.window.and_then(Candidate::find);
        let candidates = match asked {
            Some(asked) => vec![asked],
            None => candidates(scene, source),
        };
        let (chosen, tried) = trial.choose(&passages, &candidates, most_m);
        let mut window = navigator.window.unwrap_or_else(|| {
            // A motion that no window can be flown with is refused by the navigator itself.
            chosen.map_or(WindowShape::new(2, 2, 2), |chosen| chosen.shape)
        });
        let mut planned = chosen.map(|chosen| Planned {
            tried,
            predicted_m: chosen.predicted_m,
            most_m: trial.enough_m(most_m),
        });
        // With nothing skipped a wider window than is needed, if it is no worse.
        if let Some(cheap) = chosen
            && asked.is_none()
            && force_all
            && cheap.predicted_m <= trial.enough_m(most_m)
        {
            let wide: Vec<_> = candidates
                .into_iter()
                .filter(|c| c.shape == plan::UNKNOWN || c.shape == WIDEST)
                .collect();
            if let (Some(wide), _) = trial.choose(&passages, &wide, most_m)
                && wide.predicted_m <= trial.enough_m(most_m)
            {
                window = wide.shape;
                planned = planned.map(|of| Planned { predicted_m: wide.predicted_m, ..of });
            }
        }
        let order = match Candidate::find(window) {
            Some(candidate) if !force_all => trial.order(&passages, &candidate, most_m),
            _ => plan::HIGHEST_ORDER,
        };
        Self { window, order, trial: planned, force_all }
    }

    /// Of a path in pieces.
    fn of_path(scene: &Scene, source: &Source, path: &Path, force_all: bool) -> Self {
        let flown = path::Flown::new(scene, source, path);
        let most_m =
            growth::rounding_m(scene.duration_s) * share_of_rounding(scene.navigator.precision);
        let asked = scene.navigator.window.and_then(Candidate::find);
        let mut candidates = match asked {
            Some(asked) => vec![asked],
            None => candidates(scene, source),
        };
        if force_all && asked.is_none() {
            candidates.sort_by_key(|c| std::cmp::Reverse(c.shape.history + c.shape.lookahead));
        }
        let (chosen, tried, enough_m) = flown.choose(&candidates, most_m);
        let fallback = chosen.map_or(WindowShape::new(2, 2, 2), |chosen| chosen.shape);
        Self {
            window: scene.navigator.window.unwrap_or(fallback),
            order: plan::HIGHEST_ORDER,
            trial: chosen.map(|chosen| Planned {
                tried,
                predicted_m: chosen.predicted_m,
                most_m: enough_m,
            }),
            force_all,
        }
    }

    /// The window flown, if the algorithm has one.
    pub fn flown_window(&self, scene: &Scene) -> Option<WindowShape> {
        (scene.navigator.algorithm == Algorithm::Taylor).then_some(self.window)
    }

    /// What is skipped, each with what that saves against a run that skips nothing.
    pub fn skipped(
        &self,
        scene: &Scene,
        source: &Source,
        navigator: &dyn Navigate,
    ) -> Vec<Skipped> {
        let mut skipped = Vec::new();
        let Ok(forced) = Source::new(scene, true) else { return skipped };
        if self.force_all {
            return skipped;
        }
        let mut skip = |what: String, why: &str, with_ns: f64, without_ns: f64| {
            let saved = format!("{:.0} ns per sample", (with_ns - without_ns).max(0.0));
            skipped.push(Skipped { what, why: why.to_owned(), saved });
        };
        let samples = scene.samples().min(SKIPPED_SAMPLES);
        let increments = timing::perfect(source, samples);

        let finest = source.quadrature.finest().evaluations();
        let used = source.quadrature.evaluations();
        if source.is_constant() || used < finest {
            let (what, why) = if source.is_constant() {
                ("evaluation of the motion".to_owned(), "every channel is constant")
            } else {
                let what = format!("{} of {finest} evaluations per sample", finest - used);
                (what, "fewer reach the rounding floor for a motion this slow")
            };
            let with_ns = timing::trajectory(&forced, samples);
            skip(what, why, with_ns, timing::trajectory(source, samples));
        }
        if source.emulator.is_none() {
            let with_ns = timing::emulator(&forced, &increments);
            skip("the sensor emulator".to_owned(), "the sensors are perfect", with_ns, 0.0);
        }
        if let Some((all, what, why)) = self.unreduced(scene)
            && let Some(all) = all.start(scene, source)
        {
            let with_ns = timing::navigation(all.as_ref(), &increments);
            skip(what, why, with_ns, timing::navigation(navigator, &increments));
        }
        let mut erring = scene.clone();
        erring.gyro.constant = Some([1e-9; 3]);
        if let (Ok(theory), Ok(mut forced)) = (Theory::new(scene), Theory::new(&erring))
            && theory.is_zero()
        {
            let with_ns = timing::per_sample(samples, &mut || {
                for n in 1..=samples {
                    std::hint::black_box(forced.at(source.time_s(n)));
                }
            });
            skip("theory".to_owned(), "without errors no drift is expected", with_ns, 0.0);
        }
        skipped
    }

    /// The plan with the widest window, or else the whole series, where this one has less: what that
    /// leaves out, and why.
    fn unreduced(&self, scene: &Scene) -> Option<(Self, String, &'static str)> {
        if scene.navigator.algorithm != Algorithm::Taylor || scene.aiding.is_there() {
            return None;
        }
        let full = Self { order: plan::HIGHEST_ORDER, ..*self };
        let widest = Self { window: plan::UNKNOWN, ..full };
        if is_cheaper(self.window, widest.window) {
            let WindowShape { history, block, lookahead } = widest.window;
            let what = format!("the window {history},{block},{lookahead} and its full series");
            return Some((widest, what, "a cheaper one is planned or asked for"));
        }
        let terms = navigator::terms(self.window)?.min(plan::HIGHEST_ORDER);
        let what = format!("orders {} to {terms} of the window's series", self.order + 1);
        let why = "those below reach the rounding floor for a motion this slow";
        (self.order < terms).then_some((full, what, why))
    }

    /// The navigator of this plan, at the scene's start without its initial error.
    fn start(&self, scene: &Scene, source: &Source) -> Option<Box<dyn Navigate>> {
        let interval_s = Pair::new(scene.rate_hz).reciprocal();
        let initial = source.initial(0);
        navigator::start(&scene.navigator, self.window, self.order, interval_s, &initial).ok()
    }
}
