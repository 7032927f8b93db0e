//! KML: the coordinates of points, lines and tracks (`gx:Track`), in their order.

use super::{Fix, Track, place};
use crate::input::{Complaint, InputError};
use crate::recording::instant::{self, Scale};
use ::kml::types::{AltitudeMode, Coord, Element, Geometry};
use ::kml::{Kml, KmlReader};
use quick_xml::events::Event;

/// All coordinates.
pub fn read(file: &str, text: &str) -> Result<Track, InputError> {
    let refused = |what: String| InputError::file(file, Complaint::new(what, "KML 2.2 or 2.3"));
    // The reader waits for ever for the end of an element that has none.
    whole(text).map_err(|what| refused(format!("is no KML that can be read: {what}")))?;
    let document = KmlReader::<_, f64>::from_string(text)
        .read()
        .map_err(|error| refused(format!("is no KML that can be read: {error}")))?;
    let mut found = Found { file, fixes: Vec::new(), ground: false };
    found.walk(&document)?;
    let Found { fixes, ground, .. } = found;
    let mut said = Vec::new();
    if ground {
        said.push(format!(
            "{file}: heights are relative to the ground, which nobody tells: left out"
        ));
    }
    let scale = fixes.iter().any(|fix| fix.time_s.is_some()).then_some(Scale::Utc);
    Ok(Track { scale, fixes, said, ..Track::default() })
}

/// Whether every element ends.
fn whole(text: &str) -> Result<(), String> {
    let mut reader = quick_xml::Reader::from_str(text);
    let mut open = 0u64;
    loop {
        match reader.read_event().map_err(|error| error.to_string())? {
            Event::Start(_) => open += 1,
            Event::End(_) => open = open.saturating_sub(1),
            Event::Eof if open == 0 => return Ok(()),
            Event::Eof => return Err(format!("{open} elements do not end")),
            _ => {}
        }
    }
}

struct Found<'a> {
    file: &'a str,
    fixes: Vec<Fix>,
    /// Whether a height is relative to the ground.
    ground: bool,
}

impl Found<'_> {
    fn walk(&mut self, kml: &Kml) -> Result<(), InputError> {
        match kml {
            Kml::KmlDocument(document) => document.elements.iter().try_for_each(|e| self.walk(e)),
            Kml::Document { elements, .. } => elements.iter().try_for_each(|e| self.walk(e)),
            Kml::Folder(folder) => folder.elements.iter().try_for_each(|e| self.walk(e)),
            Kml::Placemark(placemark) => {
                placemark.geometry.iter().try_for_each(|geometry| self.geometry(geometry))?;
                placemark.children.iter().try_for_each(|child| self.element(child))
            }
            Kml::Point(point) => self.coord(&point.coord, point.altitude_mode),
            Kml::LineString(line) => {
                line.coords.iter().try_for_each(|c| self.coord(c, line.altitude_mode))
            }
            Kml::Element(element) => self.element(element),
            _ => Ok(()),
        }
    }

    fn geometry(&mut self, geometry: &Geometry) -> Result<(), InputError> {
        match geometry {
            Geometry::Point(point) => self.coord(&point.coord, point.altitude_mode),
            Geometry::LineString(line) => {
                line.coords.iter().try_for_each(|coord| self.coord(coord, line.altitude_mode))
            }
            Geometry::MultiGeometry(many) => {
                many.geometries.iter().try_for_each(|g| self.geometry(g))
            }
            Geometry::Element(element) => self.element(element),
            _ => Ok(()),
        }
    }

    fn coord(&mut self, coord: &Coord, mode: AltitudeMode) -> Result<(), InputError> {
        let line = self.fixes.len() as u64 + 1;
        let absolute = matches!(mode, AltitudeMode::Absolute);
        self.ground |= !absolute && coord.z.is_some_and(|z| z != 0.0);
        let height = coord.z.filter(|_| absolute);
        self.fixes.push(Fix { height, ..place(self.file, line, coord.y, coord.x)? });
        Ok(())
    }

    /// `gx:Track`: `when`s and `gx:coord`s in equal number; other elements are looked into.
    fn element(&mut self, element: &Element) -> Result<(), InputError> {
        let is = |element: &&Element, name: &str| element.name.rsplit(':').next() == Some(name);
        if !is(&element, "Track") {
            return element.children.iter().try_for_each(|child| self.element(child));
        }
        let of = |name: &'static str| {
            let children = element.children.iter().filter(move |child| is(child, name));
            children.map(|child| child.content.as_deref().unwrap_or_default().trim())
        };
        let absolute = of("altitudeMode").any(|mode| mode == "absolute");
        let whens: Vec<_> = of("when").collect();
        for (i, coord) in of("coord").enumerate() {
            let line = self.fixes.len() as u64 + 1;
            let numbers: Vec<f64> = coord.split_ascii_whitespace().flat_map(str::parse).collect();
            let [longitude, latitude, ref height @ ..] = numbers[..] else {
                let complaint =
                    Complaint::new(format!("\"{coord}\" is no place"), "longitude latitude height");
                return Err(InputError::key(self.file, line, "gx:coord", complaint));
            };
            let time_s = whens.get(i).map(|when| instant::date(when)).transpose();
            let time_s = time_s.map_err(|c| InputError::key(self.file, line, "when", c))?;
            self.ground |= !absolute && height.first().is_some_and(|height| *height != 0.0);
            let height = height.first().copied().filter(|_| absolute);
            self.fixes.push(Fix { time_s, height, ..place(self.file, line, latitude, longitude)? });
        }
        Ok(())
    }
}
