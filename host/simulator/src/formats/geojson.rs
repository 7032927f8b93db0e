//! GeoJSON (RFC 7946): the path as lines, its way-points as points.

use super::track::{Spot, Track};
use serde_json::{Value, json};

fn position(spot: &Spot) -> Value {
    json!([spot.longitude_deg, spot.latitude_deg, spot.altitude_m])
}

/// The text of a file.
pub fn text(track: &Track) -> String {
    let parts = track.parts();
    let lines: Vec<Vec<Value>> =
        parts.iter().map(|part| part.iter().map(position).collect()).collect();
    let times: Vec<Vec<f64>> =
        parts.iter().map(|part| part.iter().map(|spot| spot.time_s).collect()).collect();
    let path = json!({
        "type": "Feature",
        "properties": { "name": track.name, "title": track.title, "times_s": times },
        "geometry": { "type": "MultiLineString", "coordinates": lines },
    });
    let point = |(index, spot): (usize, &Spot)| {
        json!({
            "type": "Feature",
            "properties": { "name": (index + 1).to_string(), "time_s": spot.time_s },
            "geometry": { "type": "Point", "coordinates": position(spot) },
        })
    };
    let mut features = vec![path];
    features.extend(track.points.iter().enumerate().map(point));
    let mut text = json!({ "type": "FeatureCollection", "features": features }).to_string();
    text.push('\n');
    text
}
