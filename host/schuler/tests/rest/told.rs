//! What is poor is told with what it is worth; a heading may be given.

use super::{INITIAL, at_rest, change, replay, schuler};
use std::fs;

#[test]
fn a_poor_heading_has_its_sigma_and_a_worthless_one_is_refused() {
    let folder = at_rest();
    let folder = folder.path();
    let bias = |deg_h: f64| {
        let angle = (deg_h / 3600.0).to_radians() * 0.01;
        change(folder, "imu.csv", "other.csv", None, move |_, [x, y, z, u, v, w]| {
            [x + angle, y - angle, z + angle, u, v, w]
        });
    };
    bias(2.0);
    let (code, out, said) = replay(folder, "other.csv", &["--align", "20"]);
    assert_eq!(code, Some(0), "{said}");
    assert!(
        said.contains("warning: heading is good to") && out.contains("heading "),
        "{said}{out}"
    );
    bias(100.0);
    let (code, _, said) = replay(folder, "other.csv", &["--align", "20"]);
    assert!(code == Some(2) && said.contains("accepted: --heading DEG"), "{said}");
    let (code, out, said) = replay(folder, "other.csv", &["--align", "20", "--heading", "-320"]);
    assert_eq!(code, Some(0), "{said}");
    assert!(out.contains("roll 3.0000°, pitch -7.0000°, heading 40.0000° as given"), "{out}");
    assert!(said.contains("warning: mean angular rate"), "{said}");
}

#[test]
fn at_a_pole_the_heading_is_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let scene = "duration_s = 20\nrate_hz = 50\n[trajectory]\nlatitude_deg = 90\nroll_deg = 2\n";
    fs::write(folder.join("pole.toml"), scene).unwrap();
    let initial = INITIAL.replace("latitude_deg = 45", "latitude_deg = 90");
    fs::write(folder.join("initial.toml"), initial).unwrap();
    assert_eq!(schuler(folder, &["emulate", "pole.toml", "--out", "imu.csv"]).0, Some(0));
    let align = ["--align", "10", "--frame", "earth-fixed"];
    let (code, _, said) = replay(folder, "imu.csv", &align);
    assert_eq!(code, Some(2), "{said}");
    assert!(
        said.contains("no heading can be found at latitude 90") && said.contains("--heading"),
        "{said}"
    );
    let (code, out, said) = replay(folder, "imu.csv", &[&align[..], &["--heading", "25"]].concat());
    assert_eq!(code, Some(0), "{said}");
    assert!(out.contains("heading 25.0000° as given"), "{out}");
}

#[test]
fn an_initial_level_that_gravity_contradicts_is_told() {
    let folder = at_rest();
    let folder = folder.path();
    fs::write(folder.join("initial.toml"), INITIAL.replace("roll_deg = 3", "roll_deg = 15"))
        .unwrap();
    let (code, _, said) = replay(folder, "imu.csv", &[]);
    assert!(
        code == Some(0) && said.contains("the initial state says roll 15.00°"),
        "{code:?} {said}"
    );
}
