//! Recordings: what their files may say, and that what is written reads back.

#![expect(clippy::excessive_precision, reason = "expected values keep their printed digits")]

mod csv;
mod navigation;
mod output;
mod psins;
mod rates;

use std::path::Path;

/// A path in a folder of its own that goes when the test ends.
fn scratch() -> tempfile::TempDir {
    tempfile::tempdir().expect("a temporary folder")
}

fn text(path: &Path) -> &str {
    path.to_str().expect("temporary folders have plain names")
}

#[track_caller]
fn near(value: f64, expected: f64, tolerance: f64) {
    assert!((value - expected).abs() <= tolerance, "{value} is not {expected} ± {tolerance:e}");
}
