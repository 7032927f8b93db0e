//! Logs that others wrote, read by a map of their columns, units and axes.
//!
//! | file | what |
//! |---|---|
//! | `map`, `parse` | what a map says, and its TOML |
//! | `dialect`, `head`, `table` | lines, what stands above them, the rows of one file |
//! | `parts`, `merge` | several files: row by row, or interpolated to one clock |
//! | `known`, `names`, `find` | formats that are known, names that speak for themselves, numbers that do |
//! | `look`, `settle` | what gravity and the Earth's rate tell of units and axes |

mod dialect;
mod find;
mod head;
pub mod known;
mod look;
pub mod map;
mod merge;
mod names;
mod parse;
mod parts;
mod settle;
mod table;

pub use map::{Columns, Given};
pub use parse::map as parse;
pub(super) use parts::{Parts, PartsReader};

use super::instant::Scale;
use super::reduction::Reduction;
use super::{Kind, csv};
use crate::input::name::path_of;
use crate::input::{Complaint, InputError, read_text};
use crate::rest::units::TimeUnit;
use crate::units::{DEGREE_PER_HOUR, MICRO_G, PART_PER_MILLION};
use dialect::Text;
use head::Head;
use look::Look;
use map::Map;
use parts::Source;
use std::fs::File;
use std::path::Path;

/// A log that is open.
#[derive(Debug)]
pub(super) struct Opened {
    pub parts: Parts,
    pub reduction: Reduction,
    pub kind: Kind,
    /// How its times are written; absent where their look decides.
    pub time: Option<TimeUnit>,
    pub scale: Option<Scale>,
    pub interval_s: Option<f64>,
    /// What was found, a line each.
    pub said: Vec<String>,
}

/// Opens a log, a file or a folder of files.
pub(super) fn open(name: &str, file: Option<&File>, given: &Given) -> Result<Opened, InputError> {
    let source = Source { name, file };
    let (mut map, mut said) = choose(&source, given)?;
    given.apply(&mut map);
    let parts = Parts::open(&source, &map)?;
    let settled = map.units.kind.is_some() && map.units.force.is_some() && map.units.rate.is_some();
    let look = if settled && map.mounting.is_some() { None } else { Look::at(&parts)? };
    said.extend(settle::settle(parts.name(), look.as_ref(), &mut map)?);
    said.extend(together(&parts, &map)?);
    said.extend(corrected(&map));
    let reduction = Reduction {
        units: map.units,
        mounting: map.mounting,
        known: map.known,
        reversed: map.reversed,
    };
    let interval_s = map.time.columns.is_empty().then_some(map.time.rate_hz).flatten();
    Ok(Opened {
        parts,
        reduction,
        kind: map.units.kind.unwrap_or(Kind::Rates),
        time: map.units.time,
        scale: scale(&map),
        interval_s: interval_s.map(|rate_hz| 1.0 / rate_hz),
        said,
    })
}

/// The map to read by, and what to say of it.
fn choose(source: &Source, given: &Given) -> Result<(Map, Vec<String>), InputError> {
    let name = source.name;
    if let Some(map) = &given.map {
        let map = stated(map)?;
        if !map.gyro.columns.is_empty() {
            return Ok((map, Vec::new()));
        }
        // Without columns it adds to a format that is known.
        let units = given.units.or(map.units);
        let (known, said) = choose(source, &Given { map: None, units, ..given.clone() })?;
        return Ok((map.or(known), said));
    }
    if given.columns.is_some() {
        return Ok((Map::default(), Vec::new()));
    }
    let known = |map: Map| {
        let said = format!("{name}: {}", map.title);
        Ok((map, vec![said]))
    };
    let Some(file) = source.file else {
        return known::by_folder(source).map_or_else(
            || {
                let accepted =
                    format!("a file, or a folder of a known format ({})", known::names());
                Err(InputError::file(name, Complaint::new("is a folder", accepted)))
            },
            known,
        );
    };
    let head = Head::of(name, file, &Text::default(), None)?;
    if let Some(map) = known::by_header(&head) {
        let files = map.files();
        let own =
            Path::new(name).file_name().is_some_and(|own| files.iter().any(|file| own == *file));
        if !files.is_empty() && !own {
            let what = format!("is a part of {}, under a name of its own", map.title);
            let accepted = format!("{}, or a map (--map) that names the files", files.join(", "));
            return Err(InputError::file(name, Complaint::new(what, accepted)));
        }
        return known(map);
    }
    if let Some(map) = known::by_numbers(source, &head)? {
        return known(map);
    }
    if let Some((map, said)) = names::columns(&head) {
        return Ok((map, vec![said]));
    }
    match find::columns(&head, file, given)? {
        Ok((map, said)) => Ok((map, vec![said])),
        Err(Complaint { what, accepted }) => {
            let what = format!("the header is none that is known, and {what}");
            let accepted =
                format!("{}; {accepted}; or the header of {}", csv::accepted(), known::names());
            Err(InputError::line(name, head.begins.1.max(1), Complaint::new(what, accepted)))
        }
    }
}

/// The map of a file or of a built-in name.
fn stated(name: &str) -> Result<Map, InputError> {
    match known::map(name) {
        Some(map) => Ok(map),
        None if path_of(name).is_file() => parse::map(name, &read_text(name)?),
        None => {
            let what = format!("there is no \"{name}\"");
            let accepted = format!("a TOML file, or one of {}", known::names());
            Err(InputError::option("--map", Complaint::new(what, accepted)))
        }
    }
}

/// What the times of a log are counted from.
fn scale(map: &Map) -> Option<Scale> {
    let by_unit = match map.units.time {
        Some(TimeUnit::GpsWeek) => Some(Scale::Gps),
        Some(TimeUnit::Iso8601) => Some(Scale::Utc),
        _ => None,
    };
    map.time.scale.or(by_unit)
}

/// How sensors with clocks of their own are brought together.
fn together(parts: &Parts, map: &Map) -> Result<Option<String>, InputError> {
    let Parts::Merged(merged) = parts else { return Ok(None) };
    let Some(unit) = map.units.time else {
        let what = "is not said, and two sensors are to be brought to one clock";
        let error = InputError::file(&map.name, Complaint::new(what, "a unit of time in the map"));
        return Err(InputError { key: Some("time.unit".to_owned()), ..error });
    };
    let rate = |step: f64| 1.0 / (step * unit.counted().1);
    let [kept, interpolated] = merged.steps.map(rate);
    let (slower, faster) =
        if merged.gyro_kept { ("accelerometers", "gyros") } else { ("gyros", "accelerometers") };
    Ok(Some(format!(
        "{}: {slower} (about {interpolated:.1} Hz) are interpolated by cubics to the times of the {faster} (about {kept:.1} Hz)",
        merged.interpolated.name
    )))
}

/// Which known errors are taken away.
fn corrected(map: &Map) -> Option<String> {
    let [gyro, accelerometer] = map.known.as_ref()?;
    let list = |vector: schuler::math::vector::Vector<f64>, unit: f64| {
        let numbers = vector.into_array().map(|value| crate::number::parameter(value / unit));
        numbers.join(", ")
    };
    Some(format!(
        "{}: taken away over the unit's own axes: gyros {} °/h and {} ppm, accelerometers {} µg and {} ppm",
        map.name,
        list(gyro.bias, DEGREE_PER_HOUR),
        list(gyro.scale_factor, PART_PER_MILLION),
        list(accelerometer.bias, MICRO_G),
        list(accelerometer.scale_factor, PART_PER_MILLION),
    ))
}
