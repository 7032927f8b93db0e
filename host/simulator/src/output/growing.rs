//! A file that grows by whole pieces, each of which stays whatever becomes of the program.

use super::file::OutputFile;
use super::{fault, stop, way};
use crate::input::{Complaint, InputError};
use std::fs::{self, File, TryLockError};
use std::io::{self, Seek as _, SeekFrom, Write as _};
use std::path::{Path, PathBuf};

/// A file that others do not write at the same time.
#[derive(Debug)]
pub struct GrowingFile {
    path: PathBuf,
    /// Absent before the first piece.
    file: Option<File>,
}

impl GrowingFile {
    /// A new file, made with its first piece. What stands in the way is told here.
    pub fn create(path: &Path) -> Result<Self, InputError> {
        drop(OutputFile::create(path)?);
        Ok(Self { path: path.to_owned(), file: None })
    }

    /// One that is there, of which so many bytes are kept.
    pub fn resume(path: &Path, bytes: u64) -> Result<Self, InputError> {
        let open = || -> io::Result<File> {
            let mut file = File::options().read(true).write(true).open(path)?;
            lock(&file)?;
            file.set_len(bytes)?;
            file.seek(SeekFrom::End(0))?;
            Ok(file)
        };
        let file = open().map_err(|error| fault(path, &error))?;
        Ok(Self { path: path.to_owned(), file: Some(file) })
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Adds a piece; a signal waits meanwhile. From then on a program that is stopped says what is `left`.
    pub fn append(&mut self, bytes: &[u8], left: String) -> Result<(), InputError> {
        let Self { path, file } = self;
        let append = || -> io::Result<()> {
            let file = match file {
                Some(file) => file,
                None => {
                    fs::create_dir_all(way::folder(path))?;
                    let new = File::options().write(true).create_new(true).open(&path)?;
                    lock(&new)?;
                    file.insert(new)
                }
            };
            file.write_all(bytes)?;
            file.sync_data()?;
            // Before a signal that waits is heeded.
            stop::leave(left);
            Ok(())
        };
        stop::undisturbed(append).map_err(|error| fault(path, &error))
    }

    /// Takes the file away: it has served.
    pub fn remove(path: &Path) -> Result<(), InputError> {
        match fs::remove_file(path) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => {
                let complaint = Complaint::new(format!("cannot be removed: {error}"), "");
                Err(InputError::file(&path.display().to_string(), complaint))
            }
            _ => Ok(()),
        }
    }
}

/// Locked against others that write it; some file systems cannot.
fn lock(file: &File) -> io::Result<()> {
    match file.try_lock() {
        Err(TryLockError::WouldBlock) => {
            Err(io::Error::other("another process is writing it at this time"))
        }
        _ => Ok(()),
    }
}
