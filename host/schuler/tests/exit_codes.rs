//! The program as a user meets it: exit codes, what it says, and what it leaves behind.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn schuler(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_schuler"));
    command.current_dir(folder).args(arguments).output().unwrap()
}

/// Runs, and expects an exit code and words on the error stream.
fn expect(folder: &Path, arguments: &[&str], code: i32, words: &[&str]) {
    let done = schuler(folder, arguments);
    let said = String::from_utf8_lossy(&done.stderr);
    assert_eq!(done.status.code(), Some(code), "{arguments:?}: {said}");
    for word in words {
        assert!(said.contains(word), "{arguments:?} does not say {word}: {said}");
    }
}

const SCENE: &str = "duration_s = 2\nrate_hz = 20\n[trajectory]\nlatitude_deg = 45\n";

#[test]
fn a_run_succeeds_and_writes_its_files() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("still.toml"), SCENE).unwrap();
    expect(folder.path(), &["run", "still.toml"], 0, &[]);
    for file in ["summary.json", "drift.csv", "drift.png", "report.html"] {
        assert!(folder.path().join("out/still").join(file).is_file(), "{file}");
    }
}

#[test]
fn a_run_without_report_leaves_none_of_an_earlier_one() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("still.toml"), SCENE).unwrap();
    expect(folder.path(), &["run", "still.toml"], 0, &[]);
    expect(folder.path(), &["run", "still.toml", "--no-report"], 0, &[]);
    let mut left: Vec<_> = fs::read_dir(folder.path().join("out/still")).unwrap().collect();
    left.sort_by_key(|entry| entry.as_ref().unwrap().file_name());
    let left = left.into_iter().map(|entry| entry.unwrap().file_name());
    assert!(left.eq(["drift.csv", "summary.json"]));
}

#[test]
fn a_series_that_is_cut_short_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = ["run", "paper", "--duration", "30", "--window", "2,4,2", "--no-report"];
    expect(folder.path(), &[&arguments[..], &["--out", "o"]].concat(), 0, &[]);
    let summary = fs::read_to_string(folder.path().join("o/summary.json")).unwrap();
    let summary: serde_json::Value = serde_json::from_str(&summary).unwrap();
    let skipped = summary["skipped"].as_array().unwrap();
    let series =
        skipped.iter().find(|skipped| skipped["what"].as_str().unwrap().contains("series"));
    let series = series.unwrap_or_else(|| panic!("{skipped:?}"));
    assert_eq!(series["what"], "orders 4 to 22 of the window's series");
    assert!(series["saved"].as_str().unwrap().ends_with(" ns per sample"), "{series}");
}

#[test]
fn a_scene_is_not_written_over() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("still.toml");
    fs::write(&path, SCENE).unwrap();
    let arguments = ["emulate", "still.toml", "--out", "./still.toml"];
    expect(folder.path(), &arguments, 2, &["--out: is the file that the scene is read from"]);
    assert_eq!(fs::read_to_string(&path).unwrap(), SCENE);
    // A built-in scene is no file, whatever lies there.
    fs::write(folder.path().join("hard"), "").unwrap();
    expect(folder.path(), &["emulate", "hard", "--duration", "1", "--out", "hard"], 0, &[]);
}

#[test]
fn bad_input_is_told_and_leaves_nothing_behind() {
    let folder = tempfile::tempdir().unwrap();
    let cases: [(&str, &[&str]); 5] = [
        ("[navigator]\nwindow = { history = 1, block = 1, lookahead = 1 }\n", &[":6:", "2,4,2"]),
        (
            "[initial_error]\nattitude_down_arcsec = 1e9\n",
            &[":6:", "attitude_down_arcsec", "648000"],
        ),
        (
            "[navigator]\nprecision = \"f32x2\"\nalgorithm = \"textbook\"\n",
            &["bad.toml:6:", "navigator.precision", "f64"],
        ),
        ("[link]\njitter_s = 0.04\n", &[":6:", "jitter_s"]),
        ("[navigator]\nframe = \"sideways\"\n", &[":6:", "frame", "local-level"]),
    ];
    for (text, words) in cases {
        fs::write(folder.path().join("bad.toml"), format!("{SCENE}{text}")).unwrap();
        expect(folder.path(), &["run", "bad.toml"], 2, words);
        assert!(!folder.path().join("out").exists(), "{text}");
    }
}

#[test]
fn a_start_at_a_pole_names_the_line_or_the_option() {
    let folder = tempfile::tempdir().unwrap();
    let at_pole = SCENE.replace("= 45", "= { offset = -90 }");
    fs::write(folder.path().join("pole.toml"), at_pole).unwrap();
    let words = ["pole.toml:4: trajectory.latitude_deg: ", "cannot start at a pole", "earth-fixed"];
    expect(folder.path(), &["run", "pole.toml"], 2, &words);
    let words = ["--frame: the local-level frame cannot start at a pole", "earth-fixed"];
    expect(folder.path(), &["run", "pole.toml", "--frame", "local-level"], 2, &words);
    assert!(!folder.path().join("out").exists());
    expect(folder.path(), &["run", "pole.toml", "--frame", "earth-fixed"], 0, &[]);
    expect(folder.path(), &["emulate", "pole.toml", "--out", "imu.csv"], 0, &[]);
    let high = format!("{SCENE}altitude_m = 999999\n[initial_error]\ndown_m = -2\n");
    fs::write(folder.path().join("high.toml"), high).unwrap();
    let words = ["high.toml:3: trajectory: the initial position"];
    expect(folder.path(), &["run", "high.toml"], 2, &words);
}

