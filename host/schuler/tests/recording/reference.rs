//! Replays beside a reference: drift at its times, its lag, and where the report goes.

use super::replay::{program, rows};
use super::{near, scratch, text};
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// A scene's stream with its start and truth, in a folder of their own.
struct Emulated {
    folder: TempDir,
}

impl Emulated {
    fn new(options: &str) -> Self {
        let folder = scratch();
        let at = |name: &str| text(&folder.path().join(name)).to_owned();
        let (imu, truth) = (at("imu.csv"), at("truth.csv"));
        let line: Vec<_> = ["emulate"].into_iter().chain(options.split_whitespace()).collect();
        program(&[&line[..], &["--out", &imu, "--truth", &truth]].concat())
            .unwrap_or_else(|e| panic!("{e}"));
        Self { folder }
    }

    fn at(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// Replays beside a reference into a folder; the rows of its drift.csv.
    fn drift(&self, reference: &str, more: &[&str]) -> Result<Vec<Vec<f64>>, String> {
        self.replay(reference, "o/", more)?;
        Ok(rows(&self.at("o/drift.csv")))
    }

    fn replay(&self, reference: &str, out: &str, more: &[&str]) -> Result<(), String> {
        let out = format!("{}/{out}", text(self.folder.path()));
        let [imu, initial, reference] =
            ["imu.csv", "initial.toml", reference].map(|name| self.at(name));
        let line = ["replay", "--imu", text(&imu), "--initial", text(&initial), "--out", &out];
        program(&[&line[..], &["--reference", text(&reference)], more].concat())
    }

    /// The truth, rewritten line by line.
    fn rewritten(&self, name: &str, mut line: impl FnMut(usize, &str) -> Option<String>) {
        let truth = fs::read_to_string(self.at("truth.csv")).expect("it is there");
        let lines = truth.lines().enumerate().filter_map(|(i, text)| line(i, text));
        fs::write(self.at(name), lines.collect::<Vec<_>>().join("\n")).expect("the disk has room");
    }

    /// The truth with stamps that are late, s.
    fn late(&self, name: &str, lag_s: f64) {
        self.rewritten(name, |i, line| {
            let (time, rest) = line.split_once(',').expect("columns");
            let time: f64 =
                if i == 0 { return Some(line.to_owned()) } else { time.parse().expect("a number") };
            Some(format!("{},{rest}", time + lag_s))
        });
    }
}

fn largest(rows: &[Vec<f64>], columns: std::ops::Range<usize>) -> f64 {
    rows.iter().flat_map(|row| &row[columns.clone()]).fold(0.0, |most: f64, x| most.max(x.abs()))
}

fn estimated(folder: &Path) -> (f64, f64) {
    let summary = fs::read_to_string(folder.join("summary.json")).expect("it is there");
    let summary: serde_json::Value = serde_json::from_str(&summary).expect("it is JSON");
    let number = |key: &str| summary["compared"][key].as_f64().expect("a number");
    (number("estimated_lag_s"), number("estimated_lag_sigma_s"))
}

#[test]
fn drift_is_found_at_the_reference_s_own_times() {
    // The truth of the same motion at 37 Hz: no time but the start is that of a sample.
    let fast = Emulated::new("manoeuvre --perfect --duration 30");
    let slow = Emulated::new("manoeuvre --perfect --duration 30 --rate 37");
    fs::copy(slow.at("truth.csv"), fast.at("slow.csv")).expect("both are there");
    let drift = fast.drift("slow.csv", &[]).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(drift.len(), 1 + 30 * 37);
    near(drift[1][0], 1.0 / 37.0, 1e-12);
    // (9/384) h⁴ p⁗ with h = 10 ms, 68 m at 1.2 rad/s and 60 m at 0.7: 4e-8 m
    let off = largest(&drift, 1..4);
    assert!(off < 1e-7, "{off} m");
    // Roll of 6.5 rad at 0.8 rad/s, seen from a body that turns: 2e-9 rad are 4e-4 arcsec
    let turned = largest(&drift, 7..10);
    assert!(turned < 2e-3, "{turned} arcsec");
    // At samples' own times there is nothing to interpolate.
    let own = fast.drift("truth.csv", &[]).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(own.len(), 3001);
    let off = largest(&own, 1..4);
    assert!(off < 1e-8, "{off} m");
}

#[test]
fn late_stamps_are_told_and_taken_out_when_asked() {
    let flight = Emulated::new("manoeuvre --duration 90");
    for lag_s in [0.0837, -3.21, 18.0, 0.0] {
        flight.late("late.csv", lag_s);
        let plain = flight.drift("late.csv", &[]).unwrap_or_else(|e| panic!("{e}"));
        let (found_s, sigma_s) = estimated(&flight.at("o"));
        near(found_s, lag_s, 1e-6);
        assert!(sigma_s < 1e-6, "{sigma_s}");
        // 360 m/s for so long.
        let off = largest(&plain, 1..4);
        assert!(lag_s == 0.0 || off > 200.0 * lag_s.abs(), "{lag_s}: {off} m");
        let taken = flight.drift("late.csv", &["--lag", "auto"]).unwrap_or_else(|e| panic!("{e}"));
        let off = largest(&taken, 1..4);
        assert!(off < 1e-3, "{lag_s}: {off} m");
        let lag = format!("--lag={lag_s}");
        let stated = flight.drift("late.csv", &[&lag]).unwrap_or_else(|e| panic!("{e}"));
        let off = largest(&stated, 1..4);
        assert!(off < 1e-6, "{lag_s}: {off} m");
    }
}

#[test]
fn a_lag_is_found_through_noise_and_drift_or_not_told() {
    // Errors of a navigation-grade unit, and positions of a receiver: 2 m, five times a second.
    let scene = "duration_s = 300\nrate_hz = 50\n[trajectory]\n\
        latitude_deg = { offset = 45, harmonics = [{ amplitude = 0.002, period_s = 40 }] }\n\
        longitude_deg = { harmonics = [{ amplitude = 0.003, period_s = 61 }] }\n\
        [gyro]\nconstant_deg_h = 0.1\n[accelerometer]\nconstant_ug = 100\n";
    let scenes = scratch();
    let path = scenes.path().join("drive.toml");
    fs::write(&path, scene).expect("the disk has room");
    let drive = Emulated::new(text(&path));
    let mut uniform = super::scattered(7);
    drive.late("late.csv", 0.35);
    let late = fs::read_to_string(drive.at("late.csv")).expect("it is there");
    let mut receiver = "latitude_deg,time_s,longitude_deg,satellites,altitude_m\n".to_owned();
    for line in late.lines().skip(1).step_by(10) {
        let numbers: Vec<f64> = line.split(',').map(|n| n.parse().expect("a number")).collect();
        let mut noise = || 6.9 * (uniform() - 0.5);
        let (north, east, up) = (noise(), noise(), noise());
        let (latitude, longitude) = (numbers[1] + north / 111_132.0, numbers[2] + east / 78_847.0);
        receiver += &format!("{latitude},{},{longitude},9,{}\n", numbers[0], numbers[3] + up);
    }
    fs::write(drive.at("receiver.csv"), receiver).expect("the disk has room");
    let drift = drive.drift("receiver.csv", &[]).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(drift[0].len(), 4, "a time and a position");
    let (found_s, sigma_s) = estimated(&drive.at("o"));
    assert!(sigma_s < 0.02, "{sigma_s}");
    near(found_s, 0.35, 4.0 * sigma_s);
    let page = fs::read_to_string(drive.at("o/report.html")).expect("it is there");
    assert!(page.contains("it has no velocities and attitudes"), "the page says what it lacks");
    assert!(page.contains("columns not compared: satellites"), "and what it has besides");
    // The horizontal error and the end, drift, the motion, six sensors.
    assert_eq!(page.matches("<figure").count(), 3 + 3 + 2 + 6);

    // What stands still tells no lag.
    let still = Emulated::new("stationary --duration 60");
    still.drift("truth.csv", &[]).unwrap_or_else(|e| panic!("{e}"));
    let summary = fs::read_to_string(still.at("o/summary.json")).expect("it is there");
    assert!(summary.contains("\"estimated_lag_s\": null"), "{summary}");
    let message = still.drift("truth.csv", &["--lag", "auto"]).expect_err("nothing moves");
    assert!(message.starts_with("--lag: the motion does not tell"), "{message}");
}

#[test]
fn a_reference_that_cannot_be_is_refused() {
    let flight = Emulated::new("hard --perfect --duration 5");
    let refused = |name: &str, words: &str| {
        let message = flight.drift(name, &[]).expect_err(words);
        assert!(message.contains(words), "{message}");
        assert!(!flight.at("o").exists(), "{words}");
    };
    flight.rewritten("back.csv", |i, line| {
        Some(if i == 9 { format!("-1{line}") } else { line.to_owned() })
    });
    refused("back.csv", "back.csv:10: time_s: -1");
    flight.rewritten("words.csv", |i, line| {
        Some(if i == 9 { line.replacen(',', ",x", 1) } else { line.to_owned() })
    });
    refused("words.csv", "words.csv:10: latitude_deg: \"x");
    flight.rewritten("short.csv", |i, line| {
        Some(if i == 9 { "1,2,3".to_owned() } else { line.to_owned() })
    });
    refused("short.csv", "short.csv:10: the row has 3 values; accepted: 10");
    flight.rewritten("lacks.csv", |_, line| line.rsplit_once(',').map(|(line, _)| line.to_owned()));
    refused(
        "lacks.csv",
        "lacks.csv:1: the header lacks yaw_deg; accepted: all of an attitude or none",
    );
    flight.rewritten("height.csv", |_, line| Some(line.replace("altitude_m", "height_m")));
    refused("height.csv", "height.csv:1: the header lacks altitude_m");
    flight.rewritten("twice.csv", |_, line| Some(line.replace("yaw_deg", "pitch_deg")));
    refused("twice.csv", "twice.csv:1: pitch_deg: is there twice");
    flight.rewritten("one.csv", |i, line| (i < 2).then(|| line.to_owned()));
    refused("one.csv", "one.csv: has 1 rows; accepted: two rows or more");
    flight.late("later.csv", 1e4);
    refused(
        "later.csv",
        "--reference: has no row from 0 to 5 s, which is flown: its own are from 10000 to 10005 s",
    );
    for out in ["truth.csv", "imu.csv"] {
        let message = flight.replay("truth.csv", out, &[]).expect_err("it is read");
        assert!(message.starts_with("--out: is the file that --"), "{message}");
    }
}

#[test]
fn a_report_has_a_folder_and_rows_have_their_file() {
    let flight = Emulated::new("hard --perfect --duration 5");
    let names = |folder: &str| {
        let names = fs::read_dir(flight.at(folder)).expect("it is there");
        let mut names: Vec<_> = names
            .map(|entry| entry.expect("an entry").file_name().into_string().expect("text"))
            .collect();
        names.sort();
        names
    };
    let report = ["drift.csv", "drift.png", "report.html", "summary.json"];
    flight.replay("truth.csv", "nav.csv", &[]).unwrap_or_else(|e| panic!("{e}"));
    assert!(flight.at("nav.csv").is_file());
    assert_eq!(names("nav-report"), report);
    flight.replay("truth.csv", "new/er/", &[]).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(
        names("new/er"),
        ["drift.csv", "drift.png", "nav.csv", "report.html", "summary.json"]
    );
    let page = fs::read_to_string(flight.at("new/er/report.html")).expect("it is there");
    assert_eq!(page.matches("<figure").count(), 2 + 9 + 3 + 5 + 6);
    for outside in ["src=\"", "href=\"", "url(\"", "url(h", "@import", "fetch("] {
        assert!(!page.contains(outside), "{outside}");
    }
    assert_eq!(rows(&flight.at("nav.csv")), rows(&flight.at("new/er/nav.csv")));
    // Without a reference a folder has the rows alone.
    let (imu, initial) = (flight.at("imu.csv"), flight.at("initial.toml"));
    fs::create_dir(flight.at("there")).expect("it is not there yet");
    let there = flight.at("there");
    program(&["replay", "--imu", text(&imu), "--initial", text(&initial), "--out", text(&there)])
        .unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(names("there"), ["nav.csv"]);
}

#[test]
fn a_vertical_is_held_to_what_is_known() {
    // 1 mg up takes a free vertical 176 m away in a minute.
    let folder = scratch();
    let path = folder.path().join("climb.toml");
    let scene = "duration_s = 60\nrate_hz = 20\n[trajectory]\nlatitude_deg = 45\n\
        altitude_m = { offset = 100, rate = 2 }\n[accelerometer]\nconstant_ug = [0, 0, 10000]\n";
    fs::write(&path, scene).expect("the disk has room");
    let climb = Emulated::new(text(&path));
    let down = |more: &[&str]| {
        let drift = climb.drift("truth.csv", more).unwrap_or_else(|e| panic!("{e}"));
        drift.last().expect("rows")[3]
    };
    assert!(down(&[]) > 100.0);
    let truth = climb.at("truth.csv");
    let held = down(&["--height", text(&truth)]);
    assert!(held.abs() < 0.01, "{held} m");
    let drift = rows(&climb.at("o/drift.csv"));
    let sinks = largest(&drift, 6..7);
    // A window of twelve samples at 0.098 m/s².
    assert!(sinks < 0.07, "{sinks} m/s");
    // 120 m below, at the end.
    near(down(&["--height", "100"]), 120.0, 0.01);
    near(down(&["--vertical", "held"]), 120.0, 0.01);
    near(down(&["--vertical", "held", "--height", "-20.5"]), 240.5, 0.01);
    let refused = |more: &[&str], words: &str| {
        let message = climb.drift("truth.csv", more).expect_err(words);
        assert!(message.contains(words), "{message}");
    };
    refused(
        &["--vertical", "free", "--height", "3"],
        "--height: holds the vertical, which is to be free",
    );
    refused(&["--height", "1e7"], "10000000 is out of range");
    climb.rewritten("early.csv", |i, line| (i < 600).then(|| line.to_owned()));
    let early = climb.at("early.csv");
    refused(
        &["--height", text(&early)],
        "early.csv: has heights from 0 to 29.9 s alone; accepted: heights from 0 to 60 s",
    );
    climb.rewritten("bare.csv", |_, line| line.split_once(',').map(|(_, rest)| rest.to_owned()));
    let bare = climb.at("bare.csv");
    refused(
        &["--height", text(&bare)],
        "bare.csv:1: the header lacks time_s; accepted: time_s,altitude_m",
    );
}
