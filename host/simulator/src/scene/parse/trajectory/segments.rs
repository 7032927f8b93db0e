//! `[[trajectory.segment]]`: what a pilot or a driver does, compiled.

use super::path::{MOST_PIECES, Made, made, rule};
use crate::course::Path;
use crate::input::document::{Section, Value};
use crate::input::key::Key;
use crate::input::{Complaint, InputError, Range};
use crate::number;
use crate::scene::keys::{motion, path as keys};
use crate::scene::route::{Manoeuvres, Origin};
use crate::units::DEGREE;
use schuler::earth::Geodetic;
use schuler::trajectory::piecewise::{Attitude, Piecewise};
use schuler::trajectory::segment::compile::segment::{
    Amount, Length, Pace, Segment, Tightness, Way,
};
use schuler::trajectory::segment::compile::{Compiler, SegmentError, Start};
use schuler::trajectory::segment::control::Line;
use schuler::trajectory::segment::fault::Fault;
use std::sync::Arc;

/// Time of a blend that is not given, s.
pub const BLEND_S: f64 = 4.0;
/// What is straight.
pub const LINES: &[(&str, Line)] = &[("geodesic", Line::Geodesic), ("rhumb", Line::Rhumb)];
const WAYS: &[(&str, Way)] =
    &[("shorter", Way::Shorter), ("left", Way::Left), ("right", Way::Right)];
/// The keys of which a segment has exactly one.
const ACTIONS: [&Key; 8] = [
    &keys::HOLD,
    &keys::ACCELERATE,
    &keys::CLIMB,
    &keys::TURN,
    &keys::COURSE,
    &keys::STRAIGHT_TIME,
    &keys::STRAIGHT_LENGTH,
    &keys::ROTATE,
];

/// The path that they make.
pub fn read(section: &Section<'_>) -> Result<Made, InputError> {
    let begin = section.require(motion::BEGIN.name, "a table")?;
    let start = start(&begin.section(&keys::START.names())?)?;
    let (attitude, rule) = rule(section)?;
    let list = section.require(motion::SEGMENTS.name, motion::SEGMENTS.accepted())?;
    let items = list.items(motion::SEGMENTS.accepted())?;
    let tables: Vec<_> =
        items.iter().map(|item| item.section(&keys::SEGMENT.names())).collect::<Result<_, _>>()?;
    let segments: Vec<_> = tables.iter().map(segment).collect::<Result<_, _>>()?;
    let blame = |error: SegmentError| match error.index.and_then(|index| tables.get(index)) {
        Some(table) => refuse(table, error.fault),
        None => begin.error(complaint(error.fault)),
    };
    let compiler = Compiler::new(start, rule, &segments).map_err(blame)?;
    let mut pieces = Vec::new();
    for piece in compiler {
        pieces.push(piece.map_err(blame)?);
        if pieces.len() > MOST_PIECES {
            let complaint = Complaint::new(
                format!("takes more than {MOST_PIECES} pieces"),
                "a shorter flight, or longer blends",
            );
            return Err(list.error(complaint));
        }
    }
    let path = Piecewise::new(pieces, Attitude::Stored)
        .map_err(|error| list.error(Complaint::new(error.to_string(), "")))?;
    let origin = Origin::Segments(Manoeuvres { start, rule, segments });
    Ok(made(Path::Blend(Arc::new(path)), origin, attitude))
}

fn start(section: &Section<'_>) -> Result<Start, InputError> {
    let or_zero = |key: &Key| Ok::<_, InputError>(section.read(key)?.unwrap_or(0.0));
    Ok(Start {
        position: Geodetic {
            latitude: section.need(&keys::START_LATITUDE)? * DEGREE,
            longitude: section.need(&keys::START_LONGITUDE)? * DEGREE,
            altitude: or_zero(&keys::START_ALTITUDE)?,
        },
        course: or_zero(&keys::START_COURSE)? * DEGREE,
        speed: or_zero(&keys::START_SPEED)?,
    })
}

