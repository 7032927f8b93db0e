//! The path against others' ways to it: Karney's geodesics, a rhumb line's closed form, Runge and Kutta with
//! angles.

use super::*;
use schuler::earth::{ECCENTRICITY_SQUARED, Radii, SEMI_MAJOR_AXIS};
use schuler::trajectory::segment::control::{Control, Controls};
use schuler::trajectory::segment::flow::Track;
use schuler::trajectory::segment::state::State;
use schuler::trajectory::segment::step::Step;
use schuler::trajectory::{Trajectory, wrap};

#[test]
fn a_straight_line_is_karneys_geodesic() {
    // Latitude, longitude and azimuth after a distance, by GeographicLib 2.1 (Karney, Algorithms for geodesics,
    // Journal of Geodesy 87, 2013).
    for ([latitude, longitude, azimuth, distance], [to_latitude, to_longitude, to_azimuth]) in [
        (
            [40.6, -73.8, 53.5, 5_850_000.0],
            [49.00532185942815, 2.495751673773171, 111.57083839722884],
        ),
        (
            [-30.0, 170.0, 75.0, 9_000_000.0],
            [8.332901901885789, -115.56084186784369, 57.78898726622849],
        ),
        ([89.0, 30.0, 1.0, 250_000.0], [88.76146330551195, -151.8070715986442, 179.19258751853644]),
        ([0.0, 0.0, 90.0, 3_000_000.0], [0.0, 26.949458523585644, 90.0]),
        (
            [45.0, 100.0, 200.0, 12_000_000.0],
            [-58.486486677576735, 61.73242321364093, -152.46234473107475],
        ),
    ] {
        let [latitude, longitude, course] = [latitude, longitude, azimuth].map(f64::to_radians);
        let position = Geodetic { latitude, longitude, altitude: 0.0 };
        let from = Start { position, course, speed: 250.0 };
        let segments = [straight_m(distance, Line::Geodesic)];
        let end = spans(from, AttitudeRule::Level, &segments)[0].state.track;
        let expected = Geodetic {
            latitude: f64::to_radians(to_latitude),
            longitude: f64::to_radians(to_longitude),
            altitude: 0.0,
        };
        let miss = (end.position().to_earth_fixed() - expected.to_earth_fixed()).norm();
        assert!(miss < 2e-8, "{azimuth}: {miss:e}");
        let turned: f64 = wrap(end.course() - f64::to_radians(to_azimuth));
        // Nearer to the pole the same metres are more of a course.
        assert!(turned.abs() < 2e-8 / (6e6 * to_latitude.to_radians().cos()), "{turned:e}");
    }
}

#[test]
fn a_rhumb_line_keeps_its_course() {
    let e = ECCENTRICITY_SQUARED.sqrt();
    let isometric = |phi: f64| phi.sin().atanh() - e * (e * phi.sin()).atanh();
    for (latitude, course) in [(45.0, 70.0), (-60.0, -30.0), (5.0, 179.0), (70.0, 91.0)] {
        let from = start(latitude, course, 0.0, 250.0);
        let course = f64::to_radians(course);
        let distance = 2_000_000.0;
        let segments = [straight_m(distance, Line::Rhumb)];
        let end = spans(from, AttitudeRule::Level, &segments)[0].state.track;
        assert!((end.course() - course).abs() < 1e-12, "{}", end.course() - course);
        // Δλ = tanα Δψ along a rhumb line, ψ the isometric latitude.
        let (phi, last) = (from.position.latitude, end.position().latitude);
        let longitude: f64 = wrap(end.position().longitude - from.position.longitude);
        let expected = course.tan() * (isometric(last) - isometric(phi));
        let across = (longitude - expected) * SEMI_MAJOR_AXIS * last.cos() * course.cos();
        assert!(across.abs() < 2e-8, "{course}: {across:e}");
        // ∫ R_M dφ = s cosα, by Simpson's rule.
        let n = 4000;
        let arc = (0..=n).fold(0.0, |sum, k| {
            let at = phi + (last - phi) * f64::from(k) / f64::from(n);
            let weight = if k == 0 || k == n {
                1.0
            } else if k % 2 == 1 {
                4.0
            } else {
                2.0
            };
            sum + weight * Radii::at(at.sin(), at.cos()).meridian
        }) * (last - phi)
            / f64::from(3 * n);
        assert!(
            (arc - distance * course.cos()).abs() < 2e-8,
            "{:e}",
            arc - distance * course.cos()
        );
    }
}

