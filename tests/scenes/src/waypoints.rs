//! A flight through way-points: `host/simulator/scenes/waypoints.toml`.

use crate::units::DEGREE;
use schuler::earth::Geodetic;
use schuler::trajectory::piecewise::Attitude;
use schuler::trajectory::spline::path::Path;
use schuler::trajectory::spline::{BAND, EXTRA, Ends};
use schuler::trajectory::waypoints::fault::WaypointError;
use schuler::trajectory::waypoints::through::through;

/// Samples per second.
pub const RATE_HZ: f64 = 20.0;
/// How many points there are.
pub const POINTS: usize = 20;
/// How the body lies along the path.
pub const ATTITUDE: Attitude = Attitude::Coordinated;

/// When each is passed, s.
pub const TIMES_S: [f64; POINTS] = [
    0.0, 92.0, 188.0, 276.0, 377.0, 471.0, 558.0, 657.0, 761.0, 852.0, 949.0, 1044.0, 1130.0,
    1223.0, 1326.0, 1424.0, 1514.0, 1603.0, 1699.0, 1800.0,
];

/// Each of them.
pub const PLACES: [Geodetic<f64>; POINTS] = [
    at(45.0, 100.0, 450.0),
    at(45.0661, 100.034, 850.0),
    at(45.1242, 100.1161, 1400.0),
    at(45.1487, 100.246, 2100.0),
    at(45.2497, 100.3662, 2900.0),
    at(45.2375, 100.5633, 3600.0),
    at(45.363, 100.6662, 4300.0),
    at(45.4079, 100.9048, 4900.0),
    at(45.2979, 101.1278, 5100.0),
    at(45.3989, 101.3328, 5100.0),
    at(45.3989, 101.612, 4900.0),
    at(45.2553, 101.7546, 4500.0),
    at(45.2291, 101.9652, 4100.0),
    at(45.3327, 102.1123, 3500.0),
    at(45.2804, 102.3162, 2900.0),
    at(45.172, 102.4236, 2300.0),
    at(45.1437, 102.5731, 1800.0),
    at(45.053, 102.6329, 1400.0),
    at(44.9947, 102.731, 1000.0),
    at(44.9178, 102.7704, 700.0),
];

/// Control points of the path.
pub type Control = [[f64; 4]; POINTS + EXTRA];

const fn at(latitude_deg: f64, longitude_deg: f64, altitude: f64) -> Geodetic<f64> {
    Geodetic { latitude: latitude_deg * DEGREE, longitude: longitude_deg * DEGREE, altitude }
}

/// The path through them, whose pieces are made one at a time.
pub fn path<'a>(
    times_s: &'a [f64; POINTS],
    control: &'a mut Control,
) -> Result<Path<'a>, WaypointError> {
    let mut band = [[0.0; BAND]; POINTS + EXTRA];
    through(&PLACES, times_s, Ends::Natural, &mut band, control)
}
