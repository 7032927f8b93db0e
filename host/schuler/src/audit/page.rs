//! The result of an audit, as a page for people and as JSON for programs.

use crate::report::head;
use schuler_report::page::{framed, page, verdict};
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
    /// Of the rows, those at the start that are marked as bad.
    pub marked: usize,
}

impl Table {
    /// Without rows.
    pub fn new(title: &str, heads: &[&str]) -> Self {
        let heads = heads.iter().map(|head| head.to_string()).collect();
        Self { title: title.to_owned(), heads, rows: Vec::new(), marked: 0 }
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

/// What stands above the tables.
#[derive(Clone, Debug, Default)]
pub struct Top {
    /// The page's title.
    pub title: String,
    /// A verdict, where there is one: whether it is good, and its words.
    pub verdict: Option<(bool, String)>,
    /// HTML before the tables.
    pub figure: String,
}

/// Writes `audit.json` and `audit.html` into a folder.
pub fn write(
    folder: &Path,
    top: &Top,
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
    let title = escape(&top.title);
    let verdict = top.verdict.as_ref().map_or(String::new(), |(good, text)| verdict(*good, text));
    let sections: String = tables.iter().map(section).collect();
    let (command, provenance) = (escape(&head::command_line()), escape(&super::provenance::line()));
    let body = format!(
        "<h1>{title}</h1>\n<p class=\"quiet\">{provenance} · <code>{command}</code></p>\n{verdict}{}{sections}",
        top.figure
    );
    output::write(folder.join("audit.html"), page(&title, &body))
}

fn section(table: &Table) -> String {
    let heads: String =
        table.heads.iter().map(|head| format!("<th>{}</th>", escape(head))).collect();
    let row = |(place, row): (usize, &Vec<String>)| {
        let cells = row.iter().map(|cell| format!("<td>{}</td>", escape(cell)));
        let class = if place < table.marked { " class=\"bad\"" } else { "" };
        format!("<tr{class}>{}</tr>\n", cells.collect::<String>())
    };
    let rows: String = table.rows.iter().enumerate().map(row).collect();
    let content = framed(&format!("<table>\n<tr>{heads}</tr>\n{rows}</table>"));
    format!("<h2>{}</h2>\n{content}", escape(&table.title))
}
