//! `[trajectory.waypoints]`: a path through points.

use super::path::{Made, along, made, rule, unflyable};
use super::points::{near_origin, radians, swapped};
use crate::course::Path;
use crate::input::document::{Section, Value};
use crate::input::{Complaint, InputError};
use crate::number;
use crate::scene::keys::{motion, path as keys};
use crate::scene::route::Origin;
use crate::units::DEGREE;
use schuler::earth::Geodetic;
use schuler::trajectory::piecewise::{PathError, Piecewise};
use schuler::trajectory::spline::{BAND, EXTRA, Ends};
use schuler::trajectory::waypoints::fault::WaypointError;
use schuler::trajectory::waypoints::through::{through, times_from_speeds};
use std::sync::Arc;

/// Way-points as they are given.
struct Given<'a> {
    items: Vec<Value<'a>>,
    places: Vec<Geodetic<f64>>,
    /// When each is passed, s, or how fast, m/s.
    pace: Pace,
}

enum Pace {
    Times(Vec<f64>),
    Speeds(Vec<f64>),
}

/// The path that they make.
pub fn read(root: &Section<'_>) -> Result<Made, InputError> {
    let value = root.require(motion::POINTS.name, "a table")?;
    let section = value.section(&keys::WAYPOINTS.names())?;
    let list = section.require(keys::LIST.name, keys::LIST.accepted())?;
    let given = given(&section, list.items(keys::LIST.accepted())?)?;
    if let Some(complaint) = radians(&given.places, DEGREE)
        && !near_origin(&section, &keys::NEAR_ORIGIN)?
    {
        return Err(list.error(complaint));
    }
    for key in [&keys::WAYPOINT_BANK, &keys::WAYPOINT_BLEND, &keys::WAYPOINT_LINE] {
        if let Some(value) = section.get(key.name) {
            return Err(value.error(Complaint::new("is of fly-by", "mode = \"fly-by\"")));
        }
    }
    let (attitude, rule) = rule(root)?;
    let blame = |error| match at(error) {
        (Some(index), complaint) if index < given.items.len() => {
            given.items[index].error(complaint)
        }
        (_, complaint) => list.error(complaint),
    };
    let room = given.places.len() + EXTRA;
    let (mut band, mut control) = (vec![[0.0; BAND]; room], vec![[0.0; 4]; room]);
    let times_s = match given.pace {
        Pace::Times(times_s) => times_s,
        Pace::Speeds(speeds) => {
            let mut times_s = vec![0.0; speeds.len()];
            let (band, control) = (&mut band, &mut control);
            times_from_speeds(&given.places, &speeds, Ends::Natural, &mut times_s, band, control)
                .map_err(blame)?;
            times_s
        }
    };
    let path = through(&given.places, &times_s, Ends::Natural, &mut band, &mut control);
    let path = path.map_err(blame)?;
    let pieces: Vec<_> = (0..path.pieces()).filter_map(|index| path.piece(index)).collect();
    let path = Piecewise::new(pieces, along(rule)).map_err(|error| {
        let complaint = unflyable(error, attitude);
        match error {
            // The point behind it.
            PathError::Slow { time_s, .. } => {
                let behind = times_s.partition_point(|&t| t < time_s);
                let item = given.items.get(behind).or(given.items.last());
                item.map_or_else(|| list.error(complaint.clone()), |i| i.error(complaint.clone()))
            }
            _ => list.error(complaint),
        }
    })?;
    let points = times_s.iter().copied().zip(given.places).collect();
    let origin = Origin::Waypoints { fly_by: false, points };
    Ok(made(Path::Spline(Arc::new(path)), origin, attitude))
}

/// Their places, and their times or speeds.
fn given<'a>(section: &Section<'a>, items: Vec<Value<'a>>) -> Result<Given<'a>, InputError> {
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

/// What is wrong with a time behind another.
fn misplaced(time_s: f64, before: Option<f64>) -> Option<String> {
    match before {
        None => (time_s != 0.0).then(|| format!("{time_s} is not the start")),
        Some(before) => (time_s <= before)
            .then(|| format!("{time_s} does not come after {before} of the point before")),
    }
}

/// The point at fault, and what is wrong with it.
fn at(error: WaypointError) -> (Option<usize>, Complaint) {
    let short = number::short;
    let (index, what, accepted) = match error {
        WaypointError::TooFew => {
            return (None, Complaint::new("has too few points", "two points or more"));
        }
        WaypointError::NotIncreasing { index } => {
            (index, "is not later than the point before".to_owned(), "times that increase")
        }
        WaypointError::Coincident { index } => {
            (index, "is the same place as the point before".to_owned(), "a point elsewhere")
        }
        WaypointError::Antipodal { index } => (
            index,
            "is opposite to the point before, so that every direction leads there".to_owned(),
            "a point between them",
        ),
        WaypointError::Speed { index } => {
            (index, "ends a leg at whose ends the speed is 0".to_owned(), "a speed above 0")
        }
        WaypointError::TooFast { index, speed_m_s } => (
            index,
            format!("takes {} m/s since the point before", short(speed_m_s)),
            "at most 1e5 m/s",
        ),
        WaypointError::TooSharp { index, acceleration_m_s2 } => {
            (index, format!("takes {} m/s² near it", short(acceleration_m_s2)), "at most 1e5 m/s²")
        }
        other => return (None, Complaint::new(other.to_string(), "")),
    };
    (Some(index), Complaint::new(what, accepted))
}
