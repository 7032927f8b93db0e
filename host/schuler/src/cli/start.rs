//! Checks that navigation can start from a flight's initial state.

use schuler::flight::plan;
use schuler::math::compensated::Pair;
use schuler::strapdown::limits::StartError;
use schuler::trajectory::Trajectory as _;
use schuler_simulator::input::InputError;
use schuler_simulator::navigator::{self, Unavailable};
use schuler_simulator::scene::{self, Axes, Navigator, Scene};
use schuler_simulator::simulate;

/// Refuses a start that navigation cannot make. A pole is the frame's fault if that was given on the
/// command line; all else is that of the scene, a built-in name or a path.
pub(super) fn check(scene: &Scene, name: &str, frame: Option<Axes>) -> Result<(), InputError> {
    let Ok(course) = scene.trajectory.build() else { return Ok(()) };
    let initial = simulate::offset(&course.at(0.0).initial(), scene);
    let interval_s = Pair::new(scene.rate_hz).reciprocal();
    let (shape, order) = (plan::UNKNOWN, plan::HIGHEST_ORDER);
    let auto = Navigator { window: None, ..scene.navigator };
    navigator::start(&auto, shape, order, interval_s, &initial).map(drop).map_err(|unavailable| {
        let complaint = unavailable.complaint();
        match unavailable {
            Unavailable::Start(StartError::Pole) if frame.is_some() => {
                InputError::option("--frame", complaint)
            }
            _ => {
                let key = match (&unavailable, &scene.trajectory.route) {
                    (Unavailable::Start(_), Some(route)) => route.from.key(),
                    _ => unavailable.key(),
                };
                scene::blame(name, key, complaint)
            }
        }
    })
}
