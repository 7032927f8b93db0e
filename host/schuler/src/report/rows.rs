//! `nav.csv` and `truth.csv` of a run: the motion as computed and as it is, row by row.

use super::every::Every;
use super::thinned::Thinned;
use schuler_simulator::flight::Instant;
use schuler_simulator::input::InputError;
use schuler_simulator::output::OutputFile;
use schuler_simulator::recording::navigation::{NavigationRow, NavigationWriter};
use std::path::Path;

/// The files of the computed motion and of the true one.
pub const NAMES: [&str; 2] = ["nav.csv", "truth.csv"];

/// Both files being written.
#[derive(Debug)]
pub struct RowFiles {
    nav: NavigationWriter,
    truth: NavigationWriter,
    kept: Thinned,
}

impl RowFiles {
    /// To be in a folder.
    pub fn create(folder: &Path, every: Option<Every>) -> Result<Self, InputError> {
        let [nav, truth] = NAMES;
        Ok(Self {
            nav: NavigationWriter::create(folder.join(nav))?,
            truth: NavigationWriter::create(folder.join(truth))?,
            kept: Thinned::new(every, 0.0),
        })
    }

    /// Takes the next instant: the first is written, the last, and those in between that are wanted.
    pub fn row(&mut self, instant: &Instant) -> Result<(), InputError> {
        if self.kept.keeps(instant) { self.write(instant) } else { Ok(()) }
    }

    fn write(&mut self, instant: &Instant) -> Result<(), InputError> {
        let Instant { time_s, computed, truth, .. } = instant;
        self.nav.row(&NavigationRow::new(*time_s, computed))?;
        self.truth.row(&NavigationRow::new(*time_s, truth))
    }

    /// The files, whole, but not in their places yet.
    pub fn into_files(mut self) -> Result<[OutputFile; 2], InputError> {
        if let Some(last) = self.kept.last() {
            self.write(&last)?;
        }
        Ok([self.nav.into_file(), self.truth.into_file()])
    }
}
