//! The truth and the start that leave the program, and that a navigator of any kind finds its way by them.

use super::replay::{apart, program, rows};
use super::{near, scratch, text};
use schuler::solution::{Euler, Solution};
use schuler_simulator::recording::navigation::{COLUMNS, NavigationRow};
use std::f64::consts::FRAC_PI_2;
use std::fs;
use std::path::Path;

/// The largest distance between rows of the same times, m; every row must have one.
fn worst(nav: &[Vec<f64>], truth: &[Vec<f64>]) -> f64 {
    assert_eq!(nav.len(), truth.len());
    let apart = nav.iter().zip(truth).map(|(computed, true_row)| {
        assert_eq!(computed[0], true_row[0]);
        apart(computed, true_row)
    });
    apart.fold(0.0, f64::max)
}

#[test]
fn a_stream_is_replayed_to_the_truth_beside_it() {
    for (scene, frame) in [
        ("paper-perfect", "local-level"),
        ("hard", "earth-fixed"),
        ("cruise-180", "local-level"),
        ("polar", "earth-fixed"),
    ] {
        let folder = scratch();
        let at = |name: &str| folder.path().join(name);
        let (imu, truth, initial, nav) = ("imu.csv", "truth.csv", "initial.toml", "nav.csv");
        let (imu, truth, initial, nav) = (at(imu), at(truth), at(initial), at(nav));
        let duration = ["--duration", if scene == "hard" { "60" } else { "600" }];
        let line = ["emulate", scene, "--perfect", "--out", text(&imu), "--truth", text(&truth)];
        program(&[&line[..], &duration].concat()).unwrap_or_else(|e| panic!("{e}"));
        let line =
            ["replay", "--imu", text(&imu), "--initial", text(&initial), "--out", text(&nav)];
        program(&[&line[..], &["--frame", frame]].concat()).unwrap_or_else(|e| panic!("{e}"));

        let header = fs::read_to_string(&truth).expect("it is there");
        assert_eq!(header.lines().next(), Some(COLUMNS.join(",").as_str()));
        let truth = rows(&truth);
        assert_eq!(truth[0][0], 0.0, "the start is row 0");
        let off = worst(&rows(&nav), &truth[1..]);
        assert!(off < 1e-8, "{scene}: {off} m");
    }
}

#[test]
fn a_start_is_written_to_the_last_digit() {
    let folder = scratch();
    let out = folder.path().join("imu.csv");
    program(&["emulate", "paper", "--duration", "1", "--out", text(&out)]).expect("it is a scene");
    let initial = fs::read_to_string(folder.path().join("initial.toml")).expect("it is there");
    for line in ["latitude_deg = 50.0", "altitude_m = 5500.0", "pitch_deg = 5.0", "yaw_deg = 5.0"] {
        assert!(initial.lines().any(|written| written == line), "{line}: {initial}");
    }
    assert!(initial.starts_with("# The start of paper: for `schuler replay"), "{initial}");

    // Angles of every size, near a pitch of 90°, too: the attitude they lead back to is the same.
    for (roll, pitch, yaw) in [
        (0.1, -0.2, 3.0),
        (-3.1, 1.5, -2.9),
        (3.0, FRAC_PI_2 - 1e-6, 0.7),
        (1.0, 1e-10 - FRAC_PI_2, 2.0),
    ] {
        let attitude = Euler { roll, pitch, yaw };
        let solution = Solution { attitude: attitude.quaternion_pair(), ..Default::default() };
        let again = NavigationRow::start(0.0, &solution).solution();
        let rest = again.attitude.conjugate() * solution.attitude;
        let off = rest.v.map(|part| 2.0 * part.hi).norm();
        assert!(off < 1e-15, "{attitude:?}: {off:e} rad");
    }
}

