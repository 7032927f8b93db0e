//! The files of a flight: they get their names together when it has ended, with or without an error.

use super::every::Every;
use super::html::Shown;
use super::rows::{self, RowFiles};
use super::sensors::Sensors;
use super::traces::Traces;
use super::{DriftCsv, Lockstep, drift_csv, head, html, plot, summary};
use schuler_simulator::flight::{Flight, Instant};
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::output::{self, OutputFile, say_error};
use schuler_simulator::theory::Theory;
use std::path::{Path, PathBuf};

/// Every file of a flight, written or not.
pub const NAMES: [&str; 8] = [
    drift_csv::NAME,
    summary::NAME,
    plot::NAME,
    html::NAME,
    rows::NAMES[0],
    rows::NAMES[1],
    plot::SVG,
    SMOOTHED,
];
/// What a smoother makes of a flight, in the form of `drift.csv`.
pub const SMOOTHED: &str = "smoothed.csv";

/// What is to be written besides `summary.json` and `drift.csv`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wanted {
    /// The rows of tables; all of them unless told.
    pub every: Option<Every>,
    /// `drift.png` and `report.html`.
    pub report: bool,
    /// `nav.csv` and `truth.csv`.
    pub rows: bool,
    /// `drift.svg`.
    pub svg: bool,
    /// `smoothed.csv`.
    pub smoothed: bool,
    /// The number of the run, whose sensors the page shows.
    pub run: u64,
}

/// `summary.json`, `drift.csv`, `drift.png`, `report.html`, `nav.csv` and `truth.csv` of a flight under way.
#[derive(Debug)]
pub struct FlightFiles {
    drift: DriftCsv,
    summary: OutputFile,
    /// The picture and the page, where they are wanted.
    pages: Option<[OutputFile; 2]>,
    /// The picture for documents, where it is wanted.
    svg: Option<OutputFile>,
    /// What a smoother makes of it, where there is one.
    smoothed: Option<DriftCsv>,
    /// What the page shows of every row.
    traces: Traces,
    run: u64,
    /// The motion, where it is wanted.
    rows: Option<RowFiles>,
    /// Files of an earlier flight that this one has none to put in the place of.
    stale: Vec<PathBuf>,
}

/// Says, before a flight, that its files will take the place of those of another command.
pub fn tell_replaced(folder: &Path) {
    tell_replaced_by(folder, summary::NAME, &head::command());
}

/// The same of a command, an argument each, with a summary of a name.
pub fn tell_replaced_by(folder: &Path, summary: &str, command: &[String]) {
    if let Some(before) = head::command_of(&folder.join(summary))
        && before != command
    {
        let (folder, before) = (folder.display(), head::shell(&before));
        say_error(&format!(
            "schuler: replaces in {folder} the files of `{before}`; --out keeps both"
        ));
    }
}

/// That a flight which leaves no files has not touched those of an earlier one, if there are any.
pub fn of_earlier(folder: &Path) -> Option<String> {
    let is_there = folder.join(summary::NAME).exists();
    is_there.then(|| format!("schuler: the files in {} are of an earlier run", folder.display()))
}

impl FlightFiles {
    /// To be in a folder. What cannot be written is found here, before the flight.
    pub fn create(folder: &Path, wanted: Wanted) -> Result<Self, InputError> {
        let Wanted { every, report, rows, svg, smoothed, run } = wanted;
        let drift = DriftCsv::create(&folder.join(drift_csv::NAME), every)?;
        let summary = OutputFile::create(folder.join(summary::NAME))?;
        let mut stale = Vec::new();
        let pages = [plot::NAME, html::NAME].map(|name| folder.join(name));
        let pages = if report {
            let [picture, page] = pages.each_ref().map(OutputFile::create);
            Some([picture?, page?])
        } else {
            stale.extend(pages);
            None
        };
        // Files of these names may be anybody's, unless an earlier flight says that they are its own.
        let written = head::files_of(&folder.join(summary::NAME));
        let mut leave = |names: &[&str]| {
            let is_own = |name: &&&str| written.iter().any(|written| written == *name);
            stale.extend(names.iter().filter(is_own).map(|name| folder.join(name)));
        };
        let rows = if rows {
            Some(RowFiles::create(folder, every)?)
        } else {
            leave(&rows::NAMES);
            None
        };
        let svg = if svg {
            Some(OutputFile::create(folder.join(plot::SVG))?)
        } else {
            leave(&[plot::SVG]);
            None
        };
        let smoothed = if smoothed {
            Some(DriftCsv::create(&folder.join(SMOOTHED), every)?)
        } else {
            leave(&[SMOOTHED]);
            None
        };
        let traces = Traces::default();
        Ok(Self { drift, summary, pages, svg, smoothed, traces, run, rows, stale })
    }

    /// Takes the next instant.
    pub fn row(&mut self, instant: &Instant) -> Result<(), InputError> {
        self.drift.row(instant)?;
        if self.pages.is_some() {
            self.traces.row(instant);
        }
        self.rows.as_mut().map_or(Ok(()), |rows| rows.row(instant))
    }

    /// Writes what is known at the end, and puts all in their places, together with others.
    pub fn finish(
        self,
        flight: &Flight,
        others: Vec<OutputFile>,
        lockstep: Option<Lockstep>,
    ) -> Result<(), InputError> {
        let Self { drift, mut summary, pages, svg, smoothed, traces, run, rows, stale } = self;
        let json = |names: &[&str]| summary::json(flight, names, lockstep.as_ref());
        // The folder of the first is locked.
        let mut files = vec![drift.into_file()?];
        files.extend(others);
        let mut names = vec![drift_csv::NAME];
        if let Some([mut picture, mut page]) = pages {
            picture.put(drawn(&picture, plot::png(flight))?)?;
            let sensors = Sensors::of(flight, run).ok();
            let covariance_m2 = end_covariance(flight);
            let lockstep = lockstep.clone();
            page.put(html::page(flight, &Shown { traces, sensors, covariance_m2, lockstep }))?;
            files.extend([picture, page]);
            names.extend([plot::NAME, html::NAME]);
        }
        if let Some(mut svg) = svg {
            svg.put(plot::svg(flight))?;
            files.push(svg);
            names.push(plot::SVG);
        }
        if let Some(mut smoothed) = smoothed {
            flight.smoothed.iter().try_for_each(|instant| smoothed.row(instant))?;
            files.push(smoothed.into_file()?);
            names.push(SMOOTHED);
        }
        if let Some(rows) = rows {
            files.extend(rows.into_files()?);
            names.extend(rows::NAMES);
        }
        // Last, so that whoever waits for it finds the others.
        names.push(summary::NAME);
        summary.put(json(&names))?;
        files.push(summary);
        output::place(files, &stale)
    }
}

/// The covariance of north and east that theory expects at the end, m²; none where that has ended.
pub fn end_covariance(flight: &Flight) -> Option<[[f64; 2]; 2]> {
    let is_known = flight.last.sigma.position_m.iter().all(|sigma| sigma.is_finite());
    let theory = Theory::new(&flight.scene).ok().filter(|_| is_known);
    let covariance = theory?.covariance(flight.last.time_s);
    Some([0, 1].map(|i| [0, 1].map(|j| covariance[i][j])))
}

/// A picture, or why it could not be drawn.
pub fn drawn(picture: &OutputFile, png: std::io::Result<Vec<u8>>) -> Result<Vec<u8>, InputError> {
    png.map_err(|error| {
        let complaint = Complaint::new(format!("cannot be drawn: {error}"), "");
        InputError::file(&picture.path().display().to_string(), complaint)
    })
}
