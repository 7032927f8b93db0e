//! The same files of an aided flight through Schuler's filter and through others, and a table of what they make of it.
//!
//! | file | what it has |
//! |---|---|
//! | [`files`] | lines of `key = number`, and tables with named columns |
//! | [`settings`] | what the filters are told, from a scene |
//! | [`flight`] | a folder's samples and fixes; filters flown and timed |
//! | [`by_schuler`] | core's filter |
//! | [`by_kinavis`] | kinavis-ins |
//! | [`judge`] | rows against the truth: one definition for all |
//! | [`table`] | the table |
//!
//! A folder holds `scene.toml`, `imu.csv`, `gnss.csv`, `initial.toml`, `truth.csv`, and for each filter `NAME.csv` (the
//! columns of `nav.csv`, and standard deviations) and `NAME.cost` (CPU time of the filter alone, µs per sample).

mod by_kinavis;
mod by_schuler;
mod files;
mod flight;
mod judge;
mod settings;
mod table;

use std::error::Error;
use std::path::Path;
use std::process::ExitCode;

/// What went wrong.
type Failed = Box<dyn Error>;

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    match obey(&words) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("peers: {error}");
            ExitCode::FAILURE
        }
    }
}

fn obey(words: &[String]) -> Result<(), Failed> {
    let (command, folders) = words.split_first().ok_or("accepted: settings|fly|table FOLDER …")?;
    let paths = || folders.iter().map(Path::new);
    match command.as_str() {
        "settings" => paths().try_for_each(settings::write),
        "fly" => paths().try_for_each(fly),
        "table" => table::print(&paths().collect::<Vec<_>>()),
        other => Err(format!("{other}: accepted: settings|fly|table FOLDER …").into()),
    }
}

/// Core's filter for its time alone (its rows are those of `schuler replay`), kinavis-ins for time and rows.
fn fly(folder: &Path) -> Result<(), Failed> {
    let flight = flight::Flight::read(folder)?;
    flight.time("schuler", || by_schuler::start_f64(&flight))?;
    flight.time("schuler-f32", || by_schuler::start_f32(&flight))?;
    flight.time("kinavis-ins", || by_kinavis::start(&flight))?;
    flight.write_rows("kinavis-ins", by_kinavis::start(&flight)?)
}