#[test]
fn what_is_lost_is_missing_in_the_stream_alone() {
    let folder = scratch();
    let at = |name: &str| folder.path().join(name);
    let scene = "duration_s = 2\nrate_hz = 20\n[trajectory]\nlatitude_deg = 45\n\
        [initial_error]\nnorth_m = 100\nattitude_down_arcsec = 3600\n[link]\nloss = 0.2\n";
    fs::write(at("lossy.toml"), scene).expect("the disk has room");
    let (lossy, imu, truth) = (at("lossy.toml"), at("imu.csv"), at("truth.csv"));
    program(&["emulate", text(&lossy), "--out", text(&imu), "--truth", text(&truth)])
        .unwrap_or_else(|e| panic!("{e}"));
    assert!(rows(&imu).len() < 40);
    assert_eq!(rows(&truth).len(), 41);
    // The start is off as the scene says, the truth is not.
    let initial = NavigationRow::read(text(&at("initial.toml"))).unwrap_or_else(|e| panic!("{e}"));
    near((initial.position.latitude.to_degrees() - 45.0) * 111_131.7, 100.0, 0.1);
    near(initial.attitude.yaw.to_degrees(), 1.0, 1e-12);
    assert_eq!(rows(&truth)[0][1], 45.0);
    let words = fs::read_to_string(at("initial.toml")).expect("it is there");
    assert!(words.contains("off by its initial_error"), "{words}");
}

#[test]
fn no_file_is_written_over_another() {
    let folder = scratch();
    let at = |name: &str| folder.path().join(name);
    let scene = "duration_s = 1\nrate_hz = 20\n";
    fs::write(at("initial.toml"), scene).expect("the disk has room");
    let emulate = |scene: &Path, out: &Path, truth: &Path| {
        program(&["emulate", text(scene), "--out", text(out), "--truth", text(truth)])
    };
    let message = emulate(&at("initial.toml"), &at("imu.csv"), &at("truth.csv"));
    let message = message.expect_err("the scene is there");
    assert!(
        message.contains("--out: initial.toml beside it is the file that the scene"),
        "{message}"
    );
    assert_eq!(fs::read_to_string(at("initial.toml")).expect("it is there"), scene);
    fs::rename(at("initial.toml"), at("scene.toml")).expect("it is there");
    for (out, truth, words) in [
        ("a.csv", "a.csv", "--truth: is the file that --out writes; accepted: another file"),
        ("a.csv", "initial.toml", "--out: initial.toml beside it is the file that --truth writes"),
        ("initial.toml", "t.csv", "--out: initial.toml beside it is the file that --out writes"),
        ("a.csv", "scene.toml", "--truth: is the file that the scene is read from"),
    ] {
        let message = emulate(&at("scene.toml"), &at(out), &at(truth)).expect_err(words);
        assert!(message.contains(words), "{message}");
    }
    let left = fs::read_dir(folder.path()).expect("it is there").count();
    assert_eq!(left, 1, "only the scene");
}

#[test]
fn a_run_leaves_its_rows_where_they_are_wanted() {
    let folder = scratch();
    let out = folder.path().join("o");
    let run = |more: &[&str]| {
        let line = ["run", "paper-perfect", "--duration", "10", "--no-report", "--out", text(&out)];
        program(&[&line[..], more].concat()).unwrap_or_else(|e| panic!("{e}"));
    };
    run(&["--rows"]);
    let times = |name: &str| -> Vec<f64> { rows(&out.join(name)).iter().map(|r| r[0]).collect() };
    assert_eq!(times("nav.csv").len(), 201);
    assert_eq!(times("nav.csv"), times("drift.csv"));
    assert_eq!(times("truth.csv"), times("drift.csv"));
    let off = worst(&rows(&out.join("nav.csv")), &rows(&out.join("truth.csv")));
    assert!(off > 0.0 && off < 1e-8, "{off} m");
    run(&["--rows", "--every", "80"]);
    assert_eq!(times("nav.csv"), [0.0, 4.0, 8.0, 10.0]);
    assert_eq!(times("truth.csv"), times("nav.csv"));
    // Those of an earlier flight go, what is somebody else's stays.
    run(&[]);
    assert!(!out.join("nav.csv").exists() && !out.join("truth.csv").exists());
    fs::write(out.join("nav.csv"), "mine").expect("the disk has room");
    run(&[]);
    assert_eq!(fs::read_to_string(out.join("nav.csv")).expect("it is there"), "mine");
}
