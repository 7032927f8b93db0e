//! The matrix of targets: what it refuses, and that its aided flights are the program's. The matrix itself is run by
//! tests/matrix.sh.

use schuler_simulator::scene::{self, Precision};
use schuler_simulator::simulate;
use std::fs;
use std::path::Path;
use std::process::Command;

fn refused(arguments: &[&str]) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_matrix"))
        .args(arguments)
        .output()
        .expect("the program runs");
    assert_eq!(output.status.code(), Some(2), "{arguments:?}");
    String::from_utf8_lossy(&output.stderr).into_owned()
}

#[test]
fn a_target_that_is_not_there() {
    let error = refused(&["--target", "vax"]);
    let accepted = "--target: there is no target vax; accepted: release, debug";
    assert!(error.contains(accepted), "{error}");
}

#[test]
fn a_folder_without_sources() {
    let empty = tempfile::tempdir().expect("a folder");
    let error = refused(&["--source", &empty.path().display().to_string()]);
    assert!(error.contains("holds no tests/audit"), "{error}");
}

#[test]
fn a_folder_of_golden_chains_that_is_not_there() {
    let error = refused(&["--golden", "no-such-folder", "--target", "release"]);
    assert!(error.contains("no-such-folder: is no folder"), "{error}");
}

#[test]
fn the_aided_flights_that_are_golden_are_those_of_the_program() {
    let golden = Path::new(env!("CARGO_MANIFEST_DIR")).join("golden");
    let lines = fs::read_to_string(golden.join("aided.txt")).expect("golden lines");
    let file = golden.join("aided.toml").display().to_string();
    let mut flown = 0;
    for (name, precision) in [("f64", Precision::F64), ("f32", Precision::F32)] {
        let flight = format!("aided/{name}-local-level-taylor-0-4-0 run =6000 ");
        let line = lines.lines().find_map(|line| line.strip_prefix(&flight));
        let digest = line.expect("the digest of the whole flight");
        let mut scene = scene::load(&file).expect("a scene");
        scene.navigator.precision = precision;
        let flight = simulate::fly(&scene, false, &mut |_| Ok(()), &|_| ()).expect("a flight");
        assert_eq!(flight.digest, digest, "{name}");
        // It shows what it is there for.
        let report = flight.aided.expect("what became of the measurements");
        assert!(report.again > 10 && report.sensors[0].accepted > 80, "{report:?}");
        flown += 1;
    }
    assert_eq!(flown, 2);
}
