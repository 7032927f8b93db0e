//! The tracks on the ground: the true one and the computed one.

use super::largest;
use schuler::earth::Geodetic;
use schuler_report::axis::Axis;
use schuler_report::canvas::{Ink, Stroke};
use schuler_report::chart::{Chart, Curve, Mark};
use schuler_simulator::flight::Instant;

/// Of the sphere on which distances from the start are measured, km.
const EARTH_RADIUS_KM: f64 = 6371.0;

/// A computed track is drawn over the true one.
const COMPUTED: Stroke = Stroke { width: 1.4, dashed: true };

/// The ground tracks: east and north of the start along great circles, so that distance and
/// bearing from there are true anywhere on Earth.
pub fn ground_track(instants: &[Instant]) -> Chart {
    let start = instants.first().map_or([0.0; 3], |instant| instant.position);
    let track: Vec<[f64; 2]> = instants.iter().map(|i| east_north_km(start, i.position)).collect();
    let far = largest(track.iter().flatten().copied());
    let (unit, per_km) = if far < 2.0 { ("m", 1000.0) } else { ("km", 1.0) };
    let scaled = |track: &[[f64; 2]]| -> Vec<[f64; 2]> {
        track.iter().map(|point| point.map(|x| x * per_km)).collect()
    };
    let points = scaled(&track);
    let computed = instants.iter().map(|instant| {
        let Geodetic { latitude, longitude, .. } = instant.computed.position;
        let [latitude, longitude] = [latitude, longitude].map(|angle| angle.hi.to_degrees());
        east_north_km(start, [latitude, longitude, 0.0])
    });
    let computed = scaled(&computed.collect::<Vec<_>>());
    let end = points.last().copied().unwrap_or_default();
    let mut marks = vec![Mark { name: format!("start {}", coordinates(start)), at: [0.0; 2] }];
    if let Some(last) = instants.last()
        && end[0].hypot(end[1]) > 0.1 * far * per_km
    {
        marks.push(Mark { name: format!("end {}", coordinates(last.position)), at: end });
    }
    let span = |label: &str, axis: usize| {
        Axis::spanning(
            &format!("{label} of the start, {unit}"),
            points.iter().chain(&computed).map(|p| p[axis]),
            true,
        )
    };
    Chart {
        title: format!("Ground tracks: north of the start, {unit}"),
        x: span("east", 0),
        y: span("north", 1),
        is_map: true,
        bands: Vec::new(),
        curves: vec![
            Curve { name: "true", ink: Ink::North, stroke: Stroke::solid(2.4), points },
            Curve { name: "computed", ink: Ink::East, stroke: COMPUTED, points: computed },
        ],
        marks,
    }
}

/// Distance times direction of the great circle from one place to another.
fn east_north_km(from: [f64; 3], to: [f64; 3]) -> [f64; 2] {
    let [lat0, lon0, _] = from.map(f64::to_radians);
    let [lat, lon, _] = to.map(f64::to_radians);
    let (half_lat, half_lon) = ((lat - lat0) / 2.0, (lon - lon0) / 2.0);
    let (east, turn) = (lat.cos() * (2.0 * half_lon).sin(), lat.cos() * half_lon.sin().powi(2));
    // sin c cos α = sin(φ − φ₀) + 2 sinφ₀ cosφ sin²(Δλ/2), sin c sin α = cosφ sin Δλ
    let north = (lat - lat0).sin() + 2.0 * lat0.sin() * turn;
    // hav c = sin²(Δφ/2) + cosφ₀ cosφ sin²(Δλ/2)
    let haversine = half_lat.sin().powi(2) + lat0.cos() * turn;
    let distance = 2.0 * EARTH_RADIUS_KM * haversine.sqrt().min(1.0).asin();
    match east.hypot(north) {
        0.0 => [0.0, 0.0],
        sine => [distance * east / sine, distance * north / sine],
    }
}

/// Latitude and longitude for people.
pub fn coordinates([latitude, longitude, _]: [f64; 3]) -> String {
    let longitude = (longitude + 180.0).rem_euclid(360.0) - 180.0;
    let side = |value: f64, positive, negative| if value < 0.0 { negative } else { positive };
    format!(
        "{:.3}° {} {:.3}° {}",
        latitude.abs(),
        side(latitude, "N", "S"),
        longitude.abs(),
        side(longitude, "E", "W")
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn great_circles_have_their_length_and_direction() {
        let quarter = EARTH_RADIUS_KM * std::f64::consts::FRAC_PI_2;
        let near =
            |a: [f64; 2], b: [f64; 2]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9 * quarter);
        assert!(near(east_north_km([0.0; 3], [0.0, 90.0, 0.0]), [quarter, 0.0]));
        assert!(near(east_north_km([0.0; 3], [90.0, 17.0, 0.0]), [0.0, quarter]));
        // Over the pole, and across the antimeridian.
        let over = east_north_km([80.0, 10.0, 0.0], [80.0, -170.0, 0.0]);
        assert!(near(over, [0.0, quarter * 20.0 / 90.0]), "{over:?}");
        let across = east_north_km([0.0, 179.0, 0.0], [0.0, -179.0, 0.0]);
        assert!(near(across, [quarter * 2.0 / 90.0, 0.0]), "{across:?}");
        // Anywhere: by the angle between two directions from the Earth's centre.
        let (from, to) = ([35.0, 20.0, 0.0], [-10.0, 140.0, 0.0]);
        let up = |[lat, lon, _]: [f64; 3]| {
            let ((s, c), (sl, cl)) = (lat.to_radians().sin_cos(), lon.to_radians().sin_cos());
            ([c * cl, c * sl, s], [-sl, cl, 0.0], [-s * cl, -s * sl, c])
        };
        let dot = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let ((origin, east, north), (target, ..)) = (up(from), up(to));
        let reach = EARTH_RADIUS_KM * dot(origin, target).acos();
        let (e, n) = (dot(east, target), dot(north, target));
        let expected = [e, n].map(|part| reach * part / e.hypot(n));
        assert!(near(east_north_km(from, to), expected), "{expected:?}");
        assert_eq!(east_north_km([45.0, 7.0, 0.0], [45.0, 7.0, 9.0]), [0.0, 0.0]);
    }

    #[test]
    fn places_have_their_side() {
        assert_eq!(coordinates([-33.5, 190.0, 0.0]), "33.500° S 170.000° W");
        assert_eq!(coordinates([60.0, 180.0 - 1e-9, 0.0]), "60.000° N 180.000° E");
    }
}
