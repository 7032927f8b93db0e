//! `schuler allan` as a user meets it.

use std::fs;
use std::path::Path;
use std::process::Command;

fn schuler(folder: &Path, arguments: &[&str]) -> (Option<i32>, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_schuler"));
    let done = command.current_dir(folder).args(arguments).output().unwrap();
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (done.status.code(), text(&done.stdout), text(&done.stderr))
}

const SCENE: &str = "duration_s = 120\nrate_hz = 50\n[trajectory]\nlatitude_deg = 45\n\
    [gyro]\nangle_random_walk_deg_sqrt_h = 0.1\n\
    [accelerometer]\nvelocity_random_walk_m_s_sqrt_h = 0.05\n";

/// A folder with a scene and what its sensors read.
fn recorded() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("still.toml"), SCENE).unwrap();
    let (code, _, said) = schuler(folder.path(), &["emulate", "still.toml", "--out", "imu.csv"]);
    assert_eq!(code, Some(0), "{said}");
    folder
}

/// The recording with each row's numbers changed; `None` leaves a row out.
fn change(folder: &Path, by: impl Fn(usize, Vec<f64>) -> Option<Vec<f64>>) {
    let text = fs::read_to_string(folder.join("imu.csv")).unwrap();
    let (header, rows) = text.split_once('\n').unwrap();
    let rows = rows.lines().enumerate().filter_map(|(i, row)| {
        let values = by(i, row.split(',').map(|x| x.parse().unwrap()).collect())?;
        let values: Vec<_> = values.iter().map(f64::to_string).collect();
        Some(values.join(",") + "\n")
    });
    let rows: String = rows.collect();
    fs::write(folder.join("other.csv"), format!("{header}\n{rows}")).unwrap();
}

#[test]
fn a_recording_becomes_a_section_that_flies() {
    let folder = recorded();
    let folder = folder.path();
    let arguments = ["allan", "still.toml", "--imu", "imu.csv", "--out", "found"];
    let (code, out, said) = schuler(folder, &arguments);
    assert_eq!(code, Some(0), "{said}{out}");
    assert!(out.contains("agrees") && !out.contains("DIFFERS"), "{out}");
    assert!(out.lines().all(|line| line.chars().count() <= 120), "{out}");
    let sections = fs::read_to_string(folder.join("found/sensors.toml")).unwrap();
    let scene =
        format!("duration_s = 10\nrate_hz = 50\n[trajectory]\nlatitude_deg = 45\n{sections}");
    fs::write(folder.join("twin.toml"), scene).unwrap();
    let (code, _, said) = schuler(folder, &["emulate", "twin.toml", "--out", "twin.csv"]);
    assert_eq!(code, Some(0), "{said}");
    let page = fs::read_to_string(folder.join("found/allan.html")).unwrap();
    assert_eq!(page.matches("<figure").count(), 2);
    for figure in page.split("application/json\">").skip(1) {
        let json = figure.split("</script>").next().unwrap();
        let tree: serde_json::Value = serde_json::from_str(json).expect(json);
        assert_eq!((&tree["x"]["log"], &tree["y"]["log"]), (&true.into(), &true.into()));
        // A line, an interval and dots for each axis.
        assert!(tree["layers"].as_array().unwrap().len() >= 9, "{json}");
    }
    let csv = fs::read_to_string(folder.join("found/allan.csv")).unwrap();
    assert!(
        csv.starts_with("axis,tau_s,differences,deviation,lower_95,upper_95,fitted,configured\n")
    );
}

#[test]
fn a_scene_that_says_less_noise_is_refused() {
    let folder = recorded();
    let folder = folder.path();
    fs::write(folder.join("less.toml"), SCENE.replace("= 0.1\n", "= 0.09\n")).unwrap();
    let (code, out, _) = schuler(folder, &["allan", "less.toml", "--imu", "imu.csv"]);
    assert_eq!(code, Some(1), "{out}");
    assert!(out.contains("DIFFERS"), "{out}");
}

#[test]
fn what_is_no_sensor_at_rest_is_told() {
    let folder = recorded();
    let folder = folder.path();
    let refused = |words: &[&str], more: &[&str]| {
        let arguments = [&["allan", "--imu", "other.csv"], more].concat();
        let (code, _, said) = schuler(folder, &arguments);
        assert_eq!(code, Some(2), "{said}");
        for word in words {
            assert!(said.contains(word), "{word}: {said}");
        }
    };
    // Somebody leans on it for a second.
    change(folder, |i, mut row| {
        row[4] += if (3000..3050).contains(&i) { 0.02 } else { 0.0 };
        Some(row)
    });
    refused(
        &["moves from", "accelerometer", "accepted: a span at rest; the longest is --span"],
        &[],
    );
    let (code, out, said) = schuler(folder, &["allan", "--imu", "other.csv", "--span", "0..55"]);
    assert_eq!(code, Some(0), "{said}{out}");
    change(folder, |i, row| (!(1000..1100).contains(&i)).then_some(row));
    refused(&["other.csv:", "samples are missing", "--span"], &[]);
    change(folder, |i, row| (i < 20).then_some(row));
    refused(&["has 20 samples", "32 samples or more"], &[]);
    // Rates under the header of increments.
    change(folder, |_, row| {
        Some(row.iter().enumerate().map(|(i, x)| if i > 0 { x * 50.0 } else { *x }).collect())
    });
    refused(&["these look like rates", "--units rates"], &[]);
    change(folder, |_, mut row| {
        row[2] = 1e-6;
        Some(row)
    });
    let (code, out, said) = schuler(folder, &["allan", "--imu", "other.csv"]);
    assert_eq!(code, Some(0), "{said}");
    assert!(out.contains("gyro y reads the same at every sample"), "{out}");
}

#[test]
fn perfect_sensors_have_nothing_to_show() {
    let folder = tempfile::tempdir().unwrap();
    let (code, _, said) = schuler(folder.path(), &["allan", "stationary", "--duration", "30"]);
    assert!(code == Some(2) && said.contains("no sensor has an error"), "{said}");
}
