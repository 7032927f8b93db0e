//! Way-points as a scene gives them: a list, or a file.

use super::points::swapped;
use super::positions;
use crate::input::document::{Section, Value};
use crate::input::{Complaint, InputError};
use crate::reference::Track;
use crate::scene::keys::path as keys;
use crate::units::DEGREE;
use schuler::earth::Geodetic;

/// Way-points as they are given.
pub struct Given<'a> {
    /// The tables of the points; none where a file has them.
    pub items: Vec<Value<'a>>,
    /// Where each is.
    pub places: Vec<Geodetic<f64>>,
    /// When each is passed, s, or how fast, m/s.
    pub pace: Pace,
}

/// How points are passed.
pub enum Pace {
    /// When, s.
    Times(Vec<f64>),
    /// How fast, m/s.
    Speeds(Vec<f64>),
}

/// Their places, and their times or speeds.
pub fn given<'a>(section: &Section<'a>, items: Vec<Value<'a>>) -> Result<Given<'a>, InputError> {
    let common = section.read(&keys::WAYPOINT_SPEED)?;
    let (mut places, mut times_s, mut speeds) = (Vec::new(), Vec::new(), Vec::new());
    for item in &items {
        let point = item.section(&keys::POINT.names())?;
        places.push(Geodetic {
            latitude: point.need(&keys::POINT_LATITUDE).map_err(swapped)? * DEGREE,
            longitude: point.need(&keys::POINT_LONGITUDE)? * DEGREE,
            altitude: point.need(&keys::POINT_ALTITUDE)?,
        });
        match (point.read(&keys::POINT_TIME)?, point.read(&keys::POINT_SPEED)?) {
            (Some(_), Some(_)) => {
                let complaint = Complaint::new("stands beside time_s", "one of them");
                return Err(point.blame(keys::POINT_SPEED.name, complaint));
            }
            (Some(time_s), None) => {
                let before = times_s.last().copied();
                if let Some(what) = misplaced(time_s, before) {
                    let accepted = "the first at 0, and times that increase";
                    let complaint = Complaint::new(what, accepted);
                    return Err(point.blame(keys::POINT_TIME.name, complaint));
                }
                times_s.push(time_s);
            }
            (None, speed) => speeds.extend(speed.or(common)),
        }
        let all_timed = times_s.len() == places.len();
        if !all_timed && speeds.len() != places.len() {
            let key = if times_s.is_empty() { keys::POINT_SPEED } else { keys::POINT_TIME };
            let accepted = "a time_s at each point, or a speed at each or for all";
            return Err(point.blame(key.name, Complaint::new("is missing", accepted)));
        }
    }
    let pace = if times_s.is_empty() { Pace::Speeds(speeds) } else { Pace::Times(times_s) };
    Ok(Given { items, places, pace })
}

/// The points of a file: by its times, or with one speed for all.
pub fn of_file<'a>(
    section: &Section<'_>,
    value: &Value<'_>,
    scene: &str,
) -> Result<Given<'a>, InputError> {
    let name = value.text(keys::WAYPOINT_FILE.accepted())?;
    let folder = std::path::Path::new(scene).parent().unwrap_or(std::path::Path::new(""));
    let track = Track::read(&folder.join(name).to_string_lossy())?;
    let speed = section.read(&keys::WAYPOINT_SPEED)?;
    let altitude = section.read(&keys::WAYPOINT_ALTITUDE)?;
    let (mut places, mut times_s) = (Vec::new(), Vec::new());
    for fix in &track.fixes {
        let (latitude, longitude) = (fix.latitude, fix.longitude);
        let altitude = positions::height(&track, fix, altitude)?;
        places.push(Geodetic { latitude, longitude, altitude });
        if speed.is_none() {
            times_s.push(positions::time_s(&track, fix, times_s.last().copied())?);
        }
    }
    let start_s = times_s.first().copied().unwrap_or_default();
    let pace = match speed {
        Some(speed) => Pace::Speeds(vec![speed; places.len()]),
        None => Pace::Times(times_s.into_iter().map(|time_s| time_s - start_s).collect()),
    };
    Ok(Given { items: Vec::new(), places, pace })
}

/// What is wrong with a time behind another.
fn misplaced(time_s: f64, before: Option<f64>) -> Option<String> {
    match before {
        None => (time_s != 0.0).then(|| format!("{time_s} is not the start")),
        Some(before) => (time_s <= before)
            .then(|| format!("{time_s} does not come after {before} of the point before")),
    }
}
