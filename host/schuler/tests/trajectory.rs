//! `schuler trajectory` and `schuler scenes`: what they print, and the files of a path.

use schuler_host::trajectory::fidelity::fidelity;
use std::process::Command;

fn schuler(arguments: &[&str]) -> (bool, String) {
    let out = Command::new(env!("CARGO_BIN_EXE_schuler")).args(arguments).output();
    let out = out.expect("the program starts");
    let text = [out.stdout, out.stderr].map(|bytes| String::from_utf8(bytes).expect("UTF-8"));
    (out.status.success(), text.concat())
}

#[test]
fn a_scene_is_printed_to_start_from() {
    let folder = tempfile::tempdir().expect("a folder");
    for name in ["circuit", "waypoints", "drive", "pole-circuit"] {
        let (done, text) = schuler(&["scenes", name]);
        assert!(done && text.starts_with("# "), "{text}");
        let file = folder.path().join("mine.toml");
        std::fs::write(&file, text).expect("it can be written");
        let (done, told) = schuler(&["trajectory", &file.display().to_string()]);
        assert!(done && told.starts_with("mine: "), "{told}");
    }
    let (done, text) = schuler(&["scenes", "circiut"]);
    assert!(!done && text.contains("did you mean `circuit`"), "{text}");
    let (done, text) = schuler(&["scenes", "--keys"]);
    assert!(done && text.contains("accelerate_to_m_s") && text.contains("near_origin"), "{text}");
}

/// A number behind a name, as it is printed.
fn number(text: &str, name: &str, index: usize) -> f64 {
    let line = text.lines().find(|line| line.starts_with(name)).expect(name);
    let numbers = line.split_whitespace().filter_map(|word| {
        word.trim_end_matches(['°', ',', 'g']).trim_end_matches("°/s").parse().ok()
    });
    numbers.collect::<Vec<f64>>()[index]
}

#[test]
fn a_circuit_is_what_its_segments_say() {
    let (done, text) = schuler(&["trajectory", "circuit"]);
    assert!(done, "{text}");
    assert_eq!(number(&text, "speed", 1), 150.0, "{text}");
    // 300 m, and 2400 m of climb on top.
    assert_eq!([number(&text, "height", 0), number(&text, "height", 1)], [300.0, 2700.0]);
    // 1/cos 60°, and a little of the descent.
    assert!((number(&text, "load factor", 1) - 2.0).abs() < 0.01, "{text}");
    assert!((number(&text, "bank", 1) - 60.0).abs() < 0.1, "{text}");
    for word in ["fidelity", "lateral force", "segments", "coordinated attitude"] {
        assert!(text.contains(word), "{text} without {word}");
    }
    // A great circle's lateral force is what the issue of the bound asks for.
    assert!(number(&text, "lateral force", 0) <= 1e-5, "{text}");
    let (done, text) = schuler(&["trajectory", "waypoints"]);
    assert!(done && text.contains("misfit") && text.contains("20 way-points"), "{text}");
}

/// The pieces follow the manoeuvres between their ends, too.
#[test]
fn circuits_are_true_to_their_manoeuvres() {
    for name in ["circuit", "drive", "pole-circuit"] {
        let scene = schuler_simulator::scene::load(name).expect(name);
        let path = scene.trajectory.path.as_ref().expect("it has a path");
        let route = scene.trajectory.route.as_ref().expect("it has a route");
        let flown = route.from.manoeuvres().expect("it has manoeuvres");
        let off = fidelity(path, flown).expect("it is flown");
        assert!(off > 0.0 && off <= 1e-8, "{name}: {off:e} m");
        // What is a millimetre higher is told.
        let mut higher = flown.clone();
        higher.start.position.altitude += 1e-3;
        let off = fidelity(path, &higher).expect("it is flown");
        assert!((off - 1e-3).abs() < 1e-5, "{name}: {off:e} m");
    }
}

#[test]
fn files_for_other_tools() {
    let folder = tempfile::tempdir().expect("a folder");
    let write = |name: &str| {
        let file = folder.path().join(name);
        let (done, text) = schuler(&["trajectory", "drive", "--out", &file.display().to_string()]);
        assert!(done && text.contains(" rows written to "), "{text}");
        std::fs::read_to_string(file).expect("it was written")
    };
    let csv = write("path.csv");
    assert!(csv.starts_with("time_s,latitude_deg,longitude_deg,altitude_m,north_m_s,"));
    assert_eq!(csv.lines().count(), 1 + 90_001);
    let geojson: serde_json::Value = serde_json::from_str(&write("path.geojson")).expect("JSON");
    let parts = &geojson["features"][0]["geometry"]["coordinates"];
    let parts: Vec<_> = parts.as_array().expect("lines").iter().collect();
    let (west, east) = (parts[0].as_array(), parts[parts.len() - 1].as_array());
    let (west, east) = (west.expect("points"), east.expect("points"));
    assert_eq!(west[0][0].as_f64().map(|x| (x * 100.0).round()), Some(17_997.0));
    assert_eq!(west[west.len() - 1][0], 180.0, "it is cut at the antimeridian");
    assert_eq!(parts[1][0][0], -180.0);
    assert!(east[east.len() - 1][0].as_f64().is_some_and(|x| x < -179.0));
    let kml = write("path.kml");
    assert!(
        kml.contains("<coordinates>179.97,") && kml.contains("<altitudeMode>absolute"),
        "{kml}"
    );
    let gpx = write("path.gpx");
    assert!(gpx.contains("<trkpt ") && gpx.contains("2000-01-01T00:"), "{gpx}");
    let odd = folder.path().join("path.xyz").display().to_string();
    let (done, text) = schuler(&["trajectory", "drive", "--out", &odd]);
    assert!(!done && text.contains("--out") && text.contains(".geojson"), "{text}");
}

