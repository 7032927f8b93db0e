//! Lines of `key = number`, and tables with named columns.

use crate::Failed;
use std::collections::HashMap;
use std::path::Path;

/// Of a file of lines `key = number`; comments begin with #.
#[derive(Debug)]
pub struct Numbers {
    file: String,
    numbers: HashMap<String, f64>,
}

impl Numbers {
    /// Reads one.
    pub fn read(path: &Path) -> Result<Self, Failed> {
        let mut numbers = HashMap::new();
        for line in text(path)?.lines().filter(|line| !line.starts_with('#')) {
            let (key, number) = line.split_once(" = ").ok_or_else(|| at(path, line))?;
            numbers.insert(key.to_owned(), number.parse().map_err(|_| at(path, line))?);
        }
        Ok(Self { file: path.display().to_string(), numbers })
    }

    /// The number of a key.
    pub fn get(&self, key: &str) -> Result<f64, Failed> {
        let number = self.numbers.get(key).copied();
        number.ok_or_else(|| format!("{}: no {key}", self.file).into())
    }

    /// Those of several keys.
    pub fn all<const N: usize>(&self, keys: [&str; N]) -> Result<[f64; N], Failed> {
        let mut numbers = [0.0; N];
        for (number, key) in numbers.iter_mut().zip(keys) {
            *number = self.get(key)?;
        }
        Ok(numbers)
    }
}

/// Columns of a table by their names; an empty cell is not a number.
pub fn columns<const N: usize>(path: &Path, names: [&str; N]) -> Result<Vec<[f64; N]>, Failed> {
    let text = text(path)?;
    let mut lines = text.lines();
    let header: Vec<&str> = lines.next().unwrap_or_default().split(',').collect();
    let mut places = [0; N];
    for (place, name) in places.iter_mut().zip(names) {
        let found = header.iter().position(|column| column == &name);
        *place = found.ok_or_else(|| format!("{}: no column {name}", path.display()))?;
    }
    let mut rows = Vec::new();
    for line in lines {
        let cells: Vec<&str> = line.split(',').collect();
        let mut row = [f64::NAN; N];
        for (number, place) in row.iter_mut().zip(places) {
            let cell = cells.get(place).ok_or_else(|| at(path, line))?;
            if !cell.is_empty() {
                *number = cell.parse().map_err(|_| at(path, line))?;
            }
        }
        rows.push(row);
    }
    Ok(rows)
}

/// A file's text.
pub fn text(path: &Path) -> Result<String, Failed> {
    std::fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()).into())
}

/// Writes a file.
pub fn write(path: &Path, text: &str) -> Result<(), Failed> {
    std::fs::write(path, text).map_err(|error| format!("{}: {error}", path.display()).into())
}

fn at(path: &Path, line: &str) -> Failed {
    format!("{}: {line:?} cannot be read", path.display()).into()
}
