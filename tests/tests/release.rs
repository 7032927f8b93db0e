//! What goes out with a release: the same licences and the same version everywhere.

use std::fs;
use std::path::{Path, PathBuf};

fn root(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(path)
}

#[test]
fn the_package_of_core_has_the_licences() {
    for file in ["LICENSE-MIT", "LICENSE-APACHE"] {
        let of_core = fs::read(root("core").join(file)).unwrap();
        assert!(of_core == fs::read(root(file)).unwrap(), "core/{file} is not the root's");
    }
}

#[test]
fn the_changelog_begins_with_this_version_and_a_day() {
    let text = fs::read_to_string(root("CHANGELOG.md")).unwrap();
    // What is not released yet may stand above it.
    let mut headings = text.lines().filter_map(|line| line.strip_prefix("## "));
    let heading = headings.find(|heading| *heading != "Unreleased").unwrap();
    let (version, day) = heading.split_once(" - ").unwrap();
    assert_eq!(version, env!("CARGO_PKG_VERSION"));
    let digits: Vec<_> = day.split('-').map(|part| (part.len(), part.parse::<u32>())).collect();
    assert!(matches!(digits[..], [(4, Ok(2026..)), (2, Ok(1..=12)), (2, Ok(1..=31))]), "{heading}");
}
