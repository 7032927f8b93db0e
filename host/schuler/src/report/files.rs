//! The files of a flight: they get their names together when it has ended, with or without an error.

use super::{DriftCsv, html, plot, summary};
use crate::cli::Every;
use schuler_simulator::flight::{Flight, Instant};
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::output::{self, OutputFile};
use std::path::{Path, PathBuf};

/// `summary.json`, `drift.csv`, `drift.png` and `report.html` of a flight under way.
#[derive(Debug)]
pub struct FlightFiles {
    drift: DriftCsv,
    summary: OutputFile,
    /// The picture and the page, where they are wanted.
    pages: Option<[OutputFile; 2]>,
    /// Files of an earlier flight that this one has none to put in the place of.
    stale: Vec<PathBuf>,
}

/// That a flight which leaves no files has not touched those of an earlier one, if there are any.
pub fn of_earlier(folder: &Path) -> Option<String> {
    let is_there = folder.join(summary::NAME).exists();
    is_there.then(|| format!("schuler: the files in {} are of an earlier run", folder.display()))
}

impl FlightFiles {
    /// To be in a folder, with all rows of the drift or some. What cannot be written is found here,
    /// before the flight.
    pub fn create(
        folder: &Path,
        every: Option<Every>,
        no_report: bool,
    ) -> Result<Self, InputError> {
        let drift = DriftCsv::create(&folder.join("drift.csv"), every)?;
        let summary = OutputFile::create(folder.join(summary::NAME))?;
        let pages = [plot::NAME, html::NAME].map(|name| folder.join(name));
        if no_report {
            return Ok(Self { drift, summary, pages: None, stale: pages.to_vec() });
        }
        let [picture, page] = pages.each_ref().map(OutputFile::create);
        Ok(Self { drift, summary, pages: Some([picture?, page?]), stale: Vec::new() })
    }

    /// Takes the next instant.
    pub fn row(&mut self, instant: &Instant) -> Result<(), InputError> {
        self.drift.row(instant)
    }

    /// Writes what is known at the end, and puts all in their places.
    pub fn finish(self, flight: &Flight) -> Result<(), InputError> {
        let Self { drift, mut summary, pages, stale } = self;
        summary.put(summary::json(flight))?;
        let mut files = vec![drift.into_file()?];
        if let Some([mut picture, mut page]) = pages {
            let drawn = plot::png(flight).map_err(|error| {
                let complaint = Complaint::new(format!("cannot be drawn: {error}"), "");
                InputError::file(&picture.path().display().to_string(), complaint)
            });
            picture.put(drawn?)?;
            page.put(html::page(flight))?;
            files.extend([picture, page]);
        }
        // Last, so that whoever waits for it finds the others.
        files.push(summary);
        output::place(files, &stale)
    }
}
