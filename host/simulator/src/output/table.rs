//! CSV files.

use super::file::OutputFile;
use crate::input::InputError;
use std::path::Path;

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
        let written = self.file.put(&self.line);
        self.line.clear();
        written
    }

    /// The file, whole, but not in its place yet.
    pub fn into_file(self) -> OutputFile {
        self.file
    }

    /// Puts the file in its place.
    pub fn finish(self) -> Result<(), InputError> {
        self.file.finish()
    }
}

/// A CSV file of words and numbers, in memory.
pub fn csv<const N: usize>(
    columns: [&str; N],
    rows: impl IntoIterator<Item = [String; N]>,
) -> Vec<u8> {
    let mut lines = csv::Writer::from_writer(Vec::new());
    // Records of one length, to memory: neither can fail.
    let _ = lines.write_record(columns);
    for row in rows {
        let _ = lines.write_record(row);
    }
    lines.into_inner().unwrap_or_default()
}
