//! Files that are written completely or not at all, however the program ends.
//!
//! | file | what |
//! |---|---|
//! | `file` | an output file, and several that belong together |
//! | `aside` | the file before it has its name |
//! | `growing` | a file that grows by whole pieces |
//! | `way` | the folders of its path |
//! | `table` | CSV files |
//! | `rows` | the same in memory |
//! | `stop` | what is removed when the program is told to stop |
//! | [`heard`] | what is said while somebody listens |
//! | [`wrap`] | sentences that fit the terminal |

mod aside;
mod file;
mod growing;
pub mod heard;
mod rows;
pub mod stop;
mod table;
mod way;
pub mod wrap;

pub use file::{OutputFile, place};
pub use growing::GrowingFile;
pub use rows::NumberRows;
pub use table::{NumberTable, csv};

use crate::input::{Complaint, InputError};
use std::borrow::Cow;
use std::io::{self, Write};
use std::path::Path;

/// Says a text for people, its sentences broken to the terminal's width, unless it is [overheard](heard::overheard).
pub fn say(text: &str) -> Result<(), InputError> {
    if heard::hears(text) {
        return Ok(());
    }
    print(&wrap::columns().map_or(Cow::Borrowed(text), |columns| wrap::wrapped(text, columns)))
}

/// Says a line on the error stream, broken to its terminal's width.
pub fn say_error(line: &str) {
    let columns = wrap::error_columns();
    let line = columns.map_or(Cow::Borrowed(line), |columns| wrap::wrapped(line, columns));
    eprintln!("{line}");
}

/// Prints a document, such as a scene, as it is. Nobody listening any more is the end of the program, not an error.
pub fn print(text: &str) -> Result<(), InputError> {
    if heard::hears(text) {
        return Ok(());
    }
    let mut stdout = io::stdout().lock();
    match stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => {
            stop::clear();
            std::process::exit(0)
        }
        written => written.map_err(|error| fault(Path::new("standard output"), &error)),
    }
}

/// Bytes of a table beyond which its size is said before it is written.
const MUCH: u64 = 1_000_000_000;

/// What to say before a table of numbers is written that takes more than a gigabyte: how much.
pub fn much(path: &Path, rows: u64, columns: usize) -> Option<String> {
    // Seventeen digits, a sign or a point, and a comma: 18 bytes in the mean of real tables.
    let bytes = rows.saturating_mul(18 * columns as u64);
    let (path, size) = (path.display(), bytes as f64 / 1e9);
    (bytes > MUCH).then(|| format!("schuler: {path} takes about {size:.1} GB"))
}

/// The same of a table of which rows can be left out, and how.
pub fn large_table(path: &Path, rows: u64, columns: usize) -> Option<String> {
    let less = "; --every N keeps every N-th row, --every 1s a row a second";
    much(path, rows, columns).map(|much| much + less)
}

/// Writes a whole file at once.
pub fn write(path: impl AsRef<Path>, content: impl AsRef<[u8]>) -> Result<(), InputError> {
    OutputFile::create(path)?.fill(content)
}

fn fault(path: &Path, error: &io::Error) -> InputError {
    let complaint = Complaint::new(format!("cannot be written: {error}"), "");
    InputError::file(&path.display().to_string(), complaint)
}
