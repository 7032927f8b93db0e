//! The path of a flight as a file.

use crate::cli::TrajectoryArgs;
use schuler::math::compensated::Pair;
use schuler::trajectory::Trajectory as _;
use schuler_simulator::course::Course;
use schuler_simulator::formats::mcap::{McapWriter, Motion};
use schuler_simulator::formats::track::{Spot, Track};
use schuler_simulator::formats::{geojson, gpx, kml};
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::output::{self, large_table, say_error};
use schuler_simulator::recording::navigation::{COLUMNS, NavigationRow, NavigationWriter};
use schuler_simulator::scene::Scene;
use schuler_simulator::scene::route::Origin;
use std::path::Path;

/// What a file is, by its ending.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// The columns of nav.csv.
    Csv,
    /// For maps.
    Kml,
    /// For maps and receivers.
    Gpx,
    /// For maps.
    Geojson,
    /// ROS 2 messages.
    Mcap,
}

/// Rows per second of a map.
const MAP_HZ: f64 = 1.0;

impl Format {
    /// By the ending of a file's name.
    pub fn of(path: &Path) -> Result<Self, InputError> {
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
        match ending.as_deref() {
            Some("csv") => Ok(Self::Csv),
            Some("kml") => Ok(Self::Kml),
            Some("gpx") => Ok(Self::Gpx),
            Some("geojson" | "json") => Ok(Self::Geojson),
            Some("mcap") => Ok(Self::Mcap),
            _ => {
                let what = format!("{} has no ending that says what it is", path.display());
                let accepted = ".csv, .kml, .gpx, .geojson, .mcap";
                Err(InputError::option("--out", Complaint::new(what, accepted)))
            }
        }
    }

    /// What is to be known about it.
    pub fn note(self) -> String {
        match self {
            Self::Csv => String::new(),
            Self::Mcap => "; Imu, NavSatFix, PoseStamped in axes of ROS, times from 0".to_owned(),
            Self::Kml | Self::Geojson => "; heights are above the ellipsoid".to_owned(),
            Self::Gpx => {
                let start = gpx::START_NAME;
                format!("; heights are above the ellipsoid, times count from {start}")
            }
        }
    }
}

/// Writes it: how many rows.
pub fn write(
    args: &TrajectoryArgs,
    scene: &Scene,
    course: &Course,
    path: &Path,
    format: Format,
) -> Result<u64, InputError> {
    let is_map = !matches!(format, Format::Csv | Format::Mcap);
    let own = if is_map { MAP_HZ.min(scene.rate_hz) } else { scene.rate_hz };
    let rate_hz = args.rate.unwrap_or(own);
    let last = (scene.duration_s * rate_hz * (1.0 + 1e-12)).floor() as u64;
    let row = |number: u64| {
        let time_s = number as f64 / rate_hz;
        let at = course.solution_at(schuler::imu::instant(number as f64, rate_hz));
        NavigationRow::new(time_s, &at)
    };
    if format == Format::Csv {
        if let Some(much) = large_table(path, last + 1, COLUMNS.len()) {
            say_error(&much);
        }
        let mut writer = NavigationWriter::create(path)?;
        for number in 0..=last {
            writer.row(&row(number))?;
        }
        writer.finish()?;
        return Ok(last + 1);
    }
    if format == Format::Mcap {
        return messages(course, path, last, rate_hz).map(|()| last + 1);
    }
    let mut spots: Vec<_> = (0..=last)
        .map(|number| {
            let row = row(number);
            Spot::new(row.time_s, &row.position)
        })
        .collect();
    if spots.last().is_some_and(|spot| spot.time_s < scene.duration_s) {
        let end = course.solution_at(Pair::new(scene.duration_s));
        let end = NavigationRow::new(scene.duration_s, &end);
        spots.push(Spot::new(end.time_s, &end.position));
    }
    let rows = spots.len() as u64;
    let track = Track {
        name: scene.name.clone(),
        title: scene.title.clone(),
        spots,
        points: points(scene),
    };
    let text = match format {
        Format::Csv | Format::Mcap | Format::Geojson => Ok(geojson::text(&track)),
        Format::Kml => kml::text(&track),
        Format::Gpx => gpx::text(&track),
    };
    let text = text.map_err(|error| fault(path, &error))?;
    output::write(path, text)?;
    Ok(rows)
}

/// State and perfect readings as messages.
fn messages(course: &Course, path: &Path, last: u64, rate_hz: f64) -> Result<(), InputError> {
    let mut writer = McapWriter::create(path)?;
    for number in 0..=last {
        let at = schuler::imu::instant(number as f64, rate_hz);
        let (state, time_s) = (course.solution_at(at), number as f64 / rate_hz);
        writer.rates(time_s, &course.rates_at(at), Some(&state))?;
        writer.state(Motion::Truth, time_s, &state)?;
    }
    writer.into_file()?.finish()
}

fn fault(path: &Path, error: &dyn std::fmt::Display) -> InputError {
    let what = format!("cannot be written: {error}");
    InputError::file(&path.display().to_string(), Complaint::new(what, ""))
}

/// The scene's way-points.
fn points(scene: &Scene) -> Vec<Spot> {
    match scene.trajectory.route.as_deref().map(|route| &route.from) {
        Some(Origin::Waypoints { points, .. }) => {
            points.iter().map(|(time_s, place)| Spot::new(*time_s, place)).collect()
        }
        _ => Vec::new(),
    }
}
