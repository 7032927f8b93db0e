//! What a run does and what it can leave out, decided once; what is left out is measured.

use crate::flight::Skipped;
use crate::navigator::{self, Navigate};
use crate::scene::{Algorithm, Frame, Precision, Scene, WindowShape};
use crate::source::Source;
use crate::theory::Theory;
use crate::timing;
use schuler::math::compensated::Pair;
use schuler::strapdown::plan::{self, Digits, Flight, Shape};
use schuler::trajectory::Trajectory as _;

/// Samples that what is skipped is measured over, at most.
const SKIPPED_SAMPLES: u64 = 500;

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

/// Whether a window looks at fewer samples beside its block.
fn is_cheaper(window: WindowShape, other: WindowShape) -> bool {
    window.history + window.lookahead < other.history + other.lookahead
}

impl From<Shape> for WindowShape {
    fn from((history, block, lookahead): Shape) -> Self {
        Self { history, block, lookahead }
    }
}

impl Plan {
    /// Of a scene; `force_all` skips nothing.
    pub fn new(scene: &Scene, source: &Source, force_all: bool) -> Self {
        let bound = source.course.bound();
        let digits = match scene.navigator.precision {
            Precision::F64 => Digits::Double,
            Precision::F32 => Digits::Single,
            Precision::F32x2 => Digits::TwoFloat,
        };
        let flight = Flight {
            bandwidth: bound.bandwidth,
            angular_rate: bound.angular_rate,
            interval_s: 1.0 / scene.rate_hz,
            digits,
            earth_fixed: scene.navigator.frame == Frame::EarthFixed,
        };
        let mut planned = plan::window(&flight).into();
        if force_all && is_cheaper(planned, plan::UNKNOWN.into()) {
            planned = plan::UNKNOWN.into();
        }
        let window = scene.navigator.window.unwrap_or(planned);
        let order = if force_all {
            plan::HIGHEST_ORDER
        } else {
            plan::order(&flight, (window.history, window.block, window.lookahead))
        };
        Self { window, order, force_all }
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
        if scene.navigator.algorithm != Algorithm::Taylor {
            return None;
        }
        let full = Self { order: plan::HIGHEST_ORDER, ..*self };
        let widest = Self { window: plan::UNKNOWN.into(), ..full };
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
        let initial = source.motion(0).initial();
        navigator::start(&scene.navigator, self.window, self.order, interval_s, &initial).ok()
    }
}
