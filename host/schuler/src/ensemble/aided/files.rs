//! The files of an aided ensemble: they get their names together, when it is done.

use super::super::files::{Extra, RUNS, SVG};
use super::super::page::NAME as PAGE;
use super::super::summary::{self, NAME, Told};
use super::findings::Findings;
use super::{csv, page};
use crate::report::head;
use schuler_simulator::input::InputError;
use schuler_simulator::output::{self, OutputFile};
use std::path::{Path, PathBuf};

/// The files under way.
pub struct Files {
    tables: Vec<OutputFile>,
    smoothed: Option<OutputFile>,
    runs: Option<OutputFile>,
    svg: Option<OutputFile>,
    page: OutputFile,
    summary: OutputFile,
    /// Of an earlier ensemble, with nothing to put in their place.
    stale: Vec<PathBuf>,
}

impl Files {
    /// To be in a folder. What cannot be written is found here, before the long work.
    pub fn create(folder: &Path, smoothed: bool, extra: Extra) -> Result<Self, InputError> {
        let create = |name: &str| OutputFile::create(folder.join(name));
        let one = |is_wanted: bool, name| is_wanted.then(|| create(name)).transpose();
        let names: Vec<&str> = names(smoothed, extra).collect();
        // A file of this name may be anybody's, unless an earlier ensemble says that it is its own.
        let written = head::files_of(&folder.join(NAME));
        let stale = written.iter().filter(|written| !names.contains(&written.as_str()));
        Ok(Self {
            tables: csv::NAMES.into_iter().map(create).collect::<Result<_, _>>()?,
            smoothed: one(smoothed, csv::SMOOTHED)?,
            runs: one(extra.keep, RUNS)?,
            svg: one(extra.svg, SVG)?,
            page: create(PAGE)?,
            summary: create(NAME)?,
            stale: stale.map(|name| folder.join(name)).collect(),
        })
    }

    /// Writes all and puts all in their places.
    pub fn finish(self, told: &Told, findings: &Findings) -> Result<(), InputError> {
        let Self { mut tables, smoothed, runs, svg, mut page, mut summary, stale } = self;
        let extra = Extra { keep: runs.is_some(), svg: svg.is_some() };
        for (file, table) in tables.iter_mut().zip(csv::tables(findings)) {
            file.put(table)?;
        }
        let is_smoothed = smoothed.is_some();
        if let Some(mut smoothed) = smoothed {
            smoothed.put(csv::errors(&findings.smoothed))?;
            tables.push(smoothed);
        }
        if let Some(mut runs) = runs {
            runs.put(csv::every_run(findings))?;
            tables.push(runs);
        }
        if let Some(mut svg) = svg {
            svg.put(page::svg(told, findings))?;
            tables.push(svg);
        }
        page.put(page::page(told, findings))?;
        let names: Vec<&str> = names(is_smoothed, extra).collect();
        summary.put(summary::text(told, &names))?;
        // The summary last, so that whoever waits for it finds the others.
        tables.extend([page, summary]);
        output::place(tables, &stale)
    }
}

fn names(smoothed: bool, extra: Extra) -> impl Iterator<Item = &'static str> {
    let more = [(smoothed, csv::SMOOTHED), (extra.keep, RUNS), (extra.svg, SVG)];
    let more = more.into_iter().filter(|(is_there, _)| *is_there).map(|(_, name)| name);
    csv::NAMES.into_iter().chain(more).chain([PAGE, NAME])
}