/// S(x) by its sum.
fn smooth(x: f64) -> f64 {
    let binomial =
        |n: u32, k: u32| (0..k).fold(1.0, |b, i| b * f64::from(n - i) / f64::from(i + 1));
    if x <= 0.0 {
        return 0.0;
    }
    if x >= 1.0 {
        return 1.0;
    }
    let sum = |x: f64| {
        let term = |j: u32| binomial(6 + j, j) * binomial(13, 6 - j) * (-x).powi(j as i32);
        x.powi(7) * (0..=6).map(term).sum::<f64>()
    };
    if x < 0.5 { sum(x) } else { 1.0 - sum(1.0 - x) }
}

fn value(control: &Control, time_s: f64) -> f64 {
    let steps = control.steps.iter().filter(|step| step.change != 0.0);
    steps.fold(control.value, |sum, s| sum + s.change * smooth((time_s - s.start_s) / s.duration_s))
}

/// φ̇, λ̇, χ̇, ḣ from latitude, course and height: the same motion in angles.
fn slopes(controls: &Controls, time_s: f64, [phi, _, chi, h]: [f64; 4]) -> [f64; 4] {
    let (speed, climb) = (value(&controls.speed, time_s), value(&controls.climb, time_s));
    let (s, c) = phi.sin_cos();
    let radii = Radii::at(s, c);
    let level = speed * climb.cos();
    let longitude = level * chi.sin() / ((radii.prime_vertical + h) * c);
    [
        level * chi.cos() / (radii.meridian + h),
        longitude,
        value(&controls.course_rate, time_s) + longitude * s,
        speed * climb.sin(),
    ]
}

#[test]
fn a_manoeuvre_is_that_of_runge_and_kutta() {
    let step = |start_s, duration_s, change| Step { start_s, duration_s, change };
    // All at once: faster, up and level again, right and left.
    let controls = Controls {
        speed: Control::stepping(120.0, [step(2.0, 15.0, 60.0)]),
        climb: Control::stepping(0.0, [step(1.0, 6.0, 0.25), step(20.0, 5.0, -0.25)]),
        course_rate: Control::stepping(
            0.0,
            [step(3.0, 3.0, 0.12), step(12.0, 4.0, -0.3), step(24.0, 2.0, 0.18)],
        ),
        ..Controls::steady(30.0, 120.0)
    };
    for latitude in [45.0, -88.0] {
        let from = start(latitude, 30.0, 2000.0, 120.0);
        let track = Track::new(from.position, from.course);
        let end = State { speed: 120.0, ..State::at_rest(track) }.after(&controls);
        // Differences from the start, so that rounding is that of the differences.
        let origin = [from.position.latitude, 0.0, from.course, from.position.altitude];
        let n = 60_000;
        let h = controls.duration_s / f64::from(n);
        let mut d = [0.0; 4];
        let mut lost = [0.0; 4];
        for k in 0..n {
            let t = h * f64::from(k);
            let at = |scale: f64, slope: [f64; 4], time_s: f64| {
                let state = std::array::from_fn(|i| origin[i] + (d[i] + scale * slope[i]));
                slopes(&controls, time_s, state)
            };
            let k1 = at(0.0, [0.0; 4], t);
            let k2 = at(0.5 * h, k1, t + 0.5 * h);
            let k3 = at(0.5 * h, k2, t + 0.5 * h);
            let k4 = at(h, k3, t + h);
            for i in 0..4 {
                // Kahan's sum.
                let add = h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]) - lost[i];
                let sum = d[i] + add;
                lost[i] = (sum - d[i]) - add;
                d[i] = sum;
            }
        }
        let expected = Geodetic {
            latitude: origin[0] + d[0],
            longitude: from.position.longitude + d[1],
            altitude: origin[3] + d[3],
        };
        let miss = end.track.position().to_earth_fixed() - expected.to_earth_fixed();
        assert!(miss.norm() < 4e-9, "{latitude}: {:e}", miss.norm());
        let course: f64 = wrap(end.track.course() - origin[2] - d[2]);
        assert!(course.abs() < 1e-12, "{latitude}: {course:e}");
    }
}

