//! The file before it has its name.
//!
//! If the file system allows it, the file has no name until then, and disappears with the program however that ends.

use super::stop::Listed;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::Path;
use tempfile::{NamedTempFile, TempPath};

/// A file that does not stand in its place yet.
#[derive(Debug)]
pub(super) enum Aside {
    /// Without a name.
    #[cfg(target_os = "linux")]
    Nameless(File),
    /// Under a hidden one.
    Named(NamedTempFile, Listed),
}

impl Aside {
    /// On the file system of a folder, which must be there.
    pub fn new(folder: &Path) -> io::Result<Self> {
        #[cfg(target_os = "linux")]
        if let Some(file) = nameless(folder)? {
            return Ok(Self::Nameless(file));
        }
        Self::named(folder)
    }

    fn named(folder: &Path) -> io::Result<Self> {
        let file = hidden().tempfile_in(folder)?;
        let listed = Listed::file(file.path());
        Ok(Self::Named(file, listed))
    }

    /// Puts it in its place, instead of what is there.
    pub fn place(self, path: &Path) -> io::Result<()> {
        match self {
            Self::Named(file, _listed) => file.persist(path).map(drop).map_err(|e| e.error),
            #[cfg(target_os = "linux")]
            Self::Nameless(file) => place_nameless(file, path),
        }
    }
}

impl Write for Aside {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            #[cfg(target_os = "linux")]
            Self::Nameless(file) => file.write(bytes),
            Self::Named(file, _) => file.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            #[cfg(target_os = "linux")]
            Self::Nameless(file) => file.flush(),
            Self::Named(file, _) => file.flush(),
        }
    }
}

/// Hidden names, with the permissions that the process's mask leaves of any new file's.
fn hidden() -> tempfile::Builder<'static, 'static> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".schuler-");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    builder
}

/// A file without a name that can get one later; `None` where there is no such thing.
#[cfg(target_os = "linux")]
fn nameless(folder: &Path) -> io::Result<Option<File>> {
    use rustix::fs::OFlags;
    use rustix::io::Errno;
    use std::os::unix::fs::OpenOptionsExt;
    let flags = OFlags::TMPFILE.bits() as i32;
    match File::options().read(true).write(true).custom_flags(flags).open(folder) {
        Ok(file) => Ok(fs::exists(by_number(&file)).unwrap_or(false).then_some(file)),
        Err(error) => match Errno::from_io_error(&error) {
            // What says that it cannot be done, depending on the age of the system.
            Some(Errno::OPNOTSUPP | Errno::ISDIR | Errno::NOENT | Errno::INVAL) => Ok(None),
            _ => Err(error),
        },
    }
}

/// What an open file without a name is called by.
#[cfg(target_os = "linux")]
fn by_number(file: &File) -> String {
    use std::os::fd::AsRawFd;
    format!("/proc/self/fd/{}", file.as_raw_fd())
}

#[cfg(target_os = "linux")]
fn place_nameless(mut file: File, path: &Path) -> io::Result<()> {
    use rustix::fs::{AtFlags, CWD, linkat};
    use std::io::Seek;
    let number = by_number(&file);
    let link = |to: &Path| -> io::Result<()> {
        Ok(linkat(CWD, number.as_str(), CWD, to, AtFlags::SYMLINK_FOLLOW)?)
    };
    let taken = match link(path) {
        Err(error) => error,
        Ok(()) => return Ok(()),
    };
    let folder = path.parent().filter(|folder| *folder != Path::new(""));
    let folder = folder.unwrap_or(Path::new("."));
    if taken.kind() == io::ErrorKind::AlreadyExists {
        // No name can be taken over but by a rename.
        let mut listed = None;
        let linked = hidden().make_in(folder, |hidden| {
            listed = Some(Listed::file(hidden));
            link(hidden)
        });
        if let Ok(linked) = linked {
            let hidden: TempPath = linked.into_temp_path();
            return hidden.persist(path).map_err(|e| e.error);
        }
    }
    // A file system that makes files without names, and cannot name them.
    let mut named = Aside::named(folder)?;
    file.rewind()?;
    io::copy(&mut file, &mut named)?;
    named.place(path)
}
