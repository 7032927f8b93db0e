//! Splines through way-points: over the antimeridian and a pole, by speeds, and what is refused.

use super::derivative;
use schuler::earth::Geodetic;
use schuler::trajectory::piecewise::piece::Piece;
use schuler::trajectory::spline::place::{Pace, channels};
use schuler::trajectory::spline::{BAND, EXTRA, Ends};
use schuler::trajectory::waypoints::fault::WaypointError;
use schuler::trajectory::waypoints::through::{through, times_from_speeds};

fn at(latitude: f64, longitude: f64, altitude: f64) -> Geodetic<f64> {
    Geodetic { latitude: latitude.to_radians(), longitude: longitude.to_radians(), altitude }
}

fn pieces(
    points: &[Geodetic<f64>],
    times_s: &[f64],
    ends: Ends,
) -> Result<Vec<Piece<8>>, WaypointError> {
    let mut band = vec![[0.0; BAND]; points.len() + EXTRA];
    let mut control = vec![[0.0; 4]; points.len() + EXTRA];
    let path = through(points, times_s, ends, &mut band, &mut control)?;
    Ok((0..path.pieces()).map(|index| path.piece(index).unwrap()).collect())
}

/// Across the antimeridian and over the pole, which are places like any other.
fn tour() -> (Vec<Geodetic<f64>>, Vec<f64>) {
    let points = vec![
        at(89.6, 175.0, 900.0),
        at(89.7, -179.0, 1100.0),
        at(89.9, -170.0, 1200.0),
        at(89.9, 15.0, 1000.0),
        at(89.7, 20.0, 800.0),
        at(89.5, 25.0, 500.0),
    ];
    (points, vec![10.0, 80.0, 190.0, 290.0, 400.0, 520.0])
}

#[test]
fn points_are_met() {
    let (points, times) = tour();
    for ends in [Ends::Natural, Ends::AtRest] {
        let pieces = pieces(&points, &times, ends).unwrap();
        for (piece, two) in pieces.iter().zip(points.windows(2)) {
            for (t, place) in [(piece.start_s, two[0]), (piece.end_s, two[1])] {
                let normal = [0, 1, 2].map(|c| piece.channel(c, t));
                let scale = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
                let [x, y, z, h] = channels(place);
                for (got, expected) in normal.iter().zip([x, y, z]) {
                    assert!(6.4e6 * (got / scale - expected).abs() < 5e-9, "{ends:?} {t}");
                }
                assert!((piece.channel(3, t) - h).abs() < 1e-9);
            }
        }
        // At rest the path starts and ends with zero velocity, acceleration and its rate.
        let still =
            |order| derivative(&pieces[0], 0, order, pieces[0].start_s - pieces[0].middle_s);
        let still = [1, 2, 3].map(|order| 6.4e6 * still(order).abs());
        assert_eq!(ends == Ends::AtRest, still.iter().all(|x| *x < 1e-6), "{still:?}");
    }
}

/// Legs have their mean speed along the path that is flown.
#[test]
fn legs_take_the_mean_of_their_speeds() {
    let (points, _) = tour();
    let speeds = [100.0, 140.0, 180.0, 180.0, 120.0, 100.0];
    let mut times = vec![7.0; 6];
    let mut band = vec![[0.0; BAND]; 6 + EXTRA];
    let mut control = vec![[0.0; 4]; 6 + EXTRA];
    times_from_speeds(&points, &speeds, Ends::Natural, &mut times, &mut band, &mut control)
        .unwrap();
    assert_eq!(times[0], 7.0);
    let pieces = pieces(&points, &times, Ends::Natural).unwrap();
    for (piece, two) in pieces.iter().zip(speeds.windows(2)) {
        let span = piece.end_s - piece.start_s;
        let count = 2000;
        let mean = (0..count)
            .map(|k| piece.start_s + span * (f64::from(k) + 0.5) / f64::from(count))
            .map(|t| Pace::at(piece, t).speed_m_s)
            .sum::<f64>()
            / f64::from(count);
        let asked = 0.5 * (two[0] + two[1]);
        assert!((mean / asked - 1.0).abs() < 0.02, "{mean} {asked}");
    }
}

#[test]
fn what_is_no_path_is_refused_with_its_point() {
    let (points, times) = tour();
    let refused =
        |points: &[Geodetic<f64>], times: &[f64]| pieces(points, times, Ends::Natural).unwrap_err();
    let mut late = times.clone();
    late[3] = 190.0;
    assert_eq!(refused(&points, &late), WaypointError::NotIncreasing { index: 3 });
    let mut double = points.clone();
    double[2] = points[1];
    assert_eq!(refused(&double, &times), WaypointError::Coincident { index: 2 });
    let mut opposite = points.clone();
    opposite[5] = at(-89.7, -160.0, 0.0);
    assert_eq!(refused(&opposite, &times), WaypointError::Antipodal { index: 5 });
    let mut far = points.clone();
    far[4] = at(10.0, 0.0, 0.0);
    let error = refused(&far, &times);
    assert!(matches!(error, WaypointError::TooFast { index: 4, .. }), "{error}");
    let mut high = points.clone();
    high[1].altitude = f64::INFINITY;
    assert_eq!(refused(&high, &times), WaypointError::NotFinite { index: 1 });
    let mut never = times.clone();
    never[2] = f64::NAN;
    assert_eq!(refused(&points, &never), WaypointError::NotFinite { index: 2 });
    assert_eq!(refused(&points[..1], &times[..1]), WaypointError::TooFew);
    assert_eq!(refused(&points, &times[1..]), WaypointError::Count { needed: 6 });
    // A zigzag of 16 km in a second each.
    let zigzag: Vec<Geodetic<f64>> =
        (0..6).map(|k| at(45.0, 0.2 * f64::from(k % 2), 0.0)).collect();
    let seconds: Vec<f64> = (0..6).map(f64::from).collect();
    let error = refused(&zigzag, &seconds);
    assert!(matches!(error, WaypointError::TooSharp { index: 1, .. }), "{error}");
}
