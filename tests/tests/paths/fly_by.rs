//! Legs and turns around way-points: lines against other sources, residuals, refusals.

use schuler::earth::{ECCENTRICITY_SQUARED, Geodetic};
use schuler::math::vector::Vector;
use schuler::trajectory::segment::attitude::AttitudeRule;
use schuler::trajectory::segment::compile::Compiler;
use schuler::trajectory::segment::compile::Start;
use schuler::trajectory::segment::compile::segment::{Length, Segment};
use schuler::trajectory::segment::control::{Controls, Line};
use schuler::trajectory::segment::fault::Fault;
use schuler::trajectory::segment::flow::Track;
use schuler::trajectory::waypoints::fault::WaypointError;
use schuler::trajectory::waypoints::fly_by::{FlyBy, ROOM, fly_by};

const RADIUS: f64 = 6.4e6;

fn at(latitude: f64, longitude: f64, altitude: f64) -> Geodetic<f64> {
    Geodetic { latitude: latitude.to_radians(), longitude: longitude.to_radians(), altitude }
}

fn plan<'a>(points: &'a [Geodetic<f64>], speeds_m_s: &'a [f64]) -> FlyBy<'a> {
    let (line, rule) = (Line::Geodesic, AttitudeRule::Coordinated);
    FlyBy { points, speeds_m_s, bank: 0.5, blend_s: 4.0, line, rule }
}

fn flown(plan: &FlyBy<'_>) -> Result<(Start, Vec<Segment>), WaypointError> {
    let mut segments = vec![Segment::Hold { duration_s: 0.0 }; ROOM * (plan.points.len() - 1)];
    let (start, count) = fly_by(plan, &mut segments)?;
    segments.truncate(count);
    Ok((start, segments))
}

/// Course and length between two points by GeographicLib.
#[test]
fn legs_are_geodesics() {
    let legs = [
        (((45.0, 100.0), (45.5, 101.0)), 0.9486384315253925, 96178.76316778282),
        (((45.0, 100.0), (47.0, 105.0)), 1.0186410822971304, 446451.4653186413),
        (((10.0, -60.0), (60.0, 100.0)), 0.18102527152008752, 12043537.82742026),
        (((50.0, 0.0), (40.0, -75.0)), -1.2306760812804045, 5763484.302608725),
        (((89.5, 10.0), (89.4, -150.0)), -0.19056932637186735, 121012.2573002803),
        (((-20.0, 179.5), (-21.0, -179.0)), 2.1911270752088123, 191672.5158261115),
    ];
    for ((from, to), course, length) in legs {
        let points = [at(from.0, from.1, 0.0), at(to.0, to.1, 0.0)];
        let (start, segments) = flown(&plan(&points, &[200.0; 2])).unwrap();
        assert!(
            (start.course - course).abs() < 2e-13 * RADIUS / length + 1e-14,
            "{from:?}: {}",
            start.course - course
        );
        let [Segment::Straight { length: Length::Distance(distance), .. }] = segments[..] else {
            panic!("{segments:?}")
        };
        assert!((distance - length).abs() < 1e-6, "{from:?}: {distance} {length}");
    }
}

/// tan χ = Δλ/Δq, with the isometric latitude q = artanh(sinφ) − e artanh(e sinφ) (Snyder, eq. 15-1).
#[test]
fn rhumb_lines_keep_their_course() {
    let e = ECCENTRICITY_SQUARED.sqrt();
    let isometric = |latitude: f64| {
        let s = latitude.sin();
        s.atanh() - e * (e * s).atanh()
    };
    for (from, to) in [((45.0, 100.0), (47.0, 105.0)), ((-10.0, 170.0), (30.0, 210.0))] {
        let points = [at(from.0, from.1, 0.0), at(to.0, to.1, 0.0)];
        let plan = FlyBy { line: Line::Rhumb, ..plan(&points, &[200.0; 2]) };
        let (start, _) = flown(&plan).unwrap();
        let rise = isometric(points[1].latitude) - isometric(points[0].latitude);
        let course = (points[1].longitude - points[0].longitude).atan2(rise);
        assert!((start.course - course).abs() < 1e-9, "{} {course}", start.course);
    }
}

fn tour() -> Vec<Geodetic<f64>> {
    vec![
        at(45.0, 179.5, 500.0),
        at(45.3, 179.8, 1500.0),
        at(45.2, -179.7, 1500.0),
        at(45.6, -179.5, 900.0),
        at(45.6, 179.7, 1200.0),
    ]
}

/// The distance of a place from the geodesic between two points, m.
fn aside(from: Geodetic<f64>, to: Geodetic<f64>, place: &Track) -> f64 {
    let points = [from, to].map(|at| Geodetic { altitude: from.altitude, ..at });
    let (start, _) = flown(&plan(&points, &[100.0; 2])).unwrap();
    let track = Track::new(points[0], start.course);
    let hi = |v: &Track| v.normal_e.map(|n| n.hi);
    let mut distance = 0.0;
    for _ in 0..6 {
        let here = track.after(&Controls::steady(distance / 100.0, 100.0));
        let off: Vector<f64> = (place.normal_e - here.normal_e).map(|n| n.hi) * RADIUS;
        distance += off.dot(here.along_e);
        if off.dot(here.along_e).abs() < 1e-6 {
            return off.dot(here.along_e.cross(hi(&here))).abs();
        }
    }
    panic!("no nearest place")
}

