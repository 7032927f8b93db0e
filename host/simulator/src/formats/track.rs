//! A path as maps take it: degrees and metres, cut where it crosses the antimeridian.
//!
//! Heights are those above the ellipsoid. Many maps take them for heights above the sea, which differ by the geoid's
//! undulation, up to 107 m.

use crate::units::DEGREE;
use schuler::earth::Geodetic;

/// A place at a time, in degrees and m.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spot {
    /// s.
    pub time_s: f64,
    /// From -90 to 90.
    pub latitude_deg: f64,
    /// From -180 to 180.
    pub longitude_deg: f64,
    /// Above the ellipsoid.
    pub altitude_m: f64,
}

/// A path with its name and its way-points.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Track {
    /// In a word.
    pub name: String,
    /// In a line.
    pub title: String,
    /// Along the path, in the order of time.
    pub spots: Vec<Spot>,
    /// What it was made to pass.
    pub points: Vec<Spot>,
}

impl Spot {
    /// Of a place in rad.
    pub fn new(time_s: f64, place: &Geodetic<f64>) -> Self {
        let degrees = place.longitude / DEGREE;
        // Whole turns away, and −0 with them.
        let longitude_deg = degrees - 360.0 * (degrees / 360.0).round();
        Self {
            time_s,
            latitude_deg: place.latitude / DEGREE,
            longitude_deg,
            altitude_m: place.altitude,
        }
    }
}

impl Track {
    /// Its parts on this and that side of the antimeridian. A part ends and the next one begins at ±180°.
    pub fn parts(&self) -> Vec<Vec<Spot>> {
        let mut parts = Vec::new();
        let mut part: Vec<Spot> = Vec::new();
        for spot in &self.spots {
            if let Some(last) = part.last().copied()
                && (spot.longitude_deg - last.longitude_deg).abs() > 180.0
            {
                let [near, far] = crossing(&last, spot);
                part.push(near);
                parts.push(std::mem::replace(&mut part, vec![far]));
            }
            part.push(*spot);
        }
        parts.push(part);
        parts
    }
}

/// Where two places on either side of the antimeridian meet it, on the side of each.
fn crossing(last: &Spot, next: &Spot) -> [Spot; 2] {
    let side = 180f64.copysign(last.longitude_deg);
    let before = (side - last.longitude_deg).abs();
    let behind = (side + next.longitude_deg).abs();
    let share = if before + behind > 0.0 { before / (before + behind) } else { 0.5 };
    let between = |a: f64, b: f64| a + share * (b - a);
    let near = Spot {
        time_s: between(last.time_s, next.time_s),
        latitude_deg: between(last.latitude_deg, next.latitude_deg),
        longitude_deg: side,
        altitude_m: between(last.altitude_m, next.altitude_m),
    };
    [near, Spot { longitude_deg: -side, ..near }]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spot(latitude_deg: f64, longitude_deg: f64) -> Spot {
        Spot { latitude_deg, longitude_deg, ..Spot::default() }
    }

    #[test]
    fn a_track_is_cut_at_the_antimeridian() {
        let spots = vec![spot(10.0, 179.0), spot(20.0, -179.0), spot(30.0, -178.0)];
        let parts = Track { spots, ..Track::default() }.parts();
        assert_eq!(parts[0], [spot(10.0, 179.0), spot(15.0, 180.0)]);
        assert_eq!(parts[1], [spot(15.0, -180.0), spot(20.0, -179.0), spot(30.0, -178.0)]);
        let back = vec![spot(0.0, -179.5), spot(8.0, 178.5)];
        let parts = Track { spots: back, ..Track::default() }.parts();
        assert_eq!(parts[0][1], spot(2.0, -180.0));
        assert_eq!(parts[1][0], spot(2.0, 180.0));
    }

    #[test]
    fn longitudes_lie_within_half_a_turn() {
        let at = |degrees: f64| {
            let place = Geodetic { longitude: degrees * DEGREE, ..Geodetic::default() };
            Spot::new(0.0, &place).longitude_deg
        };
        assert!((at(190.0) + 170.0).abs() < 1e-12 && (at(-725.0) + 5.0).abs() < 1e-12);
    }
}
