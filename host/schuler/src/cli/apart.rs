//! Files that are written over one another, or over one that is read.

use schuler_simulator::input::name::path_of;
use schuler_simulator::input::{Complaint, InputError};
use std::path::{Path, PathBuf};

/// A file that is to be written.
#[derive(Clone, Debug)]
pub(super) struct Written {
    /// The option that says so.
    pub option: &'static str,
    /// What it is where the option names another; else empty.
    pub what: &'static str,
    /// Its path.
    pub path: PathBuf,
}

impl Written {
    /// The file that an option names.
    pub fn named(option: &'static str, path: &Path) -> Self {
        Self { option, what: "", path: path.to_owned() }
    }
}

/// Refuses to write over a file that is read, each with what reads it, or over another that is written.
pub(super) fn check(written: &[Written], read: &[(&str, &Path)]) -> Result<(), InputError> {
    for (n, Written { option, what, path }) in written.iter().enumerate() {
        let refuse = |by: &str| {
            let space = if what.is_empty() { "" } else { " " };
            let complaint =
                Complaint::new(format!("{what}{space}is the file that {by}"), "another file");
            Err(InputError::option(option, complaint))
        };
        if let Some((by, _)) = read.iter().find(|(_, file)| is_same(path, &named(file))) {
            return refuse(by);
        }
        if let Some(other) = written.iter().take(n).find(|other| is_same(path, &other.path)) {
            return refuse(&format!("{} writes", other.option));
        }
    }
    Ok(())
}

/// The file that is read, whose path may stand for one that is not Unicode.
fn named(file: &Path) -> PathBuf {
    file.to_str().map_or_else(|| file.to_owned(), path_of)
}

/// Whether two paths lead to the same file, which need not be there yet.
fn is_same(a: &Path, b: &Path) -> bool {
    let is_device = |path: &Path| path.exists() && !path.is_file();
    match (place(a), place(b)) {
        (Some(a), Some(b)) => a == b && !is_device(&a),
        _ => false,
    }
}

/// Where a path leads, as far as there is something.
fn place(path: &Path) -> Option<PathBuf> {
    if let Ok(place) = path.canonicalize() {
        return Some(place);
    }
    let folder = path.parent().filter(|folder| *folder != Path::new("")).unwrap_or(Path::new("."));
    let folder = folder.canonicalize().or_else(|_| std::path::absolute(folder)).ok()?;
    path.file_name().map(|name| folder.join(name))
}
