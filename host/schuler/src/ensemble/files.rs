//! The files of an ensemble: they get their names together, when it is done.

use super::{csv, page, summary};
use crate::report::head;
use schuler_simulator::ensemble::kept::Kept;
use schuler_simulator::flight::Nine;
use schuler_simulator::input::InputError;
use schuler_simulator::number::exact;
use schuler_simulator::output::{self, OutputFile, much, say_error};
use schuler_simulator::simulate::nine;
use std::path::{Path, PathBuf};
use summary::Outcome;

/// The drift of every run.
pub const RUNS: &str = "runs.csv";
/// Standard deviations over time, for documents.
pub const SVG: &str = "ensemble.svg";

/// What is written besides tables, page and summary.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Extra {
    /// The drift of every run.
    pub keep: bool,
    /// The picture for documents.
    pub svg: bool,
}

/// The files under way.
pub struct Files {
    tables: Vec<OutputFile>,
    runs: Option<OutputFile>,
    svg: Option<OutputFile>,
    page: OutputFile,
    summary: OutputFile,
    /// Of an earlier ensemble, with nothing to put in its place.
    stale: Vec<PathBuf>,
}

impl Files {
    /// To be in a folder. What cannot be written is found here, before the long work.
    pub fn create(folder: &Path, extra: Extra) -> Result<Self, InputError> {
        let tables = csv::NAMES.iter().map(|name| OutputFile::create(folder.join(name)));
        // A file of this name may be anybody's, unless an earlier ensemble says that it is its own.
        let written = head::files_of(&folder.join(summary::NAME));
        let one = |is_wanted: bool, name: &str, stale: &mut Vec<PathBuf>| {
            let path = folder.join(name);
            if is_wanted {
                return OutputFile::create(path).map(Some);
            }
            stale.extend(written.iter().any(|written| written == name).then_some(path));
            Ok(None)
        };
        let mut stale = Vec::new();
        let runs = one(extra.keep, RUNS, &mut stale)?;
        let svg = one(extra.svg, SVG, &mut stale)?;
        Ok(Self {
            tables: tables.collect::<Result<_, _>>()?,
            stale,
            runs,
            svg,
            page: OutputFile::create(folder.join(page::NAME))?,
            summary: OutputFile::create(folder.join(summary::NAME))?,
        })
    }

    /// Writes all and puts all in their places.
    pub fn finish(
        self,
        outcome: &Outcome,
        kept: &Kept,
        time_s: impl Fn(u64) -> f64,
    ) -> Result<(), InputError> {
        let Self { mut tables, runs, svg, mut page, mut summary, stale } = self;
        let findings = outcome.findings;
        for (file, table) in tables.iter_mut().zip(csv::tables(findings)) {
            file.put(table)?;
        }
        let mut names = csv::NAMES.to_vec();
        if let Some(runs) = runs {
            tables.push(every_run(runs, kept, time_s)?);
            names.push(RUNS);
        }
        if let Some(mut svg) = svg {
            svg.put(page::svg(outcome))?;
            tables.push(svg);
            names.push(SVG);
        }
        names.extend([page::NAME, summary::NAME]);
        page.put(page::page(outcome))?;
        summary.put(summary::json(outcome, &names))?;
        // The summary last, so that whoever waits for it finds the others.
        tables.extend([page, summary]);
        output::place(tables, &stale)
    }
}

/// A row for each instant of each run that reached its end.
fn every_run(
    mut file: OutputFile,
    kept: &Kept,
    time_s: impl Fn(u64) -> f64,
) -> Result<OutputFile, InputError> {
    let readings = &kept.flown.readings;
    let numbers = kept.numbers();
    let rows = (numbers.len() * readings.len()) as u64;
    if let Some(much) = much(file.path(), rows, 2 + Nine::NAMES.len()) {
        say_error(&much);
    }
    let header = [["run", "time_s"].as_slice(), &Nine::NAMES].concat();
    file.put(header.join(",") + "\n")?;
    for (place, run) in numbers.into_iter().enumerate() {
        for reading in readings {
            let mut line = format!("{run},{}", exact(time_s(reading.samples)));
            for number in nine(&reading.drifts[place]).numbers() {
                line.push(',');
                line += &exact(number);
            }
            line.push('\n');
            file.put(line)?;
        }
    }
    Ok(file)
}
