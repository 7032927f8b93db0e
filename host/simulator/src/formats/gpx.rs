//! GPX 1.1: the path as a track, its way-points as way-points.

use super::track::{Spot, Track};
use geo_types::Point;
use gpx::{Gpx, GpxVersion, Metadata, TrackSegment, Waypoint};
use std::io;
use time::{Duration, OffsetDateTime};

/// A flight has no date; a file must have one for its speeds to be known.
const START: i64 = 946_684_800;
/// The same for people.
pub const START_NAME: &str = "2000-01-01T00:00:00Z";

fn point(spot: &Spot) -> io::Result<Waypoint> {
    let start = OffsetDateTime::from_unix_timestamp(START).map_err(io::Error::other)?;
    let mut point = Waypoint::new(Point::new(spot.longitude_deg, spot.latitude_deg));
    point.elevation = Some(spot.altitude_m);
    let time = start.checked_add(Duration::seconds_f64(spot.time_s));
    point.time = time.map(gpx::Time::from);
    Ok(point)
}

/// The text of a file.
///
/// # Errors
///
/// Of the writer.
pub fn text(track: &Track) -> io::Result<String> {
    let points = track.spots.iter().map(point).collect::<io::Result<_>>()?;
    let mut waypoints = Vec::new();
    for (index, spot) in track.points.iter().enumerate() {
        let mut waypoint = point(spot)?;
        waypoint.name = Some((index + 1).to_string());
        waypoints.push(waypoint);
    }
    let description =
        format!("{}. Heights are above the ellipsoid; times count from {START_NAME}.", track.title);
    let metadata = Metadata {
        name: Some(track.name.clone()),
        description: Some(description),
        ..Metadata::default()
    };
    let path = gpx::Track {
        name: Some(track.name.clone()),
        segments: vec![TrackSegment { points }],
        ..gpx::Track::default()
    };
    let file = Gpx {
        version: GpxVersion::Gpx11,
        creator: Some("schuler".to_owned()),
        metadata: Some(metadata),
        waypoints,
        tracks: vec![path],
        routes: Vec::new(),
    };
    let mut text = Vec::new();
    gpx::write(&file, &mut text).map_err(io::Error::other)?;
    String::from_utf8(text).map_err(io::Error::other)
}
