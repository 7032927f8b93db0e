//! Where a replay's files go.

use crate::report::{drift_csv, head, html, plot, summary};
use std::path::{MAIN_SEPARATOR, Path, PathBuf};

/// `nav.csv`, and the folder of a report.
#[derive(Clone, Debug, PartialEq)]
pub struct Places {
    /// The rows.
    pub nav: PathBuf,
    /// The folder of the report, where one is to be written.
    pub report: Option<PathBuf>,
    /// Whether it has a picture for documents.
    pub svg: bool,
}

/// The files of a report.
pub const REPORT: [&str; 4] = [drift_csv::NAME, plot::NAME, html::NAME, summary::NAME];

/// The same with a picture for documents, if there is one; the summary last.
pub fn names(svg: bool) -> Vec<&'static str> {
    let [drift, picture, page, summary] = REPORT;
    let svg = svg.then_some(plot::SVG);
    [drift, picture, page].into_iter().chain(svg).chain([summary]).collect()
}

impl Places {
    /// By what `--out` says: a folder has it all; a file NAME.csv has its report in NAME-report beside it, and a
    /// pipe or a device has none.
    pub fn new(out: &Path, is_compared: bool, svg: bool) -> Self {
        let ends_as_folder = out.as_os_str().to_string_lossy().ends_with(['/', MAIN_SEPARATOR]);
        if out.is_dir() || ends_as_folder {
            let report = is_compared.then(|| out.to_owned());
            return Self { nav: out.join("nav.csv"), report, svg };
        }
        let is_file = !out.exists() || out.is_file();
        let name = out.file_stem().unwrap_or_default().to_string_lossy();
        let beside = out.with_file_name(format!("{name}-report"));
        Self { nav: out.to_owned(), report: (is_compared && is_file).then_some(beside), svg }
    }

    /// Of an earlier replay's report, with nothing to put in their place. A file of such a name may be anybody's, unless
    /// the earlier summary says that it is its own.
    pub fn stale(&self) -> Vec<PathBuf> {
        let Some(folder) = &self.report else { return Vec::new() };
        let written = head::files_of(&folder.join(summary::NAME));
        let is_stale = !self.svg && written.iter().any(|name| name == plot::SVG);
        is_stale.then(|| folder.join(plot::SVG)).into_iter().collect()
    }

    /// The files of the report with their paths.
    pub fn report_files(&self) -> Vec<(&'static str, PathBuf)> {
        let folder = self.report.iter();
        let of = |folder: &'_ PathBuf| {
            names(self.svg).into_iter().map(|name| (name, folder.join(name))).collect::<Vec<_>>()
        };
        folder.flat_map(of).collect()
    }
}
