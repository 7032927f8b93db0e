//! Files written in full or not at all.

use crate::input::{Complaint, InputError};
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;

/// A file that takes its name when it is finished; dropped before, it leaves nothing behind.
#[derive(Debug)]
pub struct OutputFile {
    path: PathBuf,
    to: Target,
    /// Goes after the file beside its place.
    made: MadeFolders,
}

/// Folders made for a file, each within the one before: those that stay empty go again.
#[derive(Debug, Default)]
struct MadeFolders(Vec<PathBuf>);

impl MadeFolders {
    fn make(folder: &Path) -> io::Result<Self> {
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

/// How many links lead to one another, at most.
const MOST_LINKS: usize = 40;

/// Where a path leads: through links, even to what is not there yet.
fn resolved(path: &Path) -> io::Result<PathBuf> {
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

#[derive(Debug)]
enum Target {
    /// Beside the place where the file goes.
    Aside(BufWriter<NamedTempFile>),
    /// A pipe or a device, which cannot be replaced.
    Direct(BufWriter<File>),
}

impl OutputFile {
    /// To be at a path, or where it links to. Missing folders are created.
    pub fn create(path: impl AsRef<Path>) -> Result<Self, InputError> {
        let path = path.as_ref().to_owned();
        let open = || -> io::Result<Self> {
            if path.is_dir() {
                return Err(io::Error::other("it is a folder"));
            }
            if path.exists() && !path.is_file() {
                let file = File::options().write(true).open(&path)?;
                let to = Target::Direct(BufWriter::new(file));
                return Ok(Self { path: path.clone(), to, made: MadeFolders::default() });
            }
            let path = resolved(&path)?;
            let folder = match path.parent() {
                Some(folder) if folder != Path::new("") => folder,
                _ => Path::new("."),
            };
            let made = MadeFolders::make(folder)?;
            let mut builder = tempfile::Builder::new();
            builder.prefix(".schuler-");
            #[cfg(unix)]
            {
                use std::os::unix::fs::PermissionsExt;
                // What the process's mask leaves of it, as for any new file.
                builder.permissions(fs::Permissions::from_mode(0o666));
            }
            let aside = BufWriter::with_capacity(1 << 16, builder.tempfile_in(folder)?);
            Ok(Self { to: Target::Aside(aside), path, made })
        };
        open().map_err(|error| fault(&path, &error))
    }

    /// Where it goes.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Writes all that is to be in it and puts it in its place.
    pub fn fill(mut self, content: impl AsRef<[u8]>) -> Result<(), InputError> {
        self.write_all(content.as_ref()).map_err(|error| fault(&self.path, &error))?;
        self.finish()
    }

    /// Puts the file in its place.
    pub fn finish(self) -> Result<(), InputError> {
        let Self { path, to, made: _made } = self;
        let done = match to {
            Target::Direct(mut writer) => writer.flush(),
            Target::Aside(writer) => writer
                .into_inner()
                .map_err(io::IntoInnerError::into_error)
                .and_then(|file| file.persist(&path).map(drop).map_err(|e| e.error)),
        };
        done.map_err(|error| fault(&path, &error))
    }
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

/// Prints a text; nobody listening any more is the end of the program, not an error.
pub fn say(text: &str) -> Result<(), InputError> {
    let mut stdout = io::stdout().lock();
    match stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => std::process::exit(0),
        written => written.map_err(|error| fault(Path::new("standard output"), &error)),
    }
}

/// Bytes of a table beyond which its size is said before it is written.
const MUCH: u64 = 1_000_000_000;

/// What to say before a table of numbers is written that takes more than a gigabyte: how much, and what
/// makes it less.
pub fn large_table(path: &Path, rows: u64, columns: usize) -> Option<String> {
    // Seventeen digits, a sign or a point, and a comma: 18 bytes in the mean of real tables.
    let bytes = rows.saturating_mul(18 * columns as u64);
    (bytes > MUCH).then(|| {
        let (path, size) = (path.display(), bytes as f64 / 1e9);
        format!("schuler: {path} takes about {size:.1} GB; --every N keeps every N-th row, --every 1s a row a second")
    })
}

/// Writes a whole file at once.
pub fn write(path: impl AsRef<Path>, content: impl AsRef<[u8]>) -> Result<(), InputError> {
    OutputFile::create(path)?.fill(content)
}

/// A CSV file of numbers, written row by row, each with the digits that bring back its bits.
#[derive(Debug)]
pub struct NumberTable {
    file: OutputFile,
    columns: usize,
    line: Vec<u8>,
}

impl NumberTable {
    /// With a header line.
    pub fn create(path: impl AsRef<Path>, columns: &[&str]) -> Result<Self, InputError> {
        let mut table =
            Self { file: OutputFile::create(path)?, columns: columns.len(), line: Vec::new() };
        table.line.extend_from_slice(columns.join(",").as_bytes());
        table.end_line()?;
        Ok(table)
    }

    /// One row, a number for each column.
    pub fn row(&mut self, numbers: &[f64]) -> Result<(), InputError> {
        debug_assert_eq!(numbers.len(), self.columns, "a number for each column");
        let mut buffer = zmij::Buffer::new();
        for (i, &number) in numbers.iter().enumerate() {
            if i > 0 {
                self.line.push(b',');
            }
            self.line.extend_from_slice(buffer.format(number).as_bytes());
        }
        self.end_line()
    }

    fn end_line(&mut self) -> Result<(), InputError> {
        self.line.push(b'\n');
        let written = self.file.write_all(&self.line);
        self.line.clear();
        written.map_err(|error| fault(&self.file.path, &error))
    }

    /// Puts the file in its place.
    pub fn finish(self) -> Result<(), InputError> {
        self.file.finish()
    }
}

fn fault(path: &Path, error: &io::Error) -> InputError {
    let complaint = Complaint::new(format!("cannot be written: {error}"), "");
    InputError::file(&path.display().to_string(), complaint)
}
