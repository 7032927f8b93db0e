//! The target of a path, and the folders on it that do not exist yet.

use std::fs;
use std::io;
use std::path::{Component, Path, PathBuf};

/// How many links lead to one another, at most.
const MOST_LINKS: usize = 40;

/// Where a path leads: through links, even to what is not there yet.
pub(super) fn resolved(path: &Path) -> io::Result<PathBuf> {
    let mut path = path.to_owned();
    for _ in 0..MOST_LINKS {
        match fs::symlink_metadata(&path) {
            Ok(what) if what.is_symlink() => {
                let to = fs::read_link(&path)?;
                path = path.parent().map_or(to.clone(), |folder| folder.join(to));
            }
            _ => return Ok(path),
        }
    }
    Err(io::Error::other("too many links lead to one another"))
}

/// The folder that a path lies in.
pub(super) fn folder(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    }
}

/// The nearest folder on the way to a file that is there. The others can be made within it, as far as
/// can be seen without making them.
pub(super) fn ground(path: &Path) -> io::Result<PathBuf> {
    let refuse =
        |folder: &Path, what: &str| Err(io::Error::other(format!("{} {what}", folder.display())));
    let mut missing = Vec::new();
    let mut to_be = path;
    loop {
        let folder = folder(to_be);
        missing.extend(to_be.components().next_back());
        match fs::metadata(folder) {
            Ok(what) if what.is_dir() => {
                let fits = |name: &Path| match fs::symlink_metadata(folder.join(name)) {
                    Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
                    _ => Ok(()),
                };
                let names = missing.iter().filter(|part| matches!(part, Component::Normal(_)));
                names.map(AsRef::as_ref).try_for_each(fits)?;
                return Ok(folder.to_owned());
            }
            Ok(_) => return refuse(folder, "is no folder"),
            Err(error) if !is_missing(&error) => return Err(error),
            Err(_) if fs::symlink_metadata(folder).is_ok() => {
                return refuse(folder, "is a link that leads nowhere");
            }
            Err(error) if folder == to_be => return Err(error),
            Err(_) => to_be = folder,
        }
    }
}

/// Whether something is not there, or something on the way to it is no folder.
fn is_missing(error: &io::Error) -> bool {
    matches!(error.kind(), io::ErrorKind::NotFound | io::ErrorKind::NotADirectory)
}

/// Folders made for a file, each within the one before: those that stay empty go again.
#[derive(Debug)]
pub(super) struct MadeFolders(Vec<PathBuf>);

impl MadeFolders {
    /// A folder, and those that it lies in.
    pub fn make(folder: &Path) -> io::Result<Self> {
        let missing = folder.ancestors().take_while(|folder| !folder.exists());
        let mut missing: Vec<_> = missing.map(Path::to_owned).collect();
        missing.retain(|folder| folder != Path::new(""));
        missing.reverse();
        let made = Self(missing);
        fs::create_dir_all(folder)?;
        Ok(made)
    }
}

impl Drop for MadeFolders {
    fn drop(&mut self) {
        // A folder with something in it cannot be removed, nor can those that it lies in.
        let _ = self.0.iter().rev().try_for_each(fs::remove_dir);
    }
}
