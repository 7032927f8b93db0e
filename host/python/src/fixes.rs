//! What aids a recording: a file, or measurements in arrays, which go to a file of ours.

use crate::arrays::numbers;
use crate::error::{Answer, Fault};
use crate::recorded::kept;
use crate::table::Table;
use pyo3::prelude::*;
use pyo3::types::PyMapping;
use schuler_simulator::aided::columns::{COLUMNS, KINDS, MEASURES};
use schuler_simulator::aided::measurements;
use schuler_simulator::input::InputError;
use schuler_simulator::output::NumberRows;
use schuler_simulator::scene::Scene;
use schuler_simulator::source::Source;
use std::path::PathBuf;
use tempfile::TempDir;

/// What the argument is called.
const NAME: &str = "gnss";
/// What it may be.
const ACCEPTED: &str =
    "a path, the gnss of an Emulation, or a dict with arrays for columns of gnss.csv";

/// Where measurements come from.
pub struct Fixes {
    /// The file.
    pub path: PathBuf,
    /// Groups of rows of a file of ours: the name of each, and how many there are.
    groups: Vec<(String, usize)>,
}

impl Fixes {
    /// A path, a table, a dict of columns, or a dict of such by what they measure.
    pub fn new(given: &Bound<'_, PyAny>, folder: &TempDir) -> Answer<Self> {
        let is_table = given.cast::<Table>().is_ok();
        let mapping = given.cast::<PyMapping>().ok();
        if !is_table && mapping.is_none() {
            let refuse = |_| Fault::argument(NAME, "is neither", ACCEPTED);
            return Ok(Self { path: given.extract().map_err(refuse)?, groups: Vec::new() });
        }
        let mut fixes = Self { path: folder.path().join("gnss.csv"), groups: Vec::new() };
        let mut lines = COLUMNS.join(",") + "\n";
        let words: Vec<_> = KINDS.iter().map(|(word, ..)| *word).collect();
        let keys: Vec<String> = match mapping {
            Some(mapping) => mapping.keys()?.extract()?,
            None => Vec::new(),
        };
        if !keys.is_empty() && keys.iter().all(|key| words.contains(&key.as_str())) {
            for word in &keys {
                fixes.group(&format!("{NAME}.{word}"), word, &given.get_item(word)?, &mut lines)?;
            }
        } else {
            fixes.group(NAME, "", given, &mut lines)?;
        }
        std::fs::write(&fixes.path, lines).map_err(|error| kept(&error))?;
        Ok(fixes)
    }

    /// Rows of one kind, or of any where the word is empty.
    fn group(
        &mut self,
        name: &str,
        word: &str,
        columns: &Bound<'_, PyAny>,
        lines: &mut String,
    ) -> Answer<()> {
        let keys: Vec<String> = match columns.cast::<Table>() {
            Ok(table) => table.get().names().to_vec(),
            Err(_) => {
                let mapping = columns.cast::<PyMapping>();
                mapping
                    .map_err(|_| Fault::argument(name, "is no dict", ACCEPTED))?
                    .keys()?
                    .extract()?
            }
        };
        let mut cells: Vec<Option<Vec<f64>>> = vec![None; COLUMNS.len()];
        let mut rows = None;
        for key in keys {
            let key_name = format!("{name}.{key}");
            let known = COLUMNS.iter().position(|column| *column == key);
            let place = known.filter(|place| *place != MEASURES).ok_or_else(|| {
                let numbers = COLUMNS.iter().filter(|column| **column != COLUMNS[MEASURES]);
                let accepted = numbers.copied().collect::<Vec<_>>().join(", ");
                Fault::argument(&key_name, "is no column of measurements", accepted)
            })?;
            let column = numbers(&key_name, &columns.get_item(&key)?)?.as_array().to_vec();
            let count = *rows.get_or_insert(column.len());
            if count != column.len() {
                let what = format!("has {} values", column.len());
                return Err(Fault::argument(&key_name, what, format!("{count} of them")));
            }
            cells[place] = Some(column);
        }
        let rows = rows.unwrap_or(0);
        for row in 0..rows {
            for (place, column) in cells.iter().enumerate() {
                if place > 0 {
                    lines.push(',');
                }
                match column.as_ref().and_then(|column| column.get(row)) {
                    _ if place == MEASURES => lines.push_str(word),
                    // What is not a number is not there.
                    Some(number) if !number.is_nan() => *lines += &format!("{number:?}"),
                    _ => {}
                }
            }
            lines.push('\n');
        }
        self.groups.push((name.to_owned(), rows));
        Ok(())
    }

    /// An error about the file, as one about the arrays.
    pub fn told(&self, mut error: InputError) -> InputError {
        let is_own = |file: &String| !self.groups.is_empty() && self.path == *file;
        if error.file.take_if(|file| is_own(file)).is_none() {
            return error;
        }
        let Some(mut row) =
            error.line.take().and_then(|line| usize::try_from(line).ok()?.checked_sub(2))
        else {
            error.key = Some(error.key.map_or(NAME.to_owned(), |key| format!("{NAME}.{key}")));
            return error;
        };
        for (name, rows) in &self.groups {
            if row < *rows {
                let key = error.key.take().map_or(String::new(), |key| format!(".{key}"));
                error.key = Some(format!("{name}{key}[{row}]"));
                break;
            }
            row -= rows;
        }
        error
    }

    /// A text that names the arrays in place of the file.
    pub fn named(&self, text: &str) -> String {
        if self.groups.is_empty() {
            return text.to_owned();
        }
        text.replace(&self.path.display().to_string(), NAME)
    }
}

/// What the sensors of a run deliver that aid its navigator, by what they measure.
pub fn delivered(scene: &Scene, source: &Source, run: u64) -> Vec<(&'static str, NumberRows)> {
    let arriving = measurements::of_run(scene, source, run);
    let of_kind = |(word, kind, places): &(&'static str, _, &[usize])| {
        let places = [0, 1].into_iter().chain(places.iter().copied());
        let places: Vec<usize> = places.collect();
        let names: Vec<_> = places.iter().map(|place| COLUMNS[*place]).collect();
        let mut rows = NumberRows::new(&names);
        for one in arriving.iter().filter(|(_, measured)| measured.kind == *kind) {
            let [time_s, arrives_s] = measurements::times_s(one, scene.rate_hz);
            let numbers = schuler_simulator::aided::columns::numbers(time_s, arrives_s, &one.1);
            let row: Vec<_> = places.iter().map(|place| numbers[*place]).collect();
            rows.add(&row);
        }
        (*word, rows)
    };
    KINDS.iter().map(of_kind).filter(|(_, rows)| !rows.is_empty()).collect()
}
