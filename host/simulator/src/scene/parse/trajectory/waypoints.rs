//! `[trajectory.waypoints]`: a path through points.

use super::given::{Given, Pace, given, of_file};
use super::path::{MOST_PIECES, Made, along, made, rule, unflyable};
use super::points::{near_origin, radians};
use super::segments::{BLEND_S, LINES, complaint};
use crate::course::{Path, Reference};
use crate::input::document::{Section, Value};
use crate::input::{Complaint, InputError};
use crate::number;
use crate::scene::keys::{motion, path as keys};
use crate::scene::route::{Manoeuvres, Origin};
use crate::units::DEGREE;
use schuler::earth::Geodetic;
use schuler::math::compensated::Pair;
use schuler::trajectory::Trajectory as _;
use schuler::trajectory::piecewise::{Attitude, PathError, Piecewise};
use schuler::trajectory::segment::compile::segment::Segment;
use schuler::trajectory::segment::compile::{Compiler, SegmentError};
use schuler::trajectory::spline::{BAND, EXTRA, Ends};
use schuler::trajectory::waypoints::fault::WaypointError;
use schuler::trajectory::waypoints::fly_by::{FlyBy, ROOM, fly_by};
use schuler::trajectory::waypoints::through::{through, times_from_speeds};
use std::sync::Arc;

/// Bank of the turns that is not given, °.
const BANK_DEG: f64 = 25.0;

/// How points are flown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Mode {
    Through,
    FlyBy,
}

const MODES: &[(&str, Mode)] = &[("through", Mode::Through), ("fly-by", Mode::FlyBy)];

/// The path that they make.
pub fn read(root: &Section<'_>, scene: &str) -> Result<Made, InputError> {
    let value = root.require(motion::POINTS.name, "a table")?;
    let section = value.section(&keys::WAYPOINTS.names())?;
    let (list, given) = match section.get(keys::WAYPOINT_FILE.name) {
        None => {
            let list = section.require(keys::LIST.name, keys::LIST.accepted())?;
            let given = given(&section, list.items(keys::LIST.accepted())?)?;
            (list, given)
        }
        Some(file) if section.get(keys::LIST.name).is_some() => {
            return Err(file.error(Complaint::new("stands beside points", "one of them")));
        }
        Some(file) => {
            let given = of_file(&section, &file, scene)?;
            (file, given)
        }
    };
    if let Some(complaint) = radians(&given.places, DEGREE)
        && !near_origin(&section, &keys::NEAR_ORIGIN)?
    {
        return Err(list.error(complaint));
    }
    let mode = section.get(keys::MODE.name).map(|value| value.choice(MODES)).transpose()?;
    if mode == Some(Mode::FlyBy) {
        return past(root, &section, &list, given);
    }
    for key in [&keys::WAYPOINT_BANK, &keys::WAYPOINT_BLEND, &keys::WAYPOINT_LINE] {
        if let Some(value) = section.get(key.name) {
            return Err(value.error(Complaint::new("is of fly-by", "mode = \"fly-by\"")));
        }
    }
    let (attitude, rule) = rule(root)?;
    let blame = |error| blame(error, &given.items, &list);
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
    let origin = Origin::Waypoints { past: None, points };
    Ok(made(Path::Spline(Arc::new(path)), origin, attitude))
}

/// The path around the corners between them.
fn past(
    root: &Section<'_>,
    section: &Section<'_>,
    list: &Value<'_>,
    given: Given<'_>,
) -> Result<Made, InputError> {
    let Pace::Speeds(speeds_m_s) = &given.pace else {
        let complaint = Complaint::new("has times, and a fly-by takes speeds", "speed_m_s");
        return Err(list.error(complaint));
    };
    let (attitude, rule) = rule(root)?;
    let line =
        section.get(keys::WAYPOINT_LINE.name).map(|value| value.choice(LINES)).transpose()?;
    let plan = FlyBy {
        points: &given.places,
        rule,
        speeds_m_s,
        bank: section.read(&keys::WAYPOINT_BANK)?.unwrap_or(BANK_DEG) * DEGREE,
        blend_s: section.read(&keys::WAYPOINT_BLEND)?.unwrap_or(BLEND_S),
        line: line.unwrap_or_default(),
    };
    let blame = |error| blame(error, &given.items, list);
    let mut segments = vec![Segment::Hold { duration_s: 0.0 }; ROOM * given.places.len()];
    let (start, count) = match fly_by(&plan, &mut segments) {
        Ok(flown) => flown,
        Err(error) => return Err(blame(wide_enough(error, &plan, &mut segments))),
    };
    segments.truncate(count);
    let failed = |error: SegmentError| list.error(complaint(error.fault));
    let compiler = Compiler::new(start, rule, &segments).map_err(failed)?;
    let pieces: Vec<_> = compiler.take(MOST_PIECES).collect::<Result<_, _>>().map_err(failed)?;
    if pieces.len() == MOST_PIECES {
        let what = format!("takes more than {MOST_PIECES} pieces");
        return Err(list.error(Complaint::new(what, "fewer points, or longer blends")));
    }
    let path = Piecewise::new(pieces, Attitude::Stored)
        .map_err(|error| list.error(unflyable(error, attitude)))?;
    let path = Path::Blend(Arc::new(path));
    let points = given.places.iter().map(|place| (nearest(&path, place), *place)).collect();
    let origin = Origin::Waypoints { past: Some(Manoeuvres { start, rule, segments }), points };
    Ok(made(path, origin, attitude))
}

