//! The `[trajectory]` table: exactly one of channels, segments, way-points and a log, and what rides on it.

mod channels;
mod mount;

use crate::input::document::Section;
use crate::input::{Complaint, InputError};
use crate::scene::Trajectory;
use crate::scene::keys::motion as keys;

/// The table, or rest at the origin where there is none; a log lies beside the scene's file.
pub fn read(root: &Section<'_>, _file: &str) -> Result<Trajectory, InputError> {
    let Some(section) = root.table("trajectory", &keys::TRAJECTORY)? else {
        return Ok(Trajectory::default());
    };
    one_of(&section)?;
    let crosses_pole = section
        .get(keys::CROSSES_POLE.name)
        .map_or(Ok(false), |value| value.truth(keys::CROSSES_POLE.accepted()))?;
    let motion = channels::read(&section, crosses_pole)?;
    Ok(Trajectory { mounting: mount::read(&section)?, ..motion })
}

/// The keys of the kinds of motion, the first of each that is there.
fn one_of(section: &Section<'_>) -> Result<(), InputError> {
    let first = |keys: &[&'static str]| keys.iter().copied().find(|key| section.get(key).is_some());
    let channels: Vec<_> = channels::CHANNELS.iter().map(|key| key.name).collect();
    let kinds = [
        first(&channels),
        first(&[keys::SEGMENTS.name, keys::BEGIN.name]),
        first(&[keys::POINTS.name]),
        first(&[keys::RECORD.name]),
    ];
    let mut there = kinds.into_iter().flatten();
    match (there.next(), there.next()) {
        (Some(one), Some(other)) => {
            let accepted = "channels, or start with segments, or waypoints, or log";
            Err(section.blame(other, Complaint::new(format!("stands beside {one}"), accepted)))
        }
        _ => Ok(()),
    }
}
