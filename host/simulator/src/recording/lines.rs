//! Lines of a file, one at a time in little memory.

use crate::input::name::path_of;
use crate::input::{Complaint, InputError};
use std::fs::File;
use std::io::{self, BufRead, BufReader, Read, Write};

/// Bytes of a line, at most: a file without lines is no recording.
const LONGEST: u64 = 1 << 16;

/// Opens a file. What can be read only once, a pipe, is kept in a temporary file that nobody else sees.
pub fn open(name: &str) -> Result<File, InputError> {
    let open = || -> io::Result<File> {
        let mut file = File::open(path_of(name))?;
        if file.metadata()?.is_file() {
            return Ok(file);
        }
        let mut spooled = tempfile::tempfile()?;
        io::copy(&mut file, &mut spooled)?;
        Ok(spooled)
    };
    open().map_err(|error| unreadable(name, &error))
}

/// A file that holds a text; `name` stands for it in errors.
pub fn spooled(name: &str, text: &str) -> Result<File, InputError> {
    let spool = || -> io::Result<File> {
        let mut file = tempfile::tempfile()?;
        file.write_all(text.as_bytes())?;
        Ok(file)
    };
    spool().map_err(|error| unreadable(name, &error))
}

/// Lines of a file with their numbers, blank ones passed over.
#[derive(Debug)]
pub struct Lines {
    /// Of the file.
    pub name: String,
    reader: BufReader<At>,
    line: Vec<u8>,
    offset: u64,
    /// Of the line at hand, from 1.
    pub number: u64,
}

impl Lines {
    /// From a place: how many bytes, and on which line.
    pub fn new(name: &str, file: &File, (offset, number): (u64, u64)) -> Result<Self, InputError> {
        let file = file.try_clone().map_err(|error| unreadable(name, &error))?;
        let reader = BufReader::with_capacity(1 << 18, At { file, offset });
        Ok(Self { name: name.to_owned(), reader, line: Vec::new(), offset, number })
    }

    /// Goes on to the next line that is not blank; false at the end.
    pub fn next_filled(&mut self) -> Result<bool, InputError> {
        loop {
            self.line.clear();
            let read = self.reader.by_ref().take(LONGEST).read_until(b'\n', &mut self.line);
            let read = read.map_err(|error| unreadable(&self.name, &error))?;
            if read == 0 {
                return Ok(false);
            }
            self.offset += read as u64;
            self.number += 1;
            if read as u64 == LONGEST {
                let what = format!("the line is longer than {LONGEST} bytes");
                return Err(InputError::line(&self.name, self.number, Complaint::new(what, "")));
            }
            if self.number == 1 && self.line.starts_with(b"\xEF\xBB\xBF") {
                self.line.drain(..3);
            }
            if !self.text().is_empty() {
                return Ok(true);
            }
        }
    }

    /// The line at hand, without white space around it.
    pub fn text(&self) -> &[u8] {
        self.line.trim_ascii()
    }

    /// Where the next line begins: bytes, and the number of the line at hand.
    pub fn place(&self) -> (u64, u64) {
        (self.offset, self.number)
    }
}

/// A file read from a place of its own, so that several may read it at once.
#[derive(Debug)]
struct At {
    file: File,
    offset: u64,
}

impl Read for At {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        #[cfg(unix)]
        let read = std::os::unix::fs::FileExt::read_at(&self.file, buffer, self.offset)?;
        #[cfg(windows)]
        let read = std::os::windows::fs::FileExt::seek_read(&self.file, buffer, self.offset)?;
        self.offset += read as u64;
        Ok(read)
    }
}

/// An error about a file that cannot be read.
pub fn unreadable(name: &str, error: &io::Error) -> InputError {
    InputError::file(name, Complaint::new(format!("cannot be read: {error}"), ""))
}
