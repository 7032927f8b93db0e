//! What contradicts itself is refused with what it looks like, aligned or not; stated, it is taken.

use super::{INITIAL, at_rest, change, replay};
use schuler_simulator::recording::csv::{INCREMENTS, RATES};
use std::fs;
use std::path::Path;

const G: f64 = 9.80665;
const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// Refused with these words, with --align and without.
fn refused(folder: &Path, imu: &str, words: &[&str]) {
    for more in [&["--align", "20"][..], &[]] {
        let (code, _, said) = replay(folder, imu, more);
        assert_eq!(code, Some(2), "{imu} {more:?}: {said}");
        for word in words {
            assert!(said.contains(word), "{imu} {more:?} does not say {word}: {said}");
        }
        assert!(!folder.join("nav.csv").exists(), "{imu} {more:?}");
    }
}

/// Scales angles and velocities.
fn scaled(angle: f64, velocity: f64) -> impl Fn(usize, [f64; 6]) -> [f64; 6] {
    move |_, v| std::array::from_fn(|i| v[i] * if i < 3 { angle } else { velocity })
}

#[test]
fn units_are_named_and_taken_when_stated() {
    let folder = at_rest();
    let folder = folder.path();
    for (angle, velocity, words, units) in [
        (1.0, 1.0 / G, "these look like g (× 9.80665)", "g"),
        (1.0, 1e3 / G, "these look like mg", "mg"),
        (1.0, 1.0 / 0.3048, "these look like ft/s2", "ft/s2"),
        (1.0 / DEGREE, 1.0, "these look like deg/s", "deg/s"),
        (3600.0 / DEGREE, 1.0, "these look like deg/h", "deg/h"),
        (1e3, 1.0, "these look like mrad/s", "mrad/s"),
        (1.0 / DEGREE, 1.0 / G, "these look like g", "g,deg/s"),
    ] {
        change(folder, "imu.csv", "other.csv", None, scaled(angle, velocity));
        refused(folder, "other.csv", &[words, &format!("accepted: --units {units}\n")]);
        let (code, out, said) = replay(folder, "other.csv", &["--align", "20", "--units", units]);
        assert_eq!((code, said.as_str()), (Some(0), ""), "{units}");
        assert!(out.contains("roll 3.0000°, pitch -7.0000°, heading 40.0000°"), "{out}");
        fs::remove_file(folder.join("nav.csv")).unwrap();
    }
}

#[test]
fn a_wrong_header_is_named_and_overruled() {
    let folder = at_rest();
    let folder = folder.path();
    let same = scaled(1.0, 1.0);
    change(folder, "imu.csv", "one.csv", Some(&RATES.join(",")), &same);
    change(folder, "rates.csv", "two.csv", Some(&INCREMENTS.join(",")), &same);
    for (file, kind) in [("one.csv", "increments"), ("two.csv", "rates")] {
        refused(
            folder,
            file,
            &[&format!("{kind} under a header of"), &format!("--units {kind}\n")],
        );
        let (code, out, said) = replay(folder, file, &["--align", "20", "--units", kind]);
        assert_eq!((code, said.as_str()), (Some(0), ""), "{kind}");
        assert!(out.contains("heading 40.0000°"), "{out}");
        fs::remove_file(folder.join("nav.csv")).unwrap();
    }
}

#[test]
fn signs_axes_and_hemispheres_are_named() {
    let folder = at_rest();
    let folder = folder.path();
    let signs =
        |signs: [f64; 6]| move |_: usize, v: [f64; 6]| std::array::from_fn(|i| v[i] * signs[i]);
    let make = |with: [f64; 6]| change(folder, "imu.csv", "other.csv", None, signs(with));
    make([1.0, 1.0, 1.0, -1.0, -1.0, -1.0]);
    refused(folder, "other.csv", &["looks like specific force of the wrong sign", "hemisphere"]);
    make([1.0, 1.0, -1.0, 1.0, 1.0, 1.0]);
    refused(folder, "other.csv", &["gyro z or accelerometer z reversed"]);
    make([1.0, -1.0, -1.0, 1.0, -1.0, -1.0]);
    refused(folder, "other.csv", &["upside down", "forward-left-up"]);
    let swapped = |_: usize, [x, y, z, u, v, w]: [f64; 6]| [z, y, x, u, v, w];
    change(folder, "imu.csv", "other.csv", None, swapped);
    refused(folder, "other.csv", &["axes z and x of gyros or accelerometers exchanged"]);
    let south = INITIAL.replace("latitude_deg = 45", "latitude_deg = -45");
    fs::write(folder.join("initial.toml"), south).unwrap();
    refused(folder, "imu.csv", &["looks like the latitude of the other hemisphere (45"]);
}

#[test]
fn a_vehicle_that_moves_is_not_aligned() {
    let folder = at_rest();
    let folder = folder.path();
    let refused = |words: &str, by: &dyn Fn(f64, [f64; 6]) -> [f64; 6]| {
        change(folder, "imu.csv", "other.csv", None, |row, v| by(row as f64 * 0.01, v));
        let (code, _, said) = replay(folder, "other.csv", &["--align", "20"]);
        assert!(code == Some(2) && said.contains(words), "{words}: {code:?} {said}");
        // Moving is no fault where nobody says that it stands still.
        let (code, _, said) = replay(folder, "other.csv", &[]);
        assert_eq!((code, said.as_str()), (Some(0), ""), "{words}");
    };
    let turn = |axis: usize, by: f64| {
        move |_: f64, mut v: [f64; 6]| {
            v[axis] += by * DEGREE * 0.01;
            v
        }
    };
    refused("like a vehicle that turns", &turn(2, 1.0));
    refused("like a vehicle that turns", &turn(2, 20.0));
    refused("accelerates", &|_, mut v| {
        v[3] += 1.5 * 0.01;
        v
    });
    refused("is not still", &|t, mut v| {
        v[3] += 2.0 * 0.01 * (0.4 * t).sin();
        v
    });
    refused("looks like free fall", &|_, [x, y, z, ..]| [x, y, z, 0.0, 0.0, 0.0]);
}
