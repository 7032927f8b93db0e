//! The built-in scenes fly what they are said to fly.

use schuler::trajectory::{Motion, Trajectory};
use schuler_simulator::scene::{Axes, Scene, builtin, load};
use std::f64::consts::PI;

fn scene(name: &str) -> Scene {
    load(name).unwrap_or_else(|e| panic!("{e}"))
}

fn motion(name: &str, time_s: f64) -> Motion<f64> {
    let trajectory = scene(name).trajectory.build();
    trajectory.expect("it has room for what a scene may have").at(time_s)
}

#[track_caller]
fn near(value: f64, expected: f64, tolerance: f64) {
    assert!((value - expected).abs() <= tolerance, "{value} is not {expected} ± {tolerance:e}");
}

#[test]
fn rates_durations_and_titles() {
    let expected = [
        ("paper", 20.0, 1800.0, 36_000),
        ("paper-perfect", 20.0, 1800.0, 36_000),
        ("hard", 100.0, 60.0, 6_000),
        ("manoeuvre", 100.0, 100.0, 10_000),
        ("vibration", 100.0, 100.0, 10_000),
        ("coning", 200.0, 60.0, 12_000),
        ("stationary", 20.0, 1800.0, 36_000),
        ("cruise-180", 50.0, 1800.0, 90_000),
        ("polar", 50.0, 600.0, 30_000),
        ("sea-state", 50.0, 3600.0, 180_000),
        ("circuit", 100.0, 1800.0, 180_000),
        ("waypoints", 20.0, 1800.0, 36_000),
        ("drive", 50.0, 1800.0, 90_000),
        ("pole-circuit", 50.0, 1800.0, 90_000),
        ("aided-drive", 100.0, 600.0, 60_000),
        ("align-still", 20.0, 1200.0, 24_000),
        ("align-turn", 20.0, 1200.0, 24_000),
        ("align-sway", 50.0, 1200.0, 60_000),
    ];
    let names: Vec<_> = builtin::names().collect();
    assert_eq!(names.len(), expected.len());
    for ((name, rate_hz, duration_s, samples), (listed, title)) in expected.into_iter().zip(names) {
        assert_eq!(name, listed);
        let scene = builtin::scene(name).expect("it is built in");
        assert_eq!((scene.name.as_str(), &scene.title), (name, &title));
        assert!(title.len() > 10 && !title.contains('\n'), "{name}: {title}");
        assert_eq!(
            (scene.rate_hz, scene.duration_s, scene.seed),
            (rate_hz, duration_s, 1),
            "{name}"
        );
        assert_eq!(scene.samples(), samples, "{name}");
        let perfect = !["paper", "sea-state"].contains(&name)
            && !name.starts_with("ali")
            && name != "aided-drive";
        assert_eq!(scene.gyro == Default::default(), perfect, "{name}");
        assert_eq!(scene.accelerometer == Default::default(), perfect, "{name}");
        let frame = if name.starts_with("pol") { Axes::EarthFixed } else { Axes::LocalLevel };
        assert_eq!(scene.navigator.frame, frame, "{name}");
    }
    assert_eq!(builtin::scene("no-such-scene"), None);
    assert_eq!(scene(builtin::DEFAULT).name, "paper");
}

/// Whose rates tests/foundation holds against those computed elsewhere.
#[test]
fn paper_flies_as_paper_perfect() {
    assert_eq!(scene("paper").trajectory, scene("paper-perfect").trajectory);
}

#[test]
fn hard_shakes_by_a_tenth_of_a_metre() {
    // Half a period from crest to trough: 0.2 m north and up; a quarter later the roll is at 5°.
    let (crest, trough) = (motion("hard", 0.0), motion("hard", 0.25));
    let radius = 6_367_381.815_619_549; // R_M(45°)
    near((crest.latitude.value - trough.latitude.value) * (radius + 3500.0), 0.2, 2e-9);
    near(crest.altitude.value - trough.altitude.value, 0.2, 1e-12);
    near(motion("hard", 0.125).roll.value.to_degrees(), 5.0, 1e-12);
    near(crest.pitch.value.to_degrees(), 5.0, 1e-12);
    near(crest.roll.value, 0.0, 1e-15);
    assert_eq!(crest.longitude.first, 0.0);
}

