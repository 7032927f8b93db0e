//! Where a replay's files go.

use crate::report::{drift_csv, html, plot, summary};
use std::path::{MAIN_SEPARATOR, Path, PathBuf};

/// `nav.csv`, and the folder of a report.
#[derive(Clone, Debug, PartialEq)]
pub struct Places {
    /// The rows.
    pub nav: PathBuf,
    /// The folder of the report, where one is to be written.
    pub report: Option<PathBuf>,
}

/// The files of a report.
pub const REPORT: [&str; 4] = [drift_csv::NAME, plot::NAME, html::NAME, summary::NAME];

impl Places {
    /// By what `--out` says: a folder has it all; a file NAME.csv has its report in NAME-report beside it, and a
    /// pipe or a device has none.
    pub fn new(out: &Path, is_compared: bool) -> Self {
        let ends_as_folder = out.as_os_str().to_string_lossy().ends_with(['/', MAIN_SEPARATOR]);
        if out.is_dir() || ends_as_folder {
            let report = is_compared.then(|| out.to_owned());
            return Self { nav: out.join("nav.csv"), report };
        }
        let is_file = !out.exists() || out.is_file();
        let name = out.file_stem().unwrap_or_default().to_string_lossy();
        let beside = out.with_file_name(format!("{name}-report"));
        Self { nav: out.to_owned(), report: (is_compared && is_file).then_some(beside) }
    }

    /// The files of the report with their paths.
    pub fn report_files(&self) -> Vec<(&'static str, PathBuf)> {
        let folder = self.report.iter();
        folder.flat_map(|folder| REPORT.map(|name| (name, folder.join(name)))).collect()
    }
}
