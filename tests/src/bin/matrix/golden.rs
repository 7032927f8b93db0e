//! The golden chains' digests, as the audit program must print them.

use super::output::Output;
use schuler_host::audit::chain::Chain;
use schuler_host::audit::golden;
use schuler_simulator::input::{Complaint, InputError, read_text};
use std::collections::HashMap;
use std::path::Path;

/// Digests without rows, as the audit program prints them: those of aided flights.
const LINES: &str = "aided.txt";

/// The digests of a folder of chains.
#[derive(Clone, Debug, Default)]
pub struct Golden {
    /// The digest of a stage of a flight at a sample, or at its end: `=` and the sample.
    digests: HashMap<(String, String, String), String>,
}

impl Golden {
    /// Of a folder, with the lines of its `aided.txt`; empty where there is none.
    pub fn read(folder: &Path) -> Result<Self, InputError> {
        let mut digests = HashMap::new();
        let chains = if folder.is_dir() { golden::list(folder)? } else { Vec::new() };
        for (flight, path) in chains {
            for stage in Chain::read(&path.display().to_string())?.stages {
                let at = stage.checkpoints.iter().map(|c| (c.sample.to_string(), c.digest));
                let end = stage.end.iter().map(|c| (format!("={}", c.sample), c.digest));
                for (sample, digest) in at.chain(end) {
                    let place = (flight.clone(), stage.name.clone(), sample);
                    digests.insert(place, format!("{digest:016x}"));
                }
            }
        }
        let lines = folder.join(LINES);
        if lines.is_file() {
            let file = lines.display().to_string();
            let output = Output::parse(read_text(&file)?)
                .map_err(|what| InputError::file(&file, Complaint::new(what, "digests")))?;
            for line in output.lines() {
                let place = [line.flight, line.stage, line.sample].map(str::to_owned);
                digests.insert(place.into(), line.digest.to_owned());
            }
        }
        Ok(Self { digests })
    }

    /// How many digests of an output are golden.
    pub fn held(&self, output: &Output) -> usize {
        output.lines().filter(|line| self.get(line).is_some()).count()
    }

    /// The first place at which an output differs; `None` if it agrees in all that both have.
    pub fn parts(&self, output: &Output) -> Option<String> {
        let differs = |line: &super::output::Line<'_>| {
            self.get(line).is_some_and(|digest| digest != line.digest)
        };
        output.lines().find(differs).map(|line| line.place())
    }

    fn get(&self, line: &super::output::Line<'_>) -> Option<&str> {
        let place = [line.flight, line.stage, line.sample].map(str::to_owned);
        self.digests.get(&place.into()).map(String::as_str)
    }
}