#[test]
fn turns_come_out_on_the_next_leg() {
    let points = tour();
    let speeds = [0.0, 120.0, 150.0, 150.0, 100.0];
    let plan = plan(&points, &speeds);
    let (start, segments) = flown(&plan).unwrap();
    let compiler = Compiler::new(start, AttitudeRule::Coordinated, &segments).unwrap();
    let mut corner = 0;
    let mut last = None;
    for span in compiler.spans() {
        let span = span.unwrap();
        if let Segment::Turn { .. } = segments[span.index] {
            corner += 1;
            let off = aside(points[corner], points[corner + 1], &span.state.track);
            assert!(off < 1e-3, "{corner}: {off} m");
            let height = span.state.track.altitude.hi - points[corner].altitude;
            assert!(height.abs() < 1e-8, "{corner}: {height}");
            assert_eq!(span.state.speed, speeds[corner]);
        }
        last = Some(span.state);
    }
    assert_eq!(corner, 3);
    let last = last.unwrap();
    let off = last.track.normal_e - Track::new(points[4], 0.0).normal_e;
    let off = off.map(|n| n.hi).norm() * RADIUS;
    assert!(off < 1e-6, "{off} m");
    assert!((last.track.altitude.hi - points[4].altitude).abs() < 1e-8);
    // All of it compiles.
    assert!(compiler.clone().all(|piece| piece.is_ok()));
}

#[test]
fn what_cannot_be_flown_is_refused_with_its_point() {
    let points = tour();
    let speeds = [120.0; 5];
    let good = plan(&points, &speeds);
    assert!(flown(&good).is_ok());
    let refused = |plan: FlyBy<'_>| flown(&plan).unwrap_err();

    // Too fast for its legs; what is said to do does.
    let fast = [300.0; 5];
    let error = refused(FlyBy { bank: 0.3, speeds_m_s: &fast, ..good });
    let WaypointError::TooTight { index, bank, radius_m } = error else { panic!("{error}") };
    assert!(index > 0 && index < 4 && radius_m > 0.0, "{error}");
    assert!(bank > 0.3 && error.to_string().contains("would do"), "{error}");
    let mut bank = bank;
    // Each refusal may be of another corner.
    let flat: Vec<_> = points.iter().map(|at| Geodetic { altitude: 500.0, ..*at }).collect();
    let tight = FlyBy { points: &flat, speeds_m_s: &fast, ..good };
    let flies = (0..4).any(|_| match flown(&FlyBy { bank: bank + 1e-6, ..tight }) {
        Ok(_) => true,
        Err(WaypointError::TooTight { bank: more, .. }) => {
            bank = more;
            false
        }
        Err(error) => panic!("{error}"),
    });
    assert!(flies);

    // A climb by 20 km on what its turns leave of the leg.
    let mut steep = points.clone();
    steep[2].altitude = 21_500.0;
    let error = refused(FlyBy { points: &steep, speeds_m_s: &[300.0; 5], bank: 1.2, ..good });
    assert!(
        matches!(error, WaypointError::Leg { index: 2, fault: Fault::TooSteep { .. } }),
        "{error}"
    );

    let mut double = points.clone();
    double[3] = Geodetic { altitude: 2000.0, ..points[2] };
    assert_eq!(refused(FlyBy { points: &double, ..good }), WaypointError::Coincident { index: 3 });
    let mut opposite = points.clone();
    opposite[2] = at(-45.3, -0.2, 0.0);
    assert_eq!(refused(FlyBy { points: &opposite, ..good }), WaypointError::Antipodal { index: 2 });
    let mut pole = points.clone();
    pole[4] = at(90.0, 0.0, 0.0);
    let rhumb = FlyBy { points: &pole, line: Line::Rhumb, ..good };
    assert_eq!(refused(rhumb), WaypointError::Pole { index: 4 });
    assert_eq!(
        refused(FlyBy { speeds_m_s: &[120.0, 120.0, 0.0, 120.0, 120.0], ..good }),
        WaypointError::Speed { index: 2 }
    );
    assert_eq!(
        refused(FlyBy { speeds_m_s: &speeds[1..], ..good }),
        WaypointError::Count { needed: 5 }
    );
    let mut bad = points.clone();
    bad[1].longitude = f64::NAN;
    assert_eq!(refused(FlyBy { points: &bad, ..good }), WaypointError::NotFinite { index: 1 });
    assert_eq!(refused(FlyBy { bank: 1.5, ..good }), WaypointError::Turn);
    assert_eq!(refused(FlyBy { points: &points[..1], ..good }), WaypointError::TooFew);
}
