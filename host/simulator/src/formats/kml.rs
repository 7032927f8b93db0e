//! KML: the path as lines at its height, its way-points as points.

use super::track::{Spot, Track};
use kml::types::{AltitudeMode, Coord, Geometry, LineString, MultiGeometry, Placemark, Point};
use kml::{Kml, KmlDocument, KmlVersion, KmlWriter};
use std::io;

fn coordinates(spot: &Spot) -> Coord {
    Coord::new(spot.longitude_deg, spot.latitude_deg, Some(spot.altitude_m))
}

fn line(part: &[Spot]) -> Geometry {
    Geometry::LineString(LineString {
        coords: part.iter().map(coordinates).collect(),
        altitude_mode: AltitudeMode::Absolute,
        ..LineString::default()
    })
}

fn point(index: usize, spot: &Spot) -> Kml {
    let at = Point {
        coord: coordinates(spot),
        altitude_mode: AltitudeMode::Absolute,
        ..Point::default()
    };
    Kml::Placemark(Placemark {
        name: Some((index + 1).to_string()),
        description: Some(format!("{} s", spot.time_s)),
        geometry: Some(Geometry::Point(at)),
        ..Placemark::default()
    })
}

/// The text of a file.
///
/// # Errors
///
/// Of the writer.
pub fn text(track: &Track) -> io::Result<String> {
    let lines = track.parts().iter().map(|part| line(part)).collect();
    let path = Placemark {
        name: Some(track.name.clone()),
        description: Some(track.title.clone()),
        geometry: Some(Geometry::MultiGeometry(MultiGeometry::new(lines))),
        ..Placemark::default()
    };
    let mut elements = vec![Kml::Placemark(path)];
    elements.extend(track.points.iter().enumerate().map(|(index, spot)| point(index, spot)));
    let namespace = ("xmlns".to_owned(), "http://www.opengis.net/kml/2.2".to_owned());
    let document = Kml::KmlDocument(KmlDocument {
        version: KmlVersion::V22,
        attrs: [namespace].into(),
        elements: vec![Kml::Document { attrs: Default::default(), elements }],
    });
    let mut text = b"<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n".to_vec();
    KmlWriter::from_writer(&mut text).write(&document).map_err(io::Error::other)?;
    String::from_utf8(text).map_err(io::Error::other)
}
