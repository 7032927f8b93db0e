//! The `[trajectory]` table: exactly one of channels, segments, way-points and a log, and what rides on it.

mod channels;
mod given;
mod log;
mod mount;
mod path;
mod points;
mod positions;
mod segments;
mod thinned;
mod through;
mod waypoints;

use crate::input::document::Section;
use crate::input::{Complaint, InputError};
use crate::scene::Trajectory;
use crate::scene::keys::motion as keys;

/// The table, or rest at the origin where there is none; a log lies beside the scene's file.
pub fn read(root: &Section<'_>, file: &str) -> Result<Trajectory, InputError> {
    let Some(section) = root.table("trajectory", &keys::TRAJECTORY)? else {
        return Ok(Trajectory::default());
    };
    let mounting = mount::read(&section)?;
    let made = match kind(&section)? {
        Kind::Channels => {
            if let Some(value) = section.get(keys::ATTITUDE.name) {
                let complaint = Complaint::new("is of a path, and channels are none", "");
                return Err(value.error(complaint));
            }
            let crosses_pole = section
                .get(keys::CROSSES_POLE.name)
                .map_or(Ok(false), |value| value.truth(keys::CROSSES_POLE.accepted()))?;
            let motion = channels::read(&section, crosses_pole)?;
            return Ok(Trajectory { mounting, ..motion });
        }
        Kind::Segments => segments::read(&section)?,
        Kind::Waypoints => waypoints::read(&section, file)?,
        Kind::Log => log::read(&section, file)?,
    };
    let (path, route) = made;
    Ok(Trajectory { path: Some(path), route: Some(route), mounting, ..Trajectory::default() })
}

/// The kinds of motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Channels,
    Segments,
    Waypoints,
    Log,
}

/// The one kind whose keys are there.
fn kind(section: &Section<'_>) -> Result<Kind, InputError> {
    let first = |keys: &[&'static str]| keys.iter().copied().find(|key| section.get(key).is_some());
    let channels: Vec<_> = channels::CHANNELS.iter().map(|key| key.name).collect();
    let kinds = [
        (first(&channels), Kind::Channels),
        (first(&[keys::SEGMENTS.name, keys::BEGIN.name]), Kind::Segments),
        (first(&[keys::POINTS.name]), Kind::Waypoints),
        (first(&[keys::RECORD.name]), Kind::Log),
    ];
    let mut there = kinds.into_iter().filter_map(|(key, kind)| Some((key?, kind)));
    match (there.next(), there.next()) {
        (Some((one, _)), Some((other, _))) => {
            let accepted = "channels, or start with segments, or waypoints, or log";
            Err(section.blame(other, Complaint::new(format!("stands beside {one}"), accepted)))
        }
        (one, _) => Ok(one.map_or(Kind::Channels, |(_, kind)| kind)),
    }
}