#[test]
fn a_run_that_cannot_go_on_says_where() {
    let folder = tempfile::tempdir().unwrap();
    let lossy = format!("{SCENE}[link]\nloss = 0.5\n");
    fs::write(folder.path().join("lossy.toml"), lossy).unwrap();
    expect(folder.path(), &["run", "lossy.toml"], 1, &["sample", "lost", "bridge"]);
    let arguments = ["run", "polar", "--frame", "local-level", "--out", "a/b"];
    expect(folder.path(), &arguments, 1, &["sample", "pole", "earth-fixed"]);
    let nothing = format!("{SCENE}[navigator]\ngap = \"bridge\"\n[link]\nloss = 0.999999\n");
    fs::write(folder.path().join("nothing.toml"), nothing).unwrap();
    let words = ["sample 40 at 2 s", "lost", "no sample arrived to bridge from"];
    expect(folder.path(), &["run", "nothing.toml"], 1, &words);
    // What was flown is there, and says that it is not all.
    for made in ["a/b", "out/lossy", "out/nothing"] {
        let summary = fs::read_to_string(folder.path().join(made).join("summary.json")).unwrap();
        assert!(summary.contains("\"ended\": {"), "{summary}");
    }
    let spin = format!("{SCENE}roll_deg = {{ rate = 1e4 }}\n");
    fs::write(folder.path().join("spin.toml"), spin).unwrap();
    expect(folder.path(), &["run", "spin.toml"], 1, &["sample 1", "turns a block"]);
}

#[test]
fn an_emulated_stream_is_replayed_to_where_it_went() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    expect(folder.path(), &["emulate", "hard", "--out", "imu.csv", "--perfect"], 0, &[]);
    let initial = "time_s = 0\nlatitude_deg = 45.00000089933829\nlongitude_deg = 100\n\
        altitude_m = 3500.1\nnorth_m_s = 0\neast_m_s = 0\ndown_m_s = 0\n\
        roll_deg = 0\npitch_deg = 5\nyaw_deg = 5\n";
    // 0.1 m north of 45°: 0.1/(R_M + 3500 m) is 8.99338e-7°.
    fs::write(at("initial.toml"), initial).unwrap();
    let replay = |out: &'static str, more: &[&'static str]| {
        let arguments = ["replay", "--imu", "imu.csv", "--initial", "initial.toml", "--out", out];
        [&arguments[..], more].concat()
    };
    expect(folder.path(), &replay("nav.csv", &[]), 0, &[]);
    let nav = fs::read_to_string(at("nav.csv")).unwrap();
    assert_eq!(nav.lines().count(), 6001);
    let last: Vec<f64> =
        nav.lines().last().unwrap().split(',').map(|x| x.parse().unwrap()).collect();
    let altitude_m = last[3];
    assert!((altitude_m - 3500.1).abs() < 1e-6, "{altitude_m}");

    expect(folder.path(), &replay("imu.csv", &[]), 2, &["--out", "--imu"]);
    expect(folder.path(), &replay("x.csv", &["--until", "-1"]), 2, &["--until"]);
    expect(folder.path(), &replay("x.csv", &["--start", "3"]), 2, &["--start", "--align"]);
    let starts = |more: &[&'static str], option: &str, time_s: &str| {
        let words = [option, &format!("navigation would start at {time_s} s"), "0 to 60 s"];
        expect(folder.path(), &replay("x.csv", more), 2, &words);
    };
    starts(&["--start", "5", "--align", "80"], "--align: ", "85");
    starts(&["--align", "100"], "--align: ", "100");
    starts(&["--start", "61"], "--start: ", "61");
    let before = ["--start: alignment would begin at 61 s", "0 to 60 s"];
    expect(folder.path(), &replay("x.csv", &["--start", "61", "--align", "2"]), 2, &before);
    let none = ["--start", "5", "--align", "0.016"];
    expect(folder.path(), &replay("x.csv", &none), 2, &["--align: no sample starts at 5.016 s"]);

    let imu = fs::read_to_string(at("imu.csv")).unwrap();
    let gap = |line: usize| !(50..53).contains(&line);
    let holed: Vec<_> =
        imu.lines().enumerate().filter(|(line, _)| gap(*line)).map(|(_, text)| text).collect();
    fs::write(at("imu.csv"), holed.join("\n")).unwrap();
    expect(folder.path(), &replay("gap.csv", &[]), 1, &["imu.csv:51", "3 samples", "bridge"]);
    assert!(!at("gap.csv").exists());
    expect(folder.path(), &replay("gap.csv", &["--gap", "bridge"]), 0, &[]);
    assert_eq!(fs::read_to_string(at("gap.csv")).unwrap().lines().count(), 6001);
    // What is missing while it stands still is told as well.
    let still = ["emulate", "stationary", "--rate", "100", "--duration", "2", "--out", "imu.csv"];
    expect(folder.path(), &still, 0, &[]);
    let imu = fs::read_to_string(at("imu.csv")).unwrap();
    let holed: Vec<_> =
        imu.lines().enumerate().filter(|(line, _)| gap(*line)).map(|(_, text)| text).collect();
    fs::write(at("imu.csv"), holed.join("\n")).unwrap();
    let words = ["imu.csv:51", "3 samples", "bridge"];
    expect(folder.path(), &replay("still.csv", &["--align", "1"]), 1, &words);
    let bridge = replay("still.csv", &["--align", "1", "--gap", "bridge"]);
    let said = String::from_utf8(schuler(folder.path(), &bridge).stdout).unwrap();
    assert!(said.contains("\naligned on 97 samples, 3 missing: roll "), "{said}");
}
