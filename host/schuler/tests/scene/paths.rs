//! What a scene may say of paths, and what it is told where that cannot be flown.

use super::errors::expect_more;
use super::scene;
use schuler::earth::Radii;
use schuler::math::compensated::Pair;
use schuler::trajectory::Trajectory;
use schuler_simulator::scene::{Scene, load, parse};
use std::f64::consts::PI;

#[track_caller]
fn parsed(more: &str) -> Scene {
    scene(more).unwrap_or_else(|error| panic!("{more}\n{error}"))
}

/// A flight of segments from a standing start, whose first segment is at line 5.
fn segments(list: &str) -> String {
    let start = "start = { latitude_deg = 45, longitude_deg = 10, altitude_m = 100 }";
    format!("[trajectory]\n{start}\nsegment = [\n{list}\n]\n")
}

#[test]
fn metres_are_angles_of_the_local_radii() {
    let metres = "latitude_deg = 45\nlongitude_deg = 100\naltitude_m = 3000\n\
        north_m = { rate = 200, harmonics = [{ amplitude = 70, period_s = 5, phase_deg = -90 }] }\n\
        east_m = { offset = 30, rate = 300 }\n";
    let motion = parsed(&format!("[trajectory]\n{metres}")).trajectory;
    let (sine, cosine) = (PI / 4.0).sin_cos();
    let radii = Radii::at(sine, cosine);
    let close = |a: f64, b: f64| assert!((a - b).abs() <= 1e-15 * b.abs(), "{a} {b}");
    close(motion.latitude.rate, 200.0 / (radii.meridian + 3000.0));
    close(motion.latitude.harmonics[0].amplitude, 70.0 / (radii.meridian + 3000.0));
    let east = (radii.prime_vertical + 3000.0) * cosine;
    close(motion.longitude.rate, 300.0 / east);
    close(motion.longitude.offset, 100f64.to_radians() + 30.0 / east);
    // It moves with the speed that is asked for, but for 320 m to the north, where meridians are nearer.
    let start = motion.build().expect("it has room").at(1.25);
    let v = start.velocity_ned();
    assert!((v.x - 200.0).abs() < 0.01 && (v.y - 300.0).abs() < 0.02, "{v:?}");
    let pole = "[trajectory]\nlatitude_deg = 90\neast_m = 1\n";
    expect_more(pole, 5, "trajectory.east_m", &["at a pole", "off the pole"]);
}

/// The built-in flight in metres is the built-in flight in degrees.
#[test]
fn the_manoeuvre_in_metres_is_the_manoeuvre() {
    let text = "duration_s = 100\nrate_hz = 100\n[trajectory]\n\
        latitude_deg = 45\nlongitude_deg = 100\naltitude_m = 3000\n\
        [trajectory.north_m]\nrate = 200\n\
        harmonics = [{ amplitude = 68.10173611111111, period_s = 5.2359877559829887, phase_deg = -90 }]\n\
        [trajectory.east_m]\nrate = 300\n\
        harmonics = [{ amplitude = 60, period_s = 8.9759790102565521, phase_deg = -90 }]\n";
    let metres = parse::scene("metres.toml", text).expect("valid").trajectory;
    let degrees = load("manoeuvre").expect("it is built in").trajectory;
    for (a, b) in [(&metres.latitude, &degrees.latitude), (&metres.longitude, &degrees.longitude)] {
        assert!((a.rate / b.rate - 1.0).abs() < 1e-14, "{a:?} {b:?}");
        let ratio = a.harmonics[0].amplitude / b.harmonics[0].amplitude;
        assert!((ratio - 1.0).abs() < 1e-14, "{a:?} {b:?}");
    }
}