/// The key by which a table says what it does: the only one.
fn action(section: &Section<'_>) -> Result<&'static Key, InputError> {
    let accepted = || ACTIONS.map(|key| key.name).join(", ");
    let mut there = ACTIONS.into_iter().filter(|key| section.get(key.name).is_some());
    match (there.next(), there.next()) {
        (Some(one), None) => Ok(one),
        (None, _) => Err(section.error(Complaint::new("does nothing", accepted()))),
        (Some(one), Some(other)) => {
            let what = format!("stands beside {}", one.name);
            Err(section.blame(other.name, Complaint::new(what, "one of them, and another segment")))
        }
    }
}

fn segment(section: &Section<'_>) -> Result<Segment, InputError> {
    let action = action(section)?;
    // Which of the others go with it.
    let with: &[&Key] = match action.name {
        "accelerate_to_m_s" => &[&keys::BLEND, &keys::ACCELERATION],
        "climb_m" => &[&keys::CLIMB_RATE, &keys::BLEND],
        "turn_deg" => &[&keys::BANK, &keys::RADIUS, &keys::BLEND],
        "course_deg" => &[&keys::WAY, &keys::BANK, &keys::RADIUS, &keys::BLEND],
        "straight_s" | "straight_m" => &[&keys::LINE],
        "rotate_deg" => &[&keys::BLEND],
        _ => &[],
    };
    for key in keys::SEGMENT.keys {
        let known = key.name == action.name || with.iter().any(|other| other.name == key.name);
        if let (false, Some(value)) = (known, section.get(key.name)) {
            let names: Vec<_> = with.iter().map(|key| key.name).collect();
            let what = format!("does not go with {}", action.name);
            return Err(value.error(Complaint::new(what, names.join(", "))));
        }
    }
    let blend_s = || Ok::<_, InputError>(section.read(&keys::BLEND)?.unwrap_or(BLEND_S));
    Ok(match action.name {
        "hold_s" => Segment::Hold { duration_s: section.need(action)? },
        "accelerate_to_m_s" => {
            let speed = section.need(action)?;
            let two = [&keys::BLEND, &keys::ACCELERATION];
            let (key, number) = one_of(section, two)?;
            let pace = if key == 0 { Pace::Blend(number) } else { Pace::Acceleration(number) };
            Segment::Accelerate { speed, pace }
        }
        "climb_m" => Segment::Climb {
            height: section.need(action)?,
            rate: section.need(&keys::CLIMB_RATE)?,
            blend_s: blend_s()?,
        },
        "turn_deg" | "course_deg" => {
            let angle = section.need(action)? * DEGREE;
            let amount = if action.name == "turn_deg" {
                Amount::By(angle)
            } else {
                let way =
                    section.get(keys::WAY.name).map(|value| value.choice(WAYS)).transpose()?;
                Amount::To { course: angle, way: way.unwrap_or_default() }
            };
            let (key, number) = one_of(section, [&keys::BANK, &keys::RADIUS])?;
            let tightness =
                if key == 0 { Tightness::Bank(number * DEGREE) } else { Tightness::Radius(number) };
            Segment::Turn { amount, tightness, blend_s: blend_s()? }
        }
        "straight_s" | "straight_m" => {
            let number = section.need(action)?;
            let length = if action.name == "straight_s" {
                Length::Time(number)
            } else {
                Length::Distance(number)
            };
            let line = section.get(keys::LINE.name).map(|value| value.choice(LINES)).transpose()?;
            Segment::Straight { length, line: line.unwrap_or_default() }
        }
        _ => {
            let value = section.require(action.name, action.accepted())?;
            Segment::Rotate { angles: angles(&value)?, blend_s: blend_s()? }
        }
    })
}

/// The number of the one key of two that is there, and which.
fn one_of(section: &Section<'_>, two: [&Key; 2]) -> Result<(usize, f64), InputError> {
    let names = two.map(|key| key.name).join(" or ");
    match two.map(|key| section.read(key)) {
        [Err(error), _] | [_, Err(error)] => Err(error),
        [Ok(Some(number)), Ok(None)] => Ok((0, number)),
        [Ok(None), Ok(Some(number))] => Ok((1, number)),
        [Ok(None), Ok(None)] => {
            Err(section.blame(two[0].name, Complaint::new("is missing", names)))
        }
        [Ok(Some(_)), Ok(Some(_))] => {
            let what = format!("stands beside {}", two[0].name);
            Err(section.blame(two[1].name, Complaint::new(what, names)))
        }
    }
}

fn angles(value: &Value<'_>) -> Result<[f64; 3], InputError> {
    let accepted = keys::ROTATE.accepted();
    let items = value.items(accepted)?;
    let [roll, pitch, yaw] = items.as_slice() else {
        let what = format!("has {} values", items.len());
        return Err(value.error(Complaint::new(what, accepted)));
    };
    let degrees = Range::from_to(-3600.0, 3600.0, "degrees, from -3600 to 3600");
    let angle = |item: &Value<'_>| Ok::<_, InputError>(item.number(&degrees)? * DEGREE);
    Ok([angle(roll)?, angle(pitch)?, angle(yaw)?])
}

/// A fault where its table says what is wrong.
fn refuse(table: &Section<'_>, fault: Fault) -> InputError {
    let there = |key: &&Key| table.get(key.name).is_some();
    let first = |keys: &[&'static Key]| keys.iter().copied().find(there).map_or("", |key| key.name);
    let key = match fault {
        Fault::TooTight { .. } => first(&[&keys::RADIUS, &keys::BANK]),
        Fault::TooSteep { .. } => keys::CLIMB_RATE.name,
        Fault::PushesOver { .. } | Fault::TooShort => first(&[&keys::BLEND]),
        _ => "",
    };
    let key = if key.is_empty() { first(&ACTIONS) } else { key };
    table.blame(key, complaint(fault))
}

/// A fault for people who write degrees.
pub fn complaint(fault: Fault) -> Complaint {
    let short = number::short;
    match fault {
        Fault::TooTight { least_radius } => Complaint::new(
            "turns too tightly for its speed",
            format!("a bank of at most 85°, a radius from {} m", short(1.001 * least_radius)),
        ),
        Fault::TooSteep { largest } => Complaint::new(
            "climbs too steeply for its speed",
            format!("at most {} m/s", short(0.999 * largest)),
        ),
        Fault::PushesOver { least_blend_s } => Complaint::new(
            "pushes over into weightlessness, where no bank is defined",
            format!("a blend_s from {}", short(1.001 * least_blend_s)),
        ),
        Fault::AtRest => {
            Complaint::new("moves at speed 0", "an accelerate_to_m_s before it, or a rotate_deg")
        }
        Fault::Angle => Complaint::new(
            "has an angle out of range",
            "a latitude from -90 to 90 degrees, a longitude and a course from -360 to 360",
        ),
        other => Complaint::new(other.to_string(), ""),
    }
}
