//! A map from its TOML.

use super::super::instant::Scale;
use super::super::mounting::Mounting;
use super::super::reduction::Known;
use super::dialect::Delimiter;
use super::dialect::Text;
use super::map::{Column, Columns, Map, Time, Triad};
use crate::input::document::{Document, Section, Value};
use crate::input::{Complaint, InputError, Range};
use crate::rest::units::{Units, kind_of};
use crate::scene::limits::RATE_HZ;
use crate::units::{DEGREE_PER_HOUR, MICRO_G, PART_PER_MILLION};
use schuler::alignment::units::Kind;
use schuler::math::vector::Vector;

const ROOT: [&str; 13] = [
    "title",
    "samples",
    "delimiter",
    "comment",
    "skip_lines",
    "fields",
    "header",
    "axes",
    "mounting",
    "time",
    "gyro",
    "accelerometer",
    "sensor",
];
const TIME: [&str; 7] = ["column", "columns", "unit", "rate_hz", "scale", "rollovers", "file"];
const TRIAD: [&str; 5] = ["columns", "unit", "file", "rows", "reads"];
const KINDS: &[(&str, Kind)] = &[("increments", Kind::Increments), ("rates", Kind::Rates)];
const COLUMN: &str = "a column's name, or its number from 1";

/// From a map's text; `file` names it in errors.
pub fn map(file: &str, text: &str) -> Result<Map, InputError> {
    let document = Document::parse(file, text)?;
    let root = document.root(&ROOT)?;
    let mut map = Map { name: file.to_owned(), ..Map::default() };
    map.title = root.get("title").map_or(Ok(""), |title| title.text("text"))?.to_owned();
    map.text = Text {
        delimiter: choice(&root, "delimiter", Delimiter::NAMES)?,
        comment: root.get("comment").map(|c| c.text("text").map(str::to_owned)).transpose()?,
        skip_lines: root.get("skip_lines").map_or(Ok(0), |lines| lines.integer(0, 1_000_000))?,
    };
    let fields = root.get("fields").map(|fields| fields.integer(1, 10_000)).transpose()?;
    map.fields = fields.map(|fields| fields as usize);
    map.header = root.get("header").map_or(Ok(Vec::new()), |names| columns(&names))?;
    map.units.kind = choice(&root, "samples", KINDS)?;
    map.mounting = mounting(&root)?;
    if let Some(section) = root.section("time", &TIME)? {
        map.time = time(&section, &mut map.units)?;
    }
    let mut kinds = Vec::new();
    for (key, triad) in [("gyro", &mut map.gyro), ("accelerometer", &mut map.accelerometer)] {
        let Some(section) = root.section(key, &TRIAD)? else { continue };
        *triad = self::triad(&section)?;
        if let Some(unit) = section.get("unit") {
            let word = unit.text("a unit")?;
            let units = Units::parse(word).map_err(|complaint| unit.error(complaint))?;
            let (mine, theirs) = match key {
                "gyro" => (units.rate.is_some(), units.force),
                _ => (units.force.is_some(), None),
            };
            if !mine || theirs.is_some() {
                let complaint =
                    Complaint::new(format!("\"{word}\" is no unit of a {key}"), Units::accepted());
                return Err(unit.error(complaint));
            }
            map.units = map.units.or(units);
            kinds.push((kind_of(word), unit));
        }
        if key == "accelerometer" {
            let reads = choice(&section, "reads", &[("specific-force", false), ("gravity", true)])?;
            map.reversed = reads.unwrap_or(false);
        }
    }
    match (map.gyro.columns.is_empty(), map.accelerometer.columns.is_empty()) {
        (true, false) => drop(root.require("gyro", "a table with columns, as for accelerometers")?),
        (false, true) => drop(root.require("accelerometer", "a table with columns, as for gyros")?),
        (false, false) if map.time.columns.is_empty() && map.time.rate_hz.is_none() => {
            root.require("time", "a table with a column, or with rate_hz")?;
        }
        _ => {}
    }
    // A unit per second is one of rates.
    for (kind, unit) in kinds {
        if map.units.kind.is_some_and(|stated| stated != kind) {
            let what = "is no unit of such samples";
            let accepted = "per second for rates, without it for increments, alike for both";
            return Err(unit.error(Complaint::new(what, accepted)));
        }
        map.units.kind = Some(kind);
    }
    map.known = known(&root)?;
    Ok(map)
}

impl Columns {
    /// From names or numbers with commas between.
    pub fn parse(text: &str) -> Result<Self, Complaint> {
        let columns: Vec<_> = text.split(',').map(str::trim).map(column).collect();
        let count = columns.len();
        columns.try_into().map(Self).map_err(|_| {
            let accepted =
                "seven: time, gyros x, y, z, accelerometers x, y, z, by name or number from 1";
            Complaint::new(format!("has {count} columns"), accepted)
        })
    }
}

fn column(text: &str) -> Column {
    match text.parse() {
        Ok(number) if number > 0 => Column::Number(number),
        _ => Column::Name(text.to_owned()),
    }
}

fn columns(value: &Value) -> Result<Vec<Column>, InputError> {
    let one = |value: &Value| {
        if value.is_text() {
            Ok(Column::Name(value.text(COLUMN)?.to_owned()))
        } else {
            Ok(Column::Number(value.integer(1, 10_000)? as usize))
        }
    };
    value.items("an array of columns")?.iter().map(one).collect()
}

