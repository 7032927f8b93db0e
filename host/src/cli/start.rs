//! Where a flight starts, against the frame that is to navigate it.

use crate::input::{Complaint, InputError};
use crate::navigator::{self, Unavailable};
use crate::scene::{self, Frame, Navigator, Scene};
use crate::simulate;
use schuler::math::compensated::Pair;
use schuler::strapdown::mechanization::StartError;
use schuler::strapdown::plan;
use schuler::trajectory::Trajectory as _;

/// Refuses a start at a pole where the frame has none: it is the frame's fault if that was given on the
/// command line, else that of the scene, a built-in name or a path.
pub(super) fn check(scene: &Scene, name: &str, frame: Option<Frame>) -> Result<(), InputError> {
    let Ok(course) = scene.trajectory.build() else { return Ok(()) };
    let initial = simulate::offset(&course.at(0.0).initial(), scene);
    let interval_s = Pair::new(scene.rate_hz).reciprocal();
    let (shape, order) = (plan::UNKNOWN.into(), plan::HIGHEST_ORDER);
    let auto = Navigator { window: None, ..scene.navigator };
    match navigator::start(&auto, shape, order, interval_s, &initial) {
        Err(Unavailable::Start(StartError::Pole)) => {
            let accepted = "another start, or the frame \"earth-fixed\"";
            let complaint =
                Complaint::new("the local-level frame cannot start at a pole", accepted);
            Err(match frame {
                Some(_) => InputError::option("--frame", complaint),
                None => scene::blame(name, "trajectory.latitude_deg", complaint),
            })
        }
        _ => Ok(()),
    }
}
