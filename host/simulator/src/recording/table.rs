//! CSV files whose columns are found by their names: references and heights.

use crate::input::{Complaint, InputError, Range, read_text};

/// A column that is looked for.
#[derive(Clone, Copy, Debug)]
pub struct Column {
    /// Its name in the header.
    pub name: &'static str,
    /// What its numbers may be.
    pub range: Range,
}

/// The numbers of a file: row by row, a number for each column that was looked for.
#[derive(Clone, Debug)]
pub struct Table {
    /// Whether each column is there.
    pub is_there: Vec<bool>,
    /// Names of columns that nobody looked for.
    pub others: Vec<String>,
    /// Rows; zero where a column is not there.
    pub rows: Vec<Vec<f64>>,
    /// The line of each row, from 1.
    pub lines: Vec<u64>,
}

/// Reads a file, whose first column is looked for is its time, which increases from row to row.
pub fn read(file: &str, columns: &[Column]) -> Result<Table, InputError> {
    parse(file, &read_text(file)?, columns)
}

/// The same from a text; `file` names it in errors.
pub fn parse(file: &str, text: &str, columns: &[Column]) -> Result<Table, InputError> {
    let (mut reader, header) = open(file, text)?;
    let places: Vec<_> =
        columns.iter().map(|column| header.iter().position(|name| name == column.name)).collect();
    if let Some(twice) =
        header.iter().enumerate().find(|(i, name)| header.iter().take(*i).any(|n| n == *name))
    {
        let complaint = Complaint::new("is there twice", "every column once");
        return Err(InputError::key(file, 1, twice.1, complaint));
    }
    let others = header.iter().filter(|name| columns.iter().all(|column| column.name != *name));
    let others = others.map(str::to_owned).collect();
    let mut rows: Vec<Vec<f64>> = Vec::new();
    let mut lines = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|error| broken(file, &error))?;
        let line = record.position().map_or(0, csv::Position::line);
        if record.len() != header.len() {
            let complaint = Complaint::new(
                format!("the row has {} values", record.len()),
                format!("{}, as the header has", header.len()),
            );
            return Err(InputError::line(file, line, complaint));
        }
        let mut row = Vec::with_capacity(columns.len());
        for (column, place) in columns.iter().zip(&places) {
            let field = place.and_then(|place| record.get(place));
            row.push(field.map_or(Ok(0.0), |field| number(file, line, column, field))?);
        }
        let is_timed = places.first().is_some_and(Option::is_some);
        if let (true, Some(before), Some(now)) =
            (is_timed, rows.last().and_then(|r| r.first()), row.first())
            && *now <= *before
        {
            let name = columns.first().map_or("", |column| column.name);
            let complaint = Complaint::new(
                format!("{now} does not come after {before} of the row before"),
                "times that increase",
            );
            return Err(InputError::key(file, line, name, complaint));
        }
        rows.push(row);
        lines.push(line);
    }
    Ok(Table { is_there: places.iter().map(Option::is_some).collect(), others, rows, lines })
}

/// A text's rows, and its header, which may begin with a byte order mark.
pub fn open<'t>(
    file: &str,
    text: &'t str,
) -> Result<(csv::Reader<&'t [u8]>, csv::StringRecord), InputError> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut reader = csv::ReaderBuilder::new();
    let mut reader = reader.trim(csv::Trim::All).flexible(true).from_reader(text.as_bytes());
    let header = reader.headers().map_err(|error| broken(file, &error))?.clone();
    Ok((reader, header))
}

/// A row that is none.
pub fn broken(file: &str, error: &csv::Error) -> InputError {
    let line = error.position().map_or(1, csv::Position::line);
    InputError::line(file, line, Complaint::new(format!("is no CSV: {error}"), ""))
}

fn number(file: &str, line: u64, column: &Column, field: &str) -> Result<f64, InputError> {
    field
        .parse()
        .map_err(|_| Complaint::new(format!("\"{field}\" is not a number"), column.range.accepted))
        .and_then(|value| column.range.check(value))
        .map_err(|complaint| InputError::key(file, line, column.name, complaint))
}