/// Perfect sensors over 1800 s: every row is the truth to 1e-8 m.
#[test]
fn built_in_paths_are_flown_to_the_floor() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().display().to_string();
    let flights = [
        ("circuit", "50", "local-level"),
        ("circuit", "50", "earth-fixed"),
        ("waypoints", "20", "local-level"),
        ("waypoints", "20", "earth-fixed"),
        ("drive", "50", "local-level"),
        ("drive", "50", "earth-fixed"),
        ("pole-circuit", "50", "earth-fixed"),
    ];
    for (scene, rate, frame) in flights {
        let options = ["--rate", rate, "--frame", frame, "--no-report", "--every", "9999"];
        let arguments = [&["run", scene, "--out", out.as_str()], options.as_slice()].concat();
        let (done, text) = schuler(&arguments);
        assert!(done, "{scene} {frame}: {text}");
        let summary = std::fs::read_to_string(folder.path().join("summary.json"));
        let summary: serde_json::Value =
            serde_json::from_str(&summary.expect("it was written")).expect("JSON");
        let most = summary["error"]["max"]["position_m"].as_f64().expect("a number");
        assert!(most > 0.0 && most <= 1e-8, "{scene} {rate} Hz {frame}: {most:e} m");
    }
}

#[test]
fn a_replays_rows_are_flown_again_to_the_floor() {
    let folder = tempfile::tempdir().expect("a folder");
    let place = |name: &str| folder.path().join(name).display().to_string();
    let run = |arguments: &[&str]| {
        let (done, text) = schuler(arguments);
        assert!(done, "{arguments:?}: {text}");
    };
    let (imu, initial, nav) = (place("imu.csv"), place("initial.toml"), place("nav.csv"));
    run(&[
        "emulate",
        "waypoints",
        "--rate",
        "100",
        "--duration",
        "900",
        "--perfect",
        "--out",
        &imu,
    ]);
    run(&["replay", "--imu", &imu, "--initial", &initial, "--out", &nav]);
    let scene = place("again.toml");
    let text = "rate_hz = 100\n[trajectory]\nattitude = \"log\"\nlog = { file = \"nav.csv\" }\n";
    std::fs::write(&scene, text).expect("it can be written");
    let out = place("out");
    run(&["run", &scene, "--out", &out, "--no-report", "--every", "9999"]);
    let summary = std::fs::read_to_string(folder.path().join("out/summary.json"));
    let summary: serde_json::Value =
        serde_json::from_str(&summary.expect("it was written")).expect("JSON");
    // Through every one of the rows it would be 3e-8: the rounding of their numbers, at half their rate.
    let most = summary["error"]["max"]["position_m"].as_f64().expect("a number");
    assert!(most > 0.0 && most <= 2e-8, "{most:e} m");
}

#[test]
fn files_of_positions_are_way_points_and_logs() {
    let folder = tempfile::tempdir().expect("a folder");
    let place = |name: &str| folder.path().join(name).display().to_string();
    let point = |minute: u32, latitude: f64, height: &str| {
        format!(
            "<wpt lat=\"{latitude}\" lon=\"8.5\">{height}\
             <time>2026-05-01T10:{minute:02}:00Z</time></wpt>"
        )
    };
    let gpx = |height: &str| {
        let points: String = (0..4).map(|n| point(n, 47.0 + 0.01 * f64::from(n), height)).collect();
        format!(
            "<gpx version=\"1.1\" creator=\"t\" xmlns=\"http://www.topografix.com/GPX/1/1\">{points}</gpx>"
        )
    };
    let scene = place("scene.toml");
    let describe = |motion: &str| {
        let text = format!("rate_hz = 20\n[trajectory]\n{motion}\n");
        std::fs::write(&scene, text).expect("it can be written");
        schuler(&["trajectory", &scene])
    };
    std::fs::write(place("high.gpx"), gpx("<ele>500</ele>")).expect("it can be written");
    std::fs::write(place("flat.gpx"), gpx("")).expect("it can be written");
    // 0.03° of latitude is 3.335 km, in three minutes.
    for motion in [
        "waypoints = { file = \"high.gpx\" }",
        "waypoints = { file = \"flat.gpx\", altitude_m = 500 }",
        "attitude = \"upright\"\nlog = { file = \"high.gpx\", max_gap_s = 60 }",
    ] {
        let (done, text) = describe(motion);
        assert!(done && text.contains("3335 m") && text.contains("180 s"), "{motion}: {text}");
    }
    let (done, text) = describe("waypoints = { file = \"flat.gpx\" }");
    assert!(!done && text.contains("flat.gpx:1: has no height"), "{text}");
    let (done, text) = describe("waypoints = { file = \"high.gpx\", points = [] }");
    assert!(!done && text.contains("stands beside points"), "{text}");
}
