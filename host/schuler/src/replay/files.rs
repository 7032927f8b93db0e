//! The files of a replay, which take their places together.

use super::comparison::{Comparison, Has};
use super::fly::Flight;
use super::places::{Places, REPORT, names};
use super::summary::About;
use super::{page, summary};
use crate::report::files::drawn;
use crate::report::plot;
use crate::report::sensors::Sensors;
use crate::report::traces::Traces;
use schuler_simulator::flight::{Instant, Nine};
use schuler_simulator::input::InputError;
use schuler_simulator::output::{NumberTable, OutputFile};

/// The report being written, apart from its table of drift.
pub struct ReportFiles {
    drift: NumberTable,
    picture: OutputFile,
    page: OutputFile,
    summary: OutputFile,
    svg: Option<OutputFile>,
    has: Has,
    is_aided: bool,
}

impl ReportFiles {
    /// To be in their places; none where no report is wanted. What cannot be written is found here,
    /// before the flight.
    pub fn create(places: &Places, has: Has, is_aided: bool) -> Result<Option<Self>, InputError> {
        let Some(folder) = &places.report else { return Ok(None) };
        let [drift, picture, page, summary] = REPORT.map(|name| folder.join(name));
        let names = has.numbers().map(|i| Nine::NAMES[i]);
        let sigmas = has.numbers().filter(|_| is_aided).map(|i| Nine::SIGMAS[i]);
        let columns: Vec<_> = ["time_s"].into_iter().chain(names).chain(sigmas).collect();
        Ok(Some(Self {
            drift: NumberTable::create(drift, &columns)?,
            picture: OutputFile::create(picture)?,
            page: OutputFile::create(page)?,
            summary: OutputFile::create(summary)?,
            svg: places.svg.then(|| OutputFile::create(folder.join(plot::SVG))).transpose()?,
            has,
            is_aided,
        }))
    }

    /// A row of `drift.csv`: a time, the errors that are known, and what an aided flight claims of each.
    pub fn row(&mut self, instant: &Instant) -> Result<(), InputError> {
        let numbers = instant.drift.numbers();
        let known = self.has.numbers().map(|i| numbers[i]);
        let sigmas = instant.sigma.numbers();
        let sigmas = self.has.numbers().filter(|_| self.is_aided).map(|i| sigmas[i]);
        let row: Vec<f64> = [instant.time_s].into_iter().chain(known).chain(sigmas).collect();
        self.drift.row(&row)
    }

    /// Writes what is known at the end; the files, whole, but not in their places yet.
    pub fn fill(
        self,
        flight: &Flight,
        comparison: &Comparison,
        about: &About,
        shown: (&Traces, &Sensors),
    ) -> Result<Vec<OutputFile>, InputError> {
        let Self { drift, mut picture, mut page, mut summary, svg, .. } = self;
        let names = names(svg.is_some());
        let png = drawn(&picture, page::png(flight, comparison, about))?;
        picture.put(png)?;
        page.put(page::page(flight, comparison, about, shown))?;
        summary.put(summary::json(flight, comparison, about, &names))?;
        let mut files = vec![drift.into_file(), picture, page];
        if let Some(mut svg) = svg {
            svg.put(page::svg(flight, comparison, about))?;
            files.push(svg);
        }
        files.push(summary);
        Ok(files)
    }
}