#[test]
fn pieces_lie_on_the_path_between_their_joints_too() {
    // The flow to the middle of each piece, by controls that end there.
    let from = start(45.0, 30.0, 2000.0, 150.0);
    for bank_deg in [25.0, 60.0, 80.0] {
        let turn = turn(200.0, bank_deg, 3.0);
        let path = path(from, AttitudeRule::Coordinated, &[turn]);
        let track = Track::new(from.position, from.course);
        let state = State { speed: 150.0, ..State::at_rest(track) };
        let controls = turn.controls(&state).unwrap();
        let mut largest = [0.0_f64; 2];
        for piece in path.pieces() {
            let cut = Controls { duration_s: piece.middle_s, ..controls };
            let there = track.after(&cut).position().to_earth_fixed();
            let here = path.at(piece.middle_s);
            let at = Geodetic {
                latitude: here.latitude.value,
                longitude: here.longitude.value,
                altitude: here.altitude.value,
            };
            largest[0] = largest[0].max((at.to_earth_fixed() - there).norm());
            largest[1] =
                largest[1].max(path.rates_at(piece.middle_s.into_pair()).specific_force_b.y.abs());
        }
        assert!(largest[0] < 4e-9, "{bank_deg} {largest:?}");
        assert!(largest[1] < 1e-6, "{bank_deg} {largest:?}");
    }
}

#[test]
fn a_way_under_acceleration_is_the_integral_of_its_speed() {
    // Along the equator, where the arc is a circle's. Speeds, and how long the change takes.
    for (speed, to, blend_s) in [(0.0, 80.0, 40.0), (80.0, 150.0, 60.0), (100.0, 300.0, 120.0)] {
        let position = Geodetic { latitude: 0.0, longitude: 0.0, altitude: 0.0 };
        let from = Start { position, course: std::f64::consts::FRAC_PI_2, speed };
        let path = path(from, AttitudeRule::Coordinated, &[accelerate(to, blend_s)]);
        // ∫S: ½ at the end, and S(1 − x) = 1 − S(x).
        let binomial =
            |n: u32, k: u32| (0..k).fold(1.0, |b, i| b * f64::from(n - i) / f64::from(i + 1));
        let term = |j: u32, x: f64| {
            binomial(6 + j, j) * binomial(13, 6 - j) * (-x).powi(j as i32) / f64::from(8 + j)
        };
        let head = |x: f64| x.powi(8) * (0..=6).map(|j| term(j, x)).sum::<f64>();
        let mut largest = 0.0_f64;
        for k in 1..=500 {
            let x = f64::from(k) / 500.0;
            let integral = if x < 0.5 { head(x) } else { x - 0.5 + head(1.0 - x) };
            let expected = speed * (blend_s * x) + (to - speed) * blend_s * integral;
            let normal = path.kinematics_at((blend_s * x).into_pair()).normal_e;
            let way = SEMI_MAJOR_AXIS * normal.y.atan2(normal.x);
            largest = largest.max((way - expected).abs());
        }
        assert!(largest < 5e-9, "{speed} to {to}: {largest:e}");
    }
}

trait IntoPair {
    fn into_pair(self) -> schuler::math::compensated::Pair<f64>;
}

impl IntoPair for f64 {
    fn into_pair(self) -> schuler::math::compensated::Pair<f64> {
        schuler::math::compensated::Pair::new(self)
    }
}