#[test]
fn a_lever_arm_and_vibration_ride_on_any_motion() {
    let bare = parsed("[trajectory]\naltitude_m = 100\nyaw_deg = { rate = 57.29577951308232 }\n");
    let arm = "[trajectory]\naltitude_m = 100\nyaw_deg = { rate = 57.29577951308232 }\n\
        lever_arm_m = [2, 0, 0]\n[trajectory.vibration]\n\
        down_m = { harmonics = [{ amplitude = 0.01, period_s = 0.5 }] }\n";
    let force = |scene: &Scene| {
        let course = scene.trajectory.build().expect("it has room");
        course.rates_at(Pair::new(0.25)).specific_force_b
    };
    let (bare, carried) = (force(&bare), force(&parsed(arm)));
    // −ω²r forward, and −A ω² cos(ωt) down at half a period, where the cosine is −1.
    assert!((carried.x - bare.x + 2.0).abs() < 2e-3, "{carried:?} {bare:?}");
    let shaken = 0.01 * (4.0 * PI) * (4.0 * PI);
    assert!((carried.z - bare.z - shaken).abs() < 1e-3, "{carried:?} {bare:?}");
    let beside = "[trajectory]\nlever_arm_m = [1, 2]\n";
    expect_more(beside, 4, "trajectory.lever_arm_m", &["2 values", "[forward, right, down]"]);
    let wild =
        "[trajectory.vibration]\nright_m = { harmonics = [{ amplitude = 9, period_s = 0.001 }] }\n";
    expect_more(wild, 4, "trajectory.vibration.right_m", &["too fast"]);
}

#[test]
fn a_path_ends_where_it_ends() {
    let text =
        format!("rate_hz = 20\n{}", segments("{ hold_s = 30 }, { rotate_deg = [0, 0, 90] }"));
    let scene = parse::scene("folder/bad.toml", &text).expect("it has a length of its own");
    assert_eq!((scene.duration_s, scene.samples()), (34.0, 680));
    let long = segments("{ hold_s = 9 }");
    expect_more(&long, 1, "duration_s", &["10 s is beyond the path's end", "at most 9"]);
}

#[test]
fn one_kind_of_motion() {
    let two = "[trajectory]\nroll_deg = 1\n[trajectory.waypoints]\npoints = []\n";
    expect_more(two, 5, "trajectory.waypoints", &["stands beside roll_deg", "or log"]);
    let attitude = "[trajectory]\nroll_deg = 1\nattitude = \"level\"\n";
    expect_more(attitude, 5, "trajectory.attitude", &["of a path"]);
    let angles = segments("{ hold_s = 60 }").replace("start", "attitude = \"log\"\nstart");
    expect_more(&angles, 4, "trajectory.attitude", &["needs a log", "\"coordinated\""]);
}

#[test]
fn segments_that_cannot_be_flown() {
    let refused = |list: &str, line, key: &str, words: &[&str]| {
        expect_more(&segments(list), line, &format!("trajectory.segment{key}"), words);
    };
    refused("{ hold_s = 9 },\n{ turn_deg = 90, bank_deg = 20 }", 7, "[1].turn_deg", &["speed 0"]);
    refused("{ blend_s = 9 }", 6, "[0]", &["does nothing", "accelerate_to_m_s"]);
    refused("{ hold_s = 9, climb_m = 5 }", 6, "[0].climb_m", &["stands beside hold_s"]);
    refused("{ hold_s = 9, bank_deg = 5 }", 6, "[0].bank_deg", &["does not go with hold_s"]);
    refused("{ accelerate_to_m_s = 9 }", 6, "[0].blend_s", &["missing", "acceleration_m_s2"]);
    refused("{ hold_s = -1 }", 6, "[0].hold_s", &["-1 is out of range", "above 0"]);
    let fast = "{ accelerate_to_m_s = 100, blend_s = 30 },\n";
    let turn = format!("{fast}{{ turn_deg = 90, radius_m = 50 }}");
    refused(&turn, 7, "[1].radius_m", &["too tightly", "a radius from 89."]);
    let climb = format!("{fast}{{ climb_m = 100, climb_m_s = 99 }}");
    refused(&climb, 7, "[1].climb_m_s", &["too steeply", "at most 98"]);
    let push = format!("{fast}{{ climb_m = 900, climb_m_s = 50, blend_s = 1 }}");
    refused(&push, 7, "[1].blend_s", &["weightlessness", "a blend_s from"]);
    let both = format!("{fast}{{ turn_deg = 9, bank_deg = 5, radius_m = 9 }}");
    refused(&both, 7, "[1].radius_m", &["stands beside bank_deg"]);
    let pole = "[trajectory]\nstart = { latitude_deg = 89.5, longitude_deg = 0, speed_m_s = 250 }\n\
        segment = [{ straight_s = 300, line = \"rhumb\" }]\n";
    expect_more(pole, 5, "trajectory.segment[0].straight_s", &["at a pole"]);
    let swapped = "[trajectory]\nstart = { latitude_deg = 110, longitude_deg = 0 }\nsegment = []\n";
    expect_more(swapped, 4, "trajectory.start.latitude_deg", &["out of range", "-90 to 90"]);
}

