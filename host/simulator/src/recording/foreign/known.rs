//! Maps of formats that are known, one TOML file each in `host/simulator/formats`, and how a file is recognised.

use super::dialect::Delimiter;
use super::head::Head;
use super::look::{Look, likely_unit};
use super::map::{Column, Map};
use super::parse;
use super::parts::{Parts, Source};
use crate::input::InputError;
use schuler::alignment::units::ForceUnit;

macro_rules! formats {
    ($($name:literal),+ $(,)?) => {
        &[$(($name, include_str!(concat!("../../../formats/", $name, ".toml")))),+]
    };
}

/// Name and text of each.
const FORMATS: &[(&str, &str)] = formats![
    "schuler-increments",
    "schuler-rates",
    "kf-gins",
    "gnss-ins-sim",
    "euroc",
    "ros",
    "ros2",
    "rosbag",
    "navego",
    "fusion",
    "x-imu3",
    "sensor-logger",
    "gnss-logger",
    "phyphox",
];

/// The names, for people.
pub fn names() -> String {
    let names: Vec<_> = FORMATS.iter().map(|(name, _)| *name).collect();
    names.join(", ")
}

/// All of them.
pub fn all() -> impl Iterator<Item = Map> {
    FORMATS.iter().map(|&(name, text)| load(name, text))
}

/// The one of a name.
pub fn map(name: &str) -> Option<Map> {
    let found = FORMATS.iter().find(|format| format.0 == name);
    found.map(|&(name, text)| load(name, text))
}

fn load(name: &str, text: &str) -> Map {
    match parse::map(&format!("{name}.toml"), text) {
        Ok(map) => Map { name: name.to_owned(), ..map },
        // The text is part of the program, and a test reads every one.
        Err(error) => unreachable!("{error}"),
    }
}

/// Of the maps with named columns, the one whose columns a header has, the most of them if several do.
pub fn by_header(head: &Head) -> Option<Map> {
    let matched = |map: &Map| {
        let sets = map.named();
        let fits = |set: &&Vec<&Column>| !set.is_empty() && head.has(set);
        sets.iter().filter(fits).map(Vec::len).max()
    };
    all()
        .filter_map(|map| matched(&map).map(|count| (count, map)))
        .max_by_key(|(n, _)| *n)
        .map(|f| f.1)
}

/// Of the maps for files without a header, the first that makes gravity of what the accelerometers read.
pub fn by_numbers(source: &Source, head: &Head) -> Result<Option<Map>, InputError> {
    for map in all().filter(|map| map.fields == Some(head.first.len())) {
        if map.text.delimiter.is_some_and(|own: Delimiter| own != head.delimiter) {
            continue;
        }
        let Some(look) = Parts::open(source, &map).and_then(|parts| Look::at(&parts))? else {
            continue;
        };
        let unit_s = map.units.time.map_or_else(|| likely_unit(look.step), |unit| unit.counted().1);
        let unit = map.units.force.unwrap_or(ForceUnit::MetrePerSecondSquared);
        let guess = map.units.kind.map(|kind| (unit, kind));
        let down = map.mounting.is_none_or(|mounting| mounting.turn(look.direction()).z < -0.5);
        let fits =
            guess.is_some_and(|guess| !look.gravity(look.step * unit_s, &[guess]).is_empty());
        if fits && down && look.step > 0.0 {
            return Ok(Some(map));
        }
    }
    Ok(None)
}

/// The one whose files a folder has.
pub fn by_folder(source: &Source) -> Option<Map> {
    let folder = source.folder();
    all().find(|map| {
        let there = |files: &[String]| files.iter().any(|file| folder.join(file).is_file());
        there(&map.gyro.files) && there(&map.accelerometer.files)
    })
}

impl Map {
    /// The names of its files; none where it has but one.
    pub(super) fn files(&self) -> Vec<&str> {
        let triads = self.gyro.files.iter().chain(&self.accelerometer.files);
        self.time.file.iter().chain(triads).map(String::as_str).collect()
    }

    /// The columns that each of its files must have, where they are named.
    fn named(&self) -> Vec<Vec<&Column>> {
        if self.fields.is_some() {
            return Vec::new();
        }
        let [time, gyro, accelerometer] =
            [&self.time.columns, &self.gyro.columns, &self.accelerometer.columns].map(|c| c.iter());
        let together = self.gyro.files == self.accelerometer.files
            && self.gyro.rows == self.accelerometer.rows;
        let mut sets: Vec<Vec<&Column>> = match (&self.time.file, together) {
            (Some(_), _) => vec![time.collect(), gyro.collect(), accelerometer.collect()],
            (None, true) => vec![time.chain(gyro).chain(accelerometer).collect()],
            (None, false) => {
                vec![time.clone().chain(gyro).collect(), time.chain(accelerometer).collect()]
            }
        };
        sets.iter_mut().for_each(|set| set.extend(&self.header));
        sets
    }
}
