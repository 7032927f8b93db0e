//! A spline through every way-point.
//!
//! n̂ and h are splines of degree 7 in time, the points their sites ([`interpolate`]). The times are
//! given, or come from speeds at the points by two passes: a leg takes its length over the mean of the speeds at its ends,
//! v = (vᵢ + vᵢ₊₁)/2, which is exact for a steady acceleration. The first pass takes the straight distance for
//! the length; the second one the arc ∫|ṙ|dt of the spline that the first pass made, by Gauss-Legendre quadrature with
//! four nodes a leg. So a leg has the speed that is asked for in its mean; at a point the spline decides.
//! Source: Hartley & Judd, Parametrization of Bézier-type B-spline curves and surfaces, *Computer-Aided Design*
//! 10 (1978) 130–134 (parameters from chords, then from arcs).
//!
//! ```
//! use schuler::earth::Geodetic;
//! use schuler::trajectory::spline::{BAND, EXTRA, Ends};
//! use schuler::trajectory::waypoints::through::times_from_speeds;
//!
//! // From rest to 20 m/s over 100 m of height: 10 s.
//! let at = |altitude| Geodetic { latitude: 0.7, longitude: 0.1, altitude };
//! let mut times_s = [0.0; 2];
//! let (mut band, mut control) = ([[0.0; BAND]; 2 + EXTRA], [[0.0; 4]; 2 + EXTRA]);
//! let speeds = [0.0, 20.0];
//! let points = [at(0.0), at(100.0)];
//! times_from_speeds(&points, &speeds, Ends::Natural, &mut times_s, &mut band, &mut control)?;
//! assert!((times_s[1] - 10.0).abs() < 1e-8);
//! # Ok::<(), schuler::trajectory::waypoints::fault::WaypointError>(())
//! ```

use super::fault::WaypointError;
use super::place::{check_path, check_places, check_speeds};
use crate::earth::Geodetic;
use crate::trajectory::spline::basis::Knots;
use crate::trajectory::spline::interpolate::interpolate;
use crate::trajectory::spline::path::{Path, Spline};
use crate::trajectory::spline::place::{Pace, channels, distance};
use crate::trajectory::spline::{BAND, EXTRA, Ends};

/// Abscissae and weights of Gauss-Legendre quadrature over ±1 with four nodes.
const NODES: [(f64, f64); 4] = [
    (-0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
    (-0.339_981_043_584_856_26, 0.652_145_154_862_546_1),
    (0.339_981_043_584_856_26, 0.652_145_154_862_546_1),
    (0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
];

/// The path through points (rad, rad, m) at times, s.
///
/// `band` and `control` must each have at least [`EXTRA`] more entries than there are points.
///
/// # Errors
///
/// [`WaypointError`] with the index of the point at fault.
pub fn through<'a>(
    points: &[Geodetic<f64>],
    times_s: &'a [f64],
    ends: Ends,
    band: &mut [[f64; BAND]],
    control: &'a mut [[f64; 4]],
) -> Result<Path<'a>, WaypointError> {
    check_places(points)?;
    if times_s.len() != points.len() {
        return Err(WaypointError::Count { needed: points.len() });
    }
    check_speeds(points, times_s)?;
    let path = spline(points, times_s, ends, band, control)?;
    check_path(&path)?;
    Ok(path)
}

fn spline<'a>(
    points: &[Geodetic<f64>],
    times_s: &'a [f64],
    ends: Ends,
    band: &mut [[f64; BAND]],
    control: &'a mut [[f64; 4]],
) -> Result<Path<'a>, WaypointError> {
    interpolate(times_s, points.iter().copied().map(channels), ends, band, control)?;
    let knots = Knots::eightfold(times_s);
    let spline = Spline { knots, control };
    Ok(Path::new(spline, spline, None)?)
}

/// Times, s, at which points are passed if the mean speed of each leg is that of its ends; the first time stays as it is.
///
/// # Errors
///
/// [`WaypointError`] with the index of the point at fault.
pub fn times_from_speeds(
    points: &[Geodetic<f64>],
    speeds_m_s: &[f64],
    ends: Ends,
    times_s: &mut [f64],
    band: &mut [[f64; BAND]],
    control: &mut [[f64; 4]],
) -> Result<(), WaypointError> {
    check_places(points)?;
    let needed = points.len();
    if speeds_m_s.len() != needed || times_s.len() != needed {
        return Err(WaypointError::Count { needed });
    }
    let room = needed + EXTRA;
    if band.len() < room || control.len() < room {
        return Err(WaypointError::NoRoom { needed: room });
    }
    for (index, speed) in speeds_m_s.iter().enumerate() {
        if !speed.is_finite() {
            return Err(WaypointError::NotFinite { index });
        }
        let first = index.saturating_sub(1);
        let before = speeds_m_s.get(first).copied().unwrap_or(0.0);
        if *speed < 0.0 || (index > 0 && before + speed <= 0.0) {
            return Err(WaypointError::Speed { index });
        }
    }
    let mean = |leg: usize| match speeds_m_s.get(leg..) {
        Some([from, to, ..]) => 0.5 * (from + to),
        _ => 1.0,
    };
    let straight = |leg: usize| match points.get(leg..) {
        Some([from, to, ..]) => distance(*from, *to),
        _ => 0.0,
    };
    fill(times_s, |leg| straight(leg) / mean(leg));
    check_speeds(points, times_s)?;
    let path = spline(points, times_s, ends, band, control)?;
    // Each arc is over the first pass's interval, which is needed until it is replaced.
    let room = band.iter_mut().map(|row| &mut row[..]);
    let lengths = room.filter_map(|row| row.first_mut());
    for (leg, place) in lengths.take(needed - 1).enumerate() {
        *place = path.piece(leg).map_or(0.0, |piece| {
            let half = 0.5 * (piece.end_s - piece.start_s);
            let speed = |node: f64| Pace::at(&piece, piece.middle_s + node * half).speed_m_s;
            NODES.iter().map(|(node, weight)| weight * half * speed(*node)).sum()
        });
    }
    let arc = |leg: usize| band.get(leg).and_then(|row| row.first()).copied().unwrap_or(0.0);
    fill(times_s, |leg| arc(leg) / mean(leg));
    check_speeds(points, times_s)
}

/// Times from the first one on, by the duration of each leg.
fn fill(times_s: &mut [f64], duration: impl Fn(usize) -> f64) {
    let mut time = times_s.first().copied().unwrap_or(0.0);
    for (leg, place) in times_s.iter_mut().skip(1).enumerate() {
        time += duration(leg);
        *place = time;
    }
}