/// Way-points, the first of which is at line 5.
fn waypoints(points: &[&str], more: &str) -> String {
    let points: Vec<_> = points.iter().map(|point| format!("{{ {point} }},\n")).collect();
    format!("[trajectory.waypoints]\npoints = [\n{}]\n{more}\n", points.concat())
}

const A: &str = "latitude_deg = 45, longitude_deg = 10, altitude_m = 9, time_s = 0";
const B: &str = "latitude_deg = 45.1, longitude_deg = 10, altitude_m = 9, time_s = 60";

#[test]
fn way_points_that_cannot_be_flown() {
    let refused = |points: &[&str], more: &str, line, key: &str, words: &[&str]| {
        expect_more(&waypoints(points, more), line, &format!("trajectory.waypoints{key}"), words);
    };
    refused(&[A], "", 4, ".points", &["too few"]);
    refused(&[A, &B.replace("60", "0")], "", 6, ".points[1].time_s", &["0 does not come after 0"]);
    refused(&[&A.replace("= 0", "= 5"), B], "", 5, ".points[0].time_s", &["is not the start"]);
    refused(&[A, &A.replace("= 0", "= 5")], "", 6, ".points[1]", &["same place"]);
    let opposite = "latitude_deg = -45, longitude_deg = -170, altitude_m = 9, time_s = 9e4";
    refused(&[A, opposite], "", 6, ".points[1]", &["opposite", "a point between"]);
    refused(&[A, &B.replace("60", "0.1")], "", 6, ".points[1]", &["m/s", "at most 1e5"]);
    let swapped = "latitude_deg = 100, longitude_deg = 45, altitude_m = 9, time_s = 60";
    refused(&[A, swapped], "", 6, ".points[1].latitude_deg", &["is it the longitude?", "90"]);
    let untimed = "latitude_deg = 45.1, longitude_deg = 10, altitude_m = 9";
    refused(&[A, untimed], "", 6, ".points[1].time_s", &["missing", "or a speed"]);
    refused(&[A, B], "bank_deg = 9", 8, ".bank_deg", &["fly-by"]);
    let slow = "latitude_deg = 45.0000001, longitude_deg = 10, altitude_m = 9, time_s = 60";
    refused(&[A, slow], "", 5, ".points[0]", &["too slowly", "0.1 m/s", "coordinated"]);
    let radians = [
        "latitude_deg = 0.7854, longitude_deg = 1.7453, altitude_m = 9, time_s = 0",
        "latitude_deg = 0.7855, longitude_deg = 1.7455, altitude_m = 9, time_s = 60",
    ];
    refused(&radians, "", 4, ".points", &["are they radians?", "near_origin = true"]);
    parsed(&waypoints(&radians, "near_origin = true"));
}

