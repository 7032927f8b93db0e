//! GPX: the points of tracks, else of routes, else the way-points.

use super::{Fix, Track, place};
use crate::input::{Complaint, InputError};
use crate::recording::instant::Scale;
use ::gpx::Waypoint;
use time::OffsetDateTime;

/// All points of the first kind that there are any of.
pub fn read(file: &str, text: &str) -> Result<Track, InputError> {
    let document = ::gpx::read(text.as_bytes()).map_err(|error| {
        InputError::file(
            file,
            Complaint::new(format!("is no GPX that can be read: {error}"), "GPX 1.0 or 1.1"),
        )
    })?;
    let tracks = document.tracks.iter().flat_map(|track| &track.segments);
    let mut points: Vec<_> = tracks.flat_map(|segment| &segment.points).collect();
    if points.is_empty() {
        points = document.routes.iter().flat_map(|route| &route.points).collect();
    }
    if points.is_empty() {
        points = document.waypoints.iter().collect();
    }
    let fixes: Vec<_> =
        (1..).zip(&points).map(|(line, point)| fix(file, line, point)).collect::<Result<_, _>>()?;
    let mut said = Vec::new();
    if points.iter().any(|point| point.elevation.is_some() && point.geoidheight.is_none()) {
        said.push(format!("{file}: heights are above the geoid, whose own height it does not tell: taken as above the ellipsoid"));
    }
    let scale = fixes.iter().any(|fix| fix.time_s.is_some()).then_some(Scale::Utc);
    Ok(Track { scale, fixes, said, ..Track::default() })
}

fn fix(file: &str, line: u64, point: &Waypoint) -> Result<Fix, InputError> {
    let at = point.point();
    let time = point.time.map(OffsetDateTime::from);
    let seconds =
        |at: OffsetDateTime| at.unix_timestamp() as f64 + f64::from(at.nanosecond()) * 1e-9;
    Ok(Fix {
        time_s: time.map(seconds),
        height: point.elevation.map(|above| above + point.geoidheight.unwrap_or(0.0)),
        ..place(file, line, at.y(), at.x())?
    })
}
