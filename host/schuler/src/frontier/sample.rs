//! A made-up measurement for the tests.

use super::Point;
use super::case::Case;
use super::front::mark;

/// Times and errors in two scenes.
pub fn points() -> Vec<Point> {
    let cases = Case::all();
    let find = |name: &str| *cases.iter().find(|c| c.to_string() == name).expect(name);
    let point = |scene: &str, name: &str, rate_hz: f64, ns: f64, error: f64| Point {
        scene: scene.to_owned(),
        duration_s: 100.0,
        rate_hz,
        case: find(name),
        ns_per_sample: ns,
        ns_spread: 0.5,
        max_position_m: error,
        max_velocity_m_s: error / 100.0,
        max_attitude_arcsec: error * 10.0,
        on_front: false,
    };
    let mut points = vec![
        point("slow", "textbook local-level f64", 20.0, 70.0, 3.25e-4),
        point("slow", "taylor 0,4,0 earth-fixed f64", 20.0, 60.0, 8e-9),
        point("slow", "taylor 0,4,0 local-level f32", 10.0, 40.0, 0.12),
        point("slow", "rk4 earth-fixed f64", 20.0, 200.0, f64::NAN),
        point("fast", "taylor 2,4,2 earth-fixed f64-plain", 1000.0, 100.0, 1.5e3),
    ];
    mark(&mut points[..4]);
    mark(&mut points[4..]);
    points
}
