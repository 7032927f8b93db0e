//! Positions that others measured: RTKLIB `.pos`, NMEA 0183, GPX and KML, as a reference or as way-points.
//!
//! | file | what |
//! |---|---|
//! | `rtklib` | `.pos`: position, velocity and their σ, GPS time or UTC |
//! | `nmea` | GGA and RMC: position, course and speed, UTC |
//! | `gpx`, `kml` | way-points, routes and tracks |

mod gpx;
mod kml;
mod nmea;
mod rtklib;

use crate::input::{Complaint, InputError, read_text};
use crate::recording::instant::Scale;
use schuler::math::vector::Vector;

/// A place that was measured or given.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Fix {
    /// Its line in the file, or its number from 1 where the file has no rows.
    pub line: u64,
    /// When, s, on the track's scale.
    pub time_s: Option<f64>,
    /// rad.
    pub latitude: f64,
    /// rad.
    pub longitude: f64,
    /// Above the ellipsoid, m.
    pub height: Option<f64>,
    /// Velocity north and east, m/s.
    pub north_east: Option<[f64; 2]>,
    /// Velocity down, m/s.
    pub down: Option<f64>,
    /// Standard deviations of the position north, east, down, m.
    pub position_sigma_ned: Option<Vector<f64>>,
    /// Standard deviations of the velocity north, east, down, m/s.
    pub velocity_sigma_ned: Option<Vector<f64>>,
}

/// Places in their order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Track {
    /// The file's name.
    pub name: String,
    /// What its times are counted from; absent where it has none, or times of day alone.
    pub scale: Option<Scale>,
    /// At least one.
    pub fixes: Vec<Fix>,
    /// What was found, a line each.
    pub said: Vec<String>,
    /// Lines that could not be read and were left out, in their order, and why.
    pub damaged: Vec<(u64, Complaint)>,
}

impl Track {
    /// From a file of any of the formats, by its content.
    pub fn read(file: &str) -> Result<Self, InputError> {
        Self::parse(file, &read_text(file)?)
    }

    /// From a text; `file` names it in errors.
    pub fn parse(file: &str, text: &str) -> Result<Self, InputError> {
        let read = reader(text).ok_or_else(|| {
            let accepted = "an RTKLIB .pos with latitude, longitude and height, NMEA 0183 with GGA or RMC, GPX, or KML";
            InputError::file(file, Complaint::new("is none of the files of positions", accepted))
        })?;
        let track = Self { name: file.to_owned(), ..read(file, text)? };
        if track.fixes.is_empty() {
            let complaint = Complaint::new("has no position", "one or more");
            return Err(InputError::file(file, complaint));
        }
        Ok(track)
    }

    /// Whether a text is of one of the formats.
    pub fn is_one(text: &str) -> bool {
        reader(text).is_some()
    }

    /// What could not be read next to a place: between those before and after it.
    pub fn damaged_about(&self, place: usize) -> Option<&(u64, Complaint)> {
        let line = |i: usize| self.fixes.get(i).map(|fix| fix.line);
        let after = place.checked_sub(1).and_then(line).unwrap_or(0);
        let before = line(place + 1).unwrap_or(u64::MAX);
        self.damaged.iter().find(|(line, _)| (after..before).contains(line))
    }

    /// Its times on another scale, if it has times of a scale at all.
    pub fn on(mut self, scale: Scale) -> Self {
        if let Some(own) = self.scale.replace(scale) {
            for fix in &mut self.fixes {
                fix.time_s = fix.time_s.map(|time_s| own.to(scale, time_s));
            }
        } else {
            self.scale = None;
        }
        self
    }
}

type Read = fn(&str, &str) -> Result<Track, InputError>;

/// What reads a text, by its first lines.
fn reader(text: &str) -> Option<Read> {
    let start = text.trim_start_matches('\u{feff}').trim_start();
    if start.starts_with('<') {
        let has = |tag: &str| start.contains(tag);
        return if has("<gpx") {
            Some(gpx::read)
        } else if has("<kml") {
            Some(kml::read)
        } else {
            None
        };
    }
    if rtklib::is_one(text) {
        Some(rtklib::read)
    } else {
        nmea::is_one(text).then_some(nmea::read as Read)
    }
}

/// An angle within its bounds, rad.
fn angle(value: f64, limit: f64, file: &str, line: u64, key: &str) -> Result<f64, InputError> {
    if value.abs() <= limit {
        return Ok(value.to_radians());
    }
    let complaint = Complaint::new(
        format!("{value} is out of range"),
        format!("degrees, from -{limit} to {limit}"),
    );
    Err(InputError::key(file, line, key, complaint))
}

/// Latitude and longitude in degrees, checked.
fn place(file: &str, line: u64, latitude: f64, longitude: f64) -> Result<Fix, InputError> {
    Ok(Fix {
        line,
        latitude: angle(latitude, 90.0, file, line, "latitude")?,
        longitude: angle(longitude, 360.0, file, line, "longitude")?,
        ..Fix::default()
    })
}
