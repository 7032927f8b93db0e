//! A file that takes its name when it is finished, alone or with others.

use super::aside::Aside;
use super::way::{self, MadeFolders};
use super::{fault, stop};
use crate::input::InputError;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// A file that takes its name when it is finished; dropped before, it leaves nothing behind. Nor does
/// it where the program is stopped: folders that are not there are made at the end.
#[derive(Debug)]
pub struct OutputFile {
    path: PathBuf,
    to: Target,
}

#[derive(Debug)]
enum Target {
    /// On the file system where it goes.
    Aside(BufWriter<Aside>),
    /// A pipe or a device, which cannot be replaced.
    Direct(BufWriter<File>),
}

impl OutputFile {
    /// To be at a path, or where it links to. What stands in the way is told here.
    pub fn create(path: impl AsRef<Path>) -> Result<Self, InputError> {
        let path = path.as_ref();
        let open = || -> io::Result<Self> {
            if path.is_dir() {
                return Err(io::Error::other("it is a folder"));
            }
            if path.exists() && !path.is_file() {
                let file = File::options().write(true).open(path)?;
                return Ok(Self {
                    path: path.to_owned(),
                    to: Target::Direct(BufWriter::new(file)),
                });
            }
            let path = way::resolved(path)?;
            let aside = Aside::new(&way::ground(&path)?)?;
            Ok(Self { to: Target::Aside(BufWriter::with_capacity(1 << 16, aside)), path })
        };
        open().map_err(|error| fault(path, &error))
    }

    /// Where it goes.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Writes all that is to be in it.
    pub fn put(&mut self, content: impl AsRef<[u8]>) -> Result<(), InputError> {
        self.write_all(content.as_ref()).map_err(|error| fault(&self.path, &error))
    }

    /// Writes all that is to be in it and puts it in its place.
    pub fn fill(mut self, content: impl AsRef<[u8]>) -> Result<(), InputError> {
        self.put(content)?;
        self.finish()
    }

    /// Puts the file in its place.
    pub fn finish(self) -> Result<(), InputError> {
        place(vec![self], &[])
    }
}

/// Puts files in their places together, and takes away others that would not belong to them. Who puts
/// files into the same folder waits meanwhile, so that those of one lie there, not some of each.
pub fn place(files: Vec<OutputFile>, stale: &[PathBuf]) -> Result<(), InputError> {
    // First all that is likely to fail, the full disk above all.
    let mut whole = Vec::new();
    for OutputFile { path, to } in files {
        match to {
            Target::Direct(mut writer) => writer.flush().map_err(|error| fault(&path, &error))?,
            Target::Aside(writer) => {
                let aside = writer.into_inner().map_err(io::IntoInnerError::into_error);
                whole.push((aside.map_err(|error| fault(&path, &error))?, path));
            }
        }
    }
    stop::undisturbed(|| {
        let mut made = Vec::new();
        for (_, path) in &whole {
            let folder = MadeFolders::make(way::folder(path));
            made.push(folder.map_err(|error| fault(path, &error))?);
        }
        let _locked = whole.first().map(|(_, path)| locked(way::folder(path)));
        for (aside, path) in whole {
            aside.place(&path).map_err(|error| fault(&path, &error))?;
            stop::placed();
        }
        stale.iter().try_for_each(|path| match fs::remove_file(path) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => Err(fault(path, &error)),
            _ => Ok(()),
        })
    })
}

/// A folder locked against others of this program; `None` where folders cannot be.
fn locked(folder: &Path) -> Option<File> {
    let folder = File::open(folder).ok()?;
    folder.lock().ok()?;
    Some(folder)
}

impl Write for OutputFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.to {
            Target::Aside(writer) => writer.write(bytes),
            Target::Direct(writer) => writer.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match &mut self.to {
            Target::Aside(writer) => writer.flush(),
            Target::Direct(writer) => writer.flush(),
        }
    }
}
