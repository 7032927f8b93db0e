//! The matrix of targets: what it refuses. The matrix itself is run by tests/matrix.sh.

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
