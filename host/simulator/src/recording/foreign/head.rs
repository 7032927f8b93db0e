//! What stands before the rows of a text file: lines that may be its header, and how its rows are cut.

use super::super::lines::Lines;
use super::dialect::Text;
use super::dialect::{Delimiter, Splitter, comment, number};
use super::map::Column;
use crate::input::{Complaint, InputError};
use std::fs::File;

/// Lines that may be a header, at most.
const MOST: usize = 64;

/// The top of a file.
#[derive(Clone, Debug)]
pub struct Head {
    /// The file's name.
    pub name: String,
    /// What stands between the fields of a row.
    pub delimiter: Delimiter,
    /// Lines that may be the header, by their number, and their fields.
    pub headers: Vec<(u64, Vec<String>)>,
    /// Where the first row begins: bytes, and the number of the line before.
    pub begins: (u64, u64),
    /// Fields of the first row; empty where there is none.
    pub first: Vec<String>,
}

/// A column in its place, with its name for errors.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// From 0.
    pub at: usize,
    /// As the header has it, or its number.
    pub name: String,
}

impl Head {
    /// Of a file. With a tag, rows are those that begin with it.
    pub fn of(name: &str, file: &File, text: &Text, tag: Option<&str>) -> Result<Self, InputError> {
        let mut lines = Lines::new(name, file, (0, 0))?;
        let mut headers: Vec<(u64, Vec<String>)> = Vec::new();
        let mut begins = lines.place();
        while lines.next_filled()? {
            let (line, noted) = (lines.number, comment(text, lines.text()));
            if line <= text.skip_lines {
                begins = lines.place();
                continue;
            }
            let fields = cut(text, noted.unwrap_or(lines.text()));
            let row = noted.is_none()
                && match tag {
                    Some(tag) => fields.first().is_some_and(|first| first == tag),
                    None => is_row(&fields),
                };
            if row {
                let delimiter = cut_at(text, lines.text());
                let name = name.to_owned();
                return Ok(Self { name, delimiter, headers, begins, first: fields });
            }
            let belongs = tag.is_none_or(|tag| fields.first().is_some_and(|first| first == tag));
            if belongs {
                // Names of one column may have blanks in them.
                if !fields.is_empty()
                    && cut_at(text, noted.unwrap_or(lines.text())) == Delimiter::Blanks
                {
                    let whole = noted.unwrap_or(lines.text()).trim_ascii();
                    headers.push((line, vec![String::from_utf8_lossy(whole).into_owned()]));
                }
                headers.push((line, fields));
                if headers.len() > MOST {
                    headers.remove(0);
                }
            }
            begins = lines.place();
        }
        let (delimiter, name) = (text.delimiter.unwrap_or(Delimiter::Byte(b',')), name.to_owned());
        Ok(Self { name, delimiter, headers, begins, first: Vec::new() })
    }

    /// Whether one line that may be the header has all of these names.
    pub fn has(&self, columns: &[&Column]) -> bool {
        let names = || columns.iter().map(|column| name(column));
        let in_line = |fields: &[String], wanted: &str| fields.iter().any(|f| same(f, wanted));
        self.headers
            .iter()
            .any(|(_, fields)| names().all(|name| name.is_some_and(|name| in_line(fields, name))))
    }

    /// The places of columns, or what is wrong with the first that is not there.
    pub fn places(&self, columns: &[&Column]) -> Result<Vec<Place>, InputError> {
        let names: Vec<_> = columns.iter().filter_map(|column| name(column)).collect();
        let has = |fields: &[String], name: &str| fields.iter().any(|field| same(field, name));
        let whole = |fields: &[String]| names.iter().all(|name| has(fields, name));
        let header = self.headers.iter().rev().find(|(_, fields)| whole(fields));
        let header = header.or_else(|| {
            let count = |fields: &[String]| names.iter().filter(|name| has(fields, name)).count();
            self.headers.iter().max_by_key(|(line, fields)| (count(fields), *line))
        });
        let place = |column: &Column| match column {
            Column::Number(number) => {
                let at = number - 1;
                let named = header.and_then(|(_, fields)| fields.get(at)).filter(|f| !f.is_empty());
                let name = named.map_or_else(|| format!("column {number}"), Clone::clone);
                Ok(Place { at, name })
            }
            Column::Name(wanted) => {
                let Some((line, fields)) = header else {
                    let what = "has no header, so no column of this name";
                    let accepted = "columns by their number from 1";
                    let error = InputError::file(&self.name, Complaint::new(what, accepted));
                    return Err(InputError { key: Some(wanted.clone()), ..error });
                };
                let mut found = fields.iter().enumerate().filter(|(_, field)| same(field, wanted));
                let at = found.next().map(|(at, _)| at);
                let twice = found.next().is_some();
                match at {
                    Some(at) if !twice => Ok(Place { at, name: fields[at].clone() }),
                    _ => {
                        let what =
                            if twice { "is there twice" } else { "is no column of the header" };
                        let accepted = format!("{}, or a number from 1", fields.join(", "));
                        let complaint = Complaint::new(what, accepted);
                        Err(InputError::key(&self.name, *line, wanted, complaint))
                    }
                }
            }
        };
        columns.iter().map(|column| place(column)).collect()
    }
}

fn name(column: &Column) -> Option<&str> {
    match column {
        Column::Name(name) => Some(name),
        Column::Number(_) => None,
    }
}

/// Whether a header's field is a column of a name.
fn same(field: &str, name: &str) -> bool {
    let plain = |text: &str| text.trim_start_matches(['#', '%', ' ']).to_lowercase();
    plain(field) == plain(name)
}

fn cut_at(text: &Text, line: &[u8]) -> Delimiter {
    text.delimiter.unwrap_or_else(|| Delimiter::of(line))
}

fn cut(text: &Text, line: &[u8]) -> Vec<String> {
    let line = line.trim_ascii();
    let mut splitter = Splitter::new(cut_at(text, line));
    splitter.split(line);
    splitter.fields().map(|field| String::from_utf8_lossy(field).into_owned()).collect()
}

/// Whether a line is a row of numbers: a header has none, or hardly any.
fn is_row(fields: &[String]) -> bool {
    let numbers = fields.iter().filter(|field| number(field.as_bytes()).is_some()).count();
    4 * numbers > fields.len()
}
