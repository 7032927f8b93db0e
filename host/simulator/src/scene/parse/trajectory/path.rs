//! What the kinds of paths have in common.

use crate::course::Path;
use crate::input::document::Section;
use crate::input::{Complaint, InputError};
use crate::number;
use crate::scene::keys::motion as keys;
use crate::scene::route::{Origin, Peaks, Route};
use schuler::trajectory::piecewise::{Attitude, LEAST_SPEED, PathError};
use schuler::trajectory::segment::attitude::AttitudeRule;
use std::sync::Arc;

/// Pieces of segments at most: 77 MB.
pub const MOST_PIECES: usize = 100_000;
/// Rows of a log at most: 205 MB.
pub const MOST_ROWS: usize = 400_000;

/// A path and what it was made from.
pub type Made = (Path, Arc<Route>);

/// How the body lies along a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lie {
    /// By a rule.
    Rule(AttitudeRule),
    /// By the angles of a log.
    Log,
}

const LIES: &[(&str, Lie)] = &[
    ("coordinated", Lie::Rule(AttitudeRule::Coordinated)),
    ("upright", Lie::Rule(AttitudeRule::Upright)),
    ("level", Lie::Rule(AttitudeRule::Level)),
    ("log", Lie::Log),
];

/// The attitude that a scene asks for, with its name.
pub fn lie(section: &Section<'_>) -> Result<Option<(&'static str, Lie)>, InputError> {
    let Some(value) = section.get(keys::ATTITUDE.name) else { return Ok(None) };
    let lie = value.choice(LIES)?;
    Ok(LIES.iter().find(|(_, other)| *other == lie).copied())
}

/// The same of a path that has no angles of its own.
pub fn rule(section: &Section<'_>) -> Result<(&'static str, AttitudeRule), InputError> {
    match lie(section)? {
        None => Ok(("coordinated", AttitudeRule::Coordinated)),
        Some((name, Lie::Rule(rule))) => Ok((name, rule)),
        Some((_, Lie::Log)) => {
            let accepted = "\"coordinated\", \"upright\", \"level\"";
            let complaint = Complaint::new("\"log\" needs a log with angles", accepted);
            Err(section.blame(keys::ATTITUDE.name, complaint))
        }
    }
}

/// Where the pieces' attitude comes from, by a rule.
pub fn along(rule: AttitudeRule) -> Attitude {
    match rule {
        AttitudeRule::Coordinated => Attitude::Coordinated,
        AttitudeRule::Upright => Attitude::Upright,
        AttitudeRule::Level => Attitude::Level,
    }
}

/// What pieces that are no path are told, where it is the attitude's fault.
pub fn unflyable(error: PathError, attitude: &str) -> Complaint {
    match error {
        PathError::Slow { time_s, speed } => Complaint::new(
            format!(
                "moves at {} m/s at {} s, too slowly to tell a {attitude} attitude",
                number::short(speed),
                number::parameter(time_s)
            ),
            format!(
                "from {LEAST_SPEED} m/s up; segments may stand, and a log may bring its angles"
            ),
        ),
        other => Complaint::new(other.to_string(), ""),
    }
}

/// A path with its extremes.
pub fn made(path: Path, from: Origin, attitude: &'static str) -> Made {
    let peaks = Peaks::new(&path);
    (path, Arc::new(Route { from, attitude, peaks }))
}
