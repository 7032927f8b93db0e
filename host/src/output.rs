//! Files written in full or not at all, however the program ends.
//!
//! | file | what |
//! |---|---|
//! | `file` | an output file, and several that belong together |
//! | `aside` | where it is before it has its name |
//! | `way` | where its path leads |
//! | `table` | a CSV file of numbers |
//! | `stop` | what is taken away when the program is told to stop |

mod aside;
mod file;
pub mod stop;
mod table;
mod way;

pub use file::{OutputFile, place};
pub use table::NumberTable;

use crate::input::{Complaint, InputError};
use std::io::{self, Write};
use std::path::Path;

/// Prints a text; nobody listening any more is the end of the program, not an error.
pub fn say(text: &str) -> Result<(), InputError> {
    let mut stdout = io::stdout().lock();
    match stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => {
            stop::clear();
            std::process::exit(0)
        }
        written => written.map_err(|error| fault(Path::new("standard output"), &error)),
    }
}

/// Writes a whole file at once.
pub fn write(path: impl AsRef<Path>, content: impl AsRef<[u8]>) -> Result<(), InputError> {
    OutputFile::create(path)?.fill(content)
}

fn fault(path: &Path, error: &io::Error) -> InputError {
    let complaint = Complaint::new(format!("cannot be written: {error}"), "");
    InputError::file(&path.display().to_string(), complaint)
}
