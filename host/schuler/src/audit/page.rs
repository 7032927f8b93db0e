//! The result of an audit, as a page for people and as JSON for programs.

use schuler_report::page::{page, panel};
use schuler_report::svg::escape;
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::output;
use serde::Serialize;
use std::path::Path;

/// A table for a page and the terminal.
#[derive(Clone, Debug, Default)]
pub struct Table {
    /// What it says, in a line.
    pub title: String,
    /// Names of its columns.
    pub heads: Vec<String>,
    /// Cells, row by row.
    pub rows: Vec<Vec<String>>,
}

impl Table {
    /// Without rows.
    pub fn new(title: &str, heads: &[&str]) -> Self {
        let heads = heads.iter().map(|head| head.to_string()).collect();
        Self { title: title.to_owned(), heads, rows: Vec::new() }
    }

    /// As the terminal shows it: columns aligned, the last as long as it will.
    pub fn text(&self) -> String {
        let lines: Vec<&Vec<String>> = std::iter::once(&self.heads).chain(&self.rows).collect();
        let width = |column: usize| {
            let cells = lines.iter().filter_map(|line| line.get(column));
            cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
        };
        let widths: Vec<usize> = (0..self.heads.len()).map(width).collect();
        let mut text = format!("{}\n", self.title);
        for line in lines {
            let cells = line.iter().zip(&widths).map(|(cell, &width)| format!("{cell:width$}"));
            let cells: Vec<_> = cells.collect();
            text += &format!("  {}\n", cells.join("  ").trim_end());
        }
        text
    }
}

/// Writes `audit.json` and `audit.html` into a folder.
pub fn write(
    folder: &Path,
    title: &str,
    tables: &[Table],
    found: &impl Serialize,
) -> Result<(), InputError> {
    let path = folder.join("audit.json");
    let fault = |error: serde_json::Error| {
        let complaint = Complaint::new(format!("cannot be written: {error}"), "");
        InputError::file(&path.display().to_string(), complaint)
    };
    let mut json = serde_json::to_string_pretty(found).map_err(fault)?;
    json.push('\n');
    output::write(&path, json)?;
    let section = |table: &Table| {
        let heads: Vec<&str> = table.heads.iter().map(String::as_str).collect();
        format!("<h2>{}</h2>\n{}", escape(&table.title), panel(&heads, &table.rows))
    };
    let title = escape(title);
    let sections: String = tables.iter().map(section).collect();
    let provenance = escape(&super::provenance::line());
    let body = format!("<h1>{title}</h1>\n<p class=\"quiet\">{provenance}</p>\n{sections}");
    output::write(folder.join("audit.html"), page(&title, &body))
}
