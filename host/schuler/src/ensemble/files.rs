//! The files of an ensemble: they get their names together, when it is done.

use super::{csv, page, summary};
use crate::report::head;
use schuler_simulator::ensemble::kept::Kept;
use schuler_simulator::flight::Nine;
use schuler_simulator::input::InputError;
use schuler_simulator::number::exact;
use schuler_simulator::output::{self, OutputFile, much};
use schuler_simulator::simulate::nine;
use std::path::{Path, PathBuf};
use summary::Outcome;

/// The drift of every run.
pub const RUNS: &str = "runs.csv";

/// The files under way.
pub struct Files {
    tables: Vec<OutputFile>,
    runs: Option<OutputFile>,
    page: OutputFile,
    summary: OutputFile,
    /// Of an earlier ensemble, with nothing to put in its place.
    stale: Vec<PathBuf>,
}

impl Files {
    /// To be in a folder. What cannot be written is found here, before the long work.
    pub fn create(folder: &Path, keep: bool) -> Result<Self, InputError> {
        let tables = csv::NAMES.iter().map(|name| OutputFile::create(folder.join(name)));
        let runs = folder.join(RUNS);
        // A file of this name may be anybody's, unless an earlier ensemble says that it is its own.
        let written = head::files_of(&folder.join(summary::NAME));
        let is_own = written.iter().any(|name| name == RUNS);
        Ok(Self {
            tables: tables.collect::<Result<_, _>>()?,
            stale: if is_own && !keep { vec![runs.clone()] } else { Vec::new() },
            runs: keep.then(|| OutputFile::create(&runs)).transpose()?,
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
        let Self { mut tables, runs, mut page, mut summary, stale } = self;
        let findings = outcome.findings;
        for (file, table) in tables.iter_mut().zip(csv::tables(findings)) {
            file.put(table)?;
        }
        let mut names = csv::NAMES.to_vec();
        if let Some(runs) = runs {
            tables.push(every_run(runs, kept, time_s)?);
            names.push(RUNS);
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
        eprintln!("{much}");
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