fn choice<T: Copy>(
    section: &Section,
    key: &str,
    names: &[(&str, T)],
) -> Result<Option<T>, InputError> {
    section.get(key).map(|value| value.choice(names)).transpose()
}

fn time(section: &Section, units: &mut Units) -> Result<Time, InputError> {
    let single = section.get("column").map(|value| {
        if value.is_text() {
            value.text(COLUMN).map(|name| Column::Name(name.to_owned()))
        } else {
            value.integer(1, 10_000).map(|number| Column::Number(number as usize))
        }
    });
    let several = section.get("columns");
    let columns = match (single.transpose()?, several) {
        (Some(one), None) => vec![one],
        (None, None) => Vec::new(),
        (None, Some(value)) => {
            let columns = columns(&value)?;
            if !(1..=2).contains(&columns.len()) {
                let what = format!("has {} columns", columns.len());
                let accepted =
                    "one or two: week and seconds, date and time, seconds and nanoseconds";
                return Err(value.error(Complaint::new(what, accepted)));
            }
            columns
        }
        (Some(_), Some(value)) => {
            let what = "stands beside `column`";
            return Err(value.error(Complaint::new(what, "one of them")));
        }
    };
    if let Some(unit) = section.get("unit") {
        let accepted = "\"s\", \"ms\", \"us\", \"ns\", \"iso8601\", \"gps-week\"";
        let word = unit.text(accepted)?;
        let parsed = Units::parse(word).ok().and_then(|units| units.time);
        let wrong =
            || unit.error(Complaint::new(format!("\"{word}\" is no unit of time"), accepted));
        units.time = Some(parsed.ok_or_else(wrong)?);
    }
    let rate_hz = section.get("rate_hz").map(|rate| rate.number(&RATE_HZ)).transpose()?;
    if columns.is_empty() && rate_hz.is_none() {
        section.require("column", COLUMN)?;
    }
    Ok(Time {
        columns,
        rate_hz,
        scale: choice(section, "scale", Scale::NAMES)?,
        rollovers: section.get("rollovers").map_or(Ok(0), |n| n.integer(0, 100))?,
        file: section.get("file").map(|f| f.text("a file").map(str::to_owned)).transpose()?,
    })
}

fn triad(section: &Section) -> Result<Triad, InputError> {
    let value = section.require("columns", "three columns: x, y, z")?;
    let columns = columns(&value)?;
    if columns.len() != 3 {
        let what = format!("has {} columns", columns.len());
        return Err(value.error(Complaint::new(what, "three: x, y, z")));
    }
    let files = match section.get("file") {
        None => Vec::new(),
        Some(file) if file.is_text() => vec![file.text("a file")?.to_owned()],
        Some(files) => {
            let files = files.items("a file, or an array of such")?;
            files.iter().map(|f| f.text("a file").map(str::to_owned)).collect::<Result<_, _>>()?
        }
    };
    let rows = section.get("rows").map(|rows| rows.text("text").map(str::to_owned)).transpose()?;
    Ok(Triad { columns, files, rows })
}

fn mounting(root: &Section) -> Result<Option<Mounting>, InputError> {
    let axes = root.get("axes").map(|value| {
        let text = value.text("axes such as \"forward-left-up\"")?;
        Mounting::parse(text).map_err(|complaint| value.error(complaint))
    });
    let matrix = root.get("mounting").map(|value| {
        let accepted = "three rows of three numbers";
        let rows = value.items(accepted)?;
        let rows: Vec<_> =
            rows.iter().map(|row| row.axes(&Range::FINITE)).collect::<Result<_, _>>()?;
        let wrong = || value.error(Complaint::new(format!("has {} rows", rows.len()), accepted));
        let rows = rows.as_slice().try_into().map_err(|_| wrong())?;
        Mounting::new(rows).map_err(|complaint| value.error(complaint))
    });
    match (axes.transpose()?, matrix.transpose()?) {
        (Some(_), Some(_)) => {
            let value = root.require("mounting", "")?;
            Err(value.error(Complaint::new("stands beside `axes`", "one of them")))
        }
        (axes, matrix) => Ok(axes.or(matrix)),
    }
}

fn known(root: &Section) -> Result<Option<[Known; 2]>, InputError> {
    let Some(sensor) = root.section("sensor", &["gyro", "accelerometer"])? else { return Ok(None) };
    let mut known = [Known::default(); 2];
    let parts =
        [("gyro", "constant_deg_h", DEGREE_PER_HOUR), ("accelerometer", "constant_ug", MICRO_G)];
    for ((key, bias, unit), known) in parts.into_iter().zip(&mut known) {
        let Some(section) = sensor.section(key, &[bias, "scale_factor_ppm"])? else { continue };
        if let Some(value) = section.get(bias) {
            known.bias = Vector::from(value.axes(&Range::FINITE)?) * unit;
        }
        if let Some(value) = section.get("scale_factor_ppm") {
            let range = Range::above(-1e6, 1e6, "ppm, above -1e6 and up to 1e6");
            known.scale_factor = Vector::from(value.axes(&range)?) * PART_PER_MILLION;
        }
    }
    Ok(Some(known))
}