#[test]
fn corners_that_are_too_sharp_tell_the_bank_that_would_do() {
    let points = [
        "latitude_deg = 45, longitude_deg = 10, altitude_m = 900",
        "latitude_deg = 45.05, longitude_deg = 10, altitude_m = 900",
        "latitude_deg = 45.05, longitude_deg = 10.05, altitude_m = 900",
    ];
    let with = |bank: &str| format!("mode = \"fly-by\"\nspeed_m_s = 200\nbank_deg = {bank}");
    let text = waypoints(&points, &with("20"));
    let error = scene(&text).expect_err("it is too sharp").to_string();
    let words = "folder/bad.toml:6: trajectory.waypoints.points[1]: turns wider than its legs allow; \
        accepted: a bank of ";
    assert!(error.starts_with(words), "{error}");
    let bank = error[words.len()..].split('°').next().expect("it is told");
    let bank: f64 = bank.parse().expect("a number");
    // What is told is flown, with a degree for the rounding of the estimate.
    let flown = parsed(&waypoints(&points, &with(&(bank + 1.0).to_string())));
    assert!(flown.trajectory.path.is_some());
}

#[test]
fn logs_lie_beside_their_scene() {
    let folder = tempfile::tempdir().expect("a folder");
    let text = "rate_hz = 20\n[trajectory.log]\nfile = \"nav.csv\"\n";
    let file = folder.path().join("scene.toml").display().to_string();
    let read = |rows: &str| {
        std::fs::write(folder.path().join("nav.csv"), rows).expect("it can be written");
        parse::scene(&file, text).map_err(|error| error.to_string())
    };
    let header = "time_s,latitude_deg,longitude_deg,altitude_m\n";
    let row = |t: f64| format!("{t},{},10,500\n", 45.0 + 1e-4 * t);
    let rows: String = (0..30).map(|k| row(7.0 + f64::from(k))).collect();
    let scene = read(&format!("{header}{rows}")).expect("it is a log");
    assert_eq!(scene.duration_s, 29.0);
    let path = scene.trajectory.build().expect("it has room");
    let at = path.solution_at(Pair::new(3.0)).position;
    assert!((at.latitude.hi.to_degrees() - 45.001).abs() < 1e-13);
    let fails = |rows: String, place: &str, words: &[&str]| {
        let error = read(&rows).expect_err("it is wrong");
        let start = format!("{}:{place}: ", folder.path().join("nav.csv").display());
        assert!(error.starts_with(&start), "{error}\nnot {start}");
        words.iter().for_each(|word| assert!(error.contains(word), "{error} without {word}"));
    };
    let gap = row(90.0);
    fails(format!("{header}{rows}{gap}"), "32: time_s", &["a gap from", "max_gap_s"]);
    fails(format!("{header}{rows}{}", row(9.0)), "32: time_s", &["9 does not come after 36"]);
    let jump = "37,55,10,500\n";
    fails(format!("{header}{rows}{jump}"), "32: latitude_deg", &["jumps", "at most 1e5 m/s"]);
    let swapped = "37,145,10,500\n";
    fails(format!("{header}{rows}{swapped}"), "32: latitude_deg", &["is it the longitude?"]);
    fails(format!("time_s,latitude_deg\n{}", "1,2\n"), "1: longitude_deg", &["missing"]);
    let radian = |t: f64| format!("{t},{},0.17,500\n", 0.785 + 1e-6 * t);
    let rows: String = (0..9).map(|k| radian(f64::from(k))).collect();
    fails(format!("{header}{rows}"), "2: latitude_deg", &["radians?", "near_origin"]);
    std::fs::remove_file(folder.path().join("nav.csv")).expect("it is there");
    let error = parse::scene(&file, text).expect_err("it is gone").to_string();
    let start = format!("{file}:3: trajectory.log.file: ");
    assert!(error.starts_with(&start) && error.contains("cannot be read"), "{error}");
}

#[test]
fn latitudes_beyond_a_pole_are_meant_or_refused() {
    let swapped = "[trajectory]\nlatitude_deg = 100\nlongitude_deg = 45\n";
    expect_more(swapped, 4, "trajectory.latitude_deg", &["is it a longitude?", "crosses_pole"]);
    parsed(&format!("{swapped}crosses_pole = true\n"));
}
