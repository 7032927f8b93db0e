//! `schuler datasheet`: the numbers of a data sheet as sections of a scene.

use crate::cli::DatasheetArgs;
use schuler_simulator::datasheet;
use schuler_simulator::input::{InputError, read_text};
use schuler_simulator::output::{print, say};

/// Prints the sections, and what was assumed.
pub fn datasheet(args: &DatasheetArgs) -> Result<(), InputError> {
    match &args.file {
        Some(file) => print(&datasheet::sections(file, &read_text(file)?)?),
        None => say(&datasheet::keys()),
    }
}