/// The same error with a bank that does for both legs of its point: each leg tells its own.
fn wide_enough(first: WaypointError, plan: &FlyBy<'_>, segments: &mut [Segment]) -> WaypointError {
    let mut told = first;
    while let WaypointError::TooTight { index, bank, .. } = told {
        // Rounded up as it is told.
        let plan = FlyBy { bank: 1.001 * bank, ..*plan };
        match fly_by(&plan, segments) {
            Err(next @ WaypointError::TooTight { index: other, bank: more, .. })
                if other == index && more > plan.bank =>
            {
                told = next;
            }
            _ => break,
        }
    }
    told
}

/// When a path is nearest to a place, s.
fn nearest(path: &Path, place: &Geodetic<f64>) -> f64 {
    let motion = Reference::Path(path.clone());
    let to = place.to_earth_fixed();
    let distance = |time_s: f64| {
        let at = motion.solution_at(Pair::new(time_s));
        (at.position.map(|x| x.hi + x.lo).to_earth_fixed() - to).norm()
    };
    let spans = path.spans();
    let nearer = |a: &f64, b: &f64| distance(*a).total_cmp(&distance(*b));
    let best = spans.iter().flatten().copied().min_by(nearer).unwrap_or(0.0);
    let before = spans.iter().rfind(|span| span[0] < best).map_or(best, |span| span[0]);
    let behind = spans.iter().find(|span| span[1] > best).map_or(best, |span| span[1]);
    // Halving by thirds: the distance has one minimum about there.
    let (mut from, mut to_s) = (before, behind);
    for _ in 0..80 {
        let third = (to_s - from) / 3.0;
        if distance(from + third) < distance(to_s - third) {
            to_s -= third;
        } else {
            from += third;
        }
    }
    0.5 * (from + to_s)
}

/// An error at its point.
fn blame(error: WaypointError, items: &[Value<'_>], list: &Value<'_>) -> InputError {
    let (index, complaint) = at(error);
    match (index, index.and_then(|index| items.get(index))) {
        (_, Some(item)) => item.error(complaint),
        (None, None) => list.error(complaint),
        (Some(index), None) => {
            let what = format!("point {}: {}", index + 1, complaint.what);
            list.error(Complaint { what, ..complaint })
        }
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
        WaypointError::TooTight { index, bank, radius_m } => {
            let (bank, radius) = (short(1.001 * bank / DEGREE), short(radius_m));
            let accepted = format!("a bank of {bank}° (a radius of {radius} m), or a lower speed");
            let what = "turns wider than its legs allow";
            return (Some(index), Complaint::new(what, accepted));
        }
        WaypointError::NoTurn { index } => (
            index,
            "has legs that are too short for its turn at any bank".to_owned(),
            "a lower speed, or a shorter blend_s",
        ),
        WaypointError::Short { index } => (
            index,
            "ends a leg without room for its turns, its change of speed and its climb".to_owned(),
            "a longer leg, or a lower speed",
        ),
        WaypointError::Pole { index } => {
            (index, "is at a pole, where a rhumb line has no course".to_owned(), "\"geodesic\"")
        }
        WaypointError::Leg { index, fault } => return (Some(index), complaint(fault)),
        other => return (None, Complaint::new(other.to_string(), "")),
    };
    (Some(index), Complaint::new(what, accepted))
}