#[test]
fn manoeuvre_and_vibration_have_their_speeds_in_metres() {
    for name in ["manoeuvre", "vibration"] {
        let start = motion(name, 0.0);
        let shaken = if name == "vibration" { 1.0 } else { 0.0 };
        let (omega, east) = (20.0 * PI, -10.0 / (20.0 * PI));
        near(start.roll.first.to_degrees(), 300.0 + shaken * 0.5 * omega, 1e-9);
        near(start.pitch.value, 0.5 * 0.4f64.sin() + shaken * 0.5f64.to_radians(), 1e-14);
        near(start.pitch.first, 0.5 * 1.3 * 0.4f64.cos(), 1e-13);
        near(start.yaw.value, 0.3, 1e-15);
        near(start.yaw.first, 0.8 * 0.9, 1e-14);
        let v = start.velocity_ned();
        near(v.x, 200.0 + 98.0665 / 1.44 * 1.2, 1e-9);
        near(v.y, 300.0 + 60.0 * 0.7 + shaken * east, 1e-9);
        near(v.z, -50.0 * 0.9, 1e-12);
        near(start.latitude.value.to_degrees(), 45.0, 1e-13);
        near(start.longitude.value.to_degrees(), 100.0, 1e-13);
        near(start.altitude.value, 3000.0, 1e-12);
        // A quarter of the north oscillation later it pulls by 10 g.
        let pull = motion(name, PI / 2.0 / 1.2);
        near(pull.latitude.second * (6_367_381.815_619_549 + 3000.0), -98.0665, 1e-9);
    }
}

#[test]
fn coning_leans_by_a_constant_degree() {
    for step in 0..20 {
        let m = motion("coning", f64::from(step) * 0.005);
        let lean = (m.roll.value.cos() * m.pitch.value.cos()).acos().to_degrees();
        near(lean, 1.0, 1e-4);
    }
    let (start, quarter) = (motion("coning", 0.0), motion("coning", 0.025));
    near(start.roll.value.to_degrees(), 1.0, 1e-15);
    near(quarter.pitch.value.to_degrees(), 1.0, 1e-12);
    near(start.velocity_ned().norm(), 0.0, 0.0);
}

#[test]
fn stationary_stands() {
    let m = motion("stationary", 1234.0);
    let degrees = [m.roll, m.pitch, m.yaw, m.latitude, m.longitude].map(|a| a.value.to_degrees());
    for (value, expected) in degrees.into_iter().zip([3.0, -7.0, 40.0, 45.0, 0.0]) {
        near(value, expected, 1e-14);
    }
    assert_eq!(m.altitude.value, 1000.0);
    assert_eq!(m.velocity_ned().norm(), 0.0);
    assert_eq!(m.yaw.first, 0.0);
}

#[test]
fn cruise_crosses_the_antimeridian_halfway() {
    let [start, middle, end] = [0.0, 900.0, 1800.0].map(|t| motion("cruise-180", t));
    assert!(start.longitude.value < PI && end.longitude.value > PI);
    near(middle.longitude.value, PI, 1e-14);
    assert!(end.solution().position.longitude.hi < -3.0, "printed east of it as west");
    let v = middle.velocity_ned();
    near(v.y, 250.0, 0.2);
    near(middle.latitude.value.to_degrees(), 60.0, 1e-12);
    // The heading follows the path, to the angles' rounding to a tenth of a degree.
    for time_s in [0.0, 70.0, 150.0, 300.0] {
        let m = motion("cruise-180", time_s);
        let v = m.velocity_ned();
        near(m.yaw.value.to_degrees(), v.y.atan2(v.x).to_degrees(), 0.1);
        // tan(bank) = v·ψ̇/g
        near(m.roll.value.to_degrees(), (250.0 * m.yaw.first / 9.79).atan().to_degrees(), 0.1);
    }
}

#[test]
fn polar_crosses_the_pole_in_the_middle() {
    let [before, pole, after] = [299.0, 300.0, 301.0].map(|t| motion("polar", t));
    near(pole.latitude.value, PI / 2.0, 1e-14);
    assert!(before.latitude.value < PI / 2.0 && after.latitude.value > PI / 2.0);
    for m in [before, pole, after] {
        near(m.velocity_ned().norm(), 250.0, 1e-6);
        assert_eq!(m.longitude.first, 0.0);
    }
}

#[test]
fn sea_state_moves_as_said() {
    let scene = scene("sea-state");
    let swing = |c: &schuler_simulator::scene::Channel| {
        let [h] = c.harmonics[..] else { panic!("one harmonic") };
        (h.amplitude, 2.0 * PI / h.angular_rate)
    };
    let (roll, roll_s) = swing(&scene.trajectory.roll);
    let (pitch, pitch_s) = swing(&scene.trajectory.pitch);
    let (heave, heave_s) = swing(&scene.trajectory.altitude);
    for (value, expected) in [
        (roll.to_degrees(), 12.0),
        (roll_s, 7.3),
        (pitch.to_degrees(), 4.0),
        (pitch_s, 5.1),
        (heave, 1.5),
        (heave_s, 6.1),
    ] {
        near(value, expected, 1e-12);
    }
}
