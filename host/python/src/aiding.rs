//! Options of `replay` about what aids it.

use crate::error::{Answer, Fault};
use crate::fixes::Fixes;
use crate::log::Logs;
use crate::options::{self, words};
use crate::recorded::kept;
use crate::toml;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyMapping};
use schuler_host::cli::{AidingOptions, GNSS_LAG_S, LeverArm, Sigmas, Span, VelocityLag};
use schuler_simulator::input::{Complaint, InputError};
use std::path::PathBuf;
use tempfile::TempDir;

/// Their keywords; all but the first ask for that.
pub const NAMES: [&str; 9] = [
    "gnss",
    "lever_arm",
    "gnss_lag",
    "velocity_lag",
    "gnss_sigma",
    "smooth",
    "time_tag",
    "sensors",
    "withhold",
];

/// What aids a recording, and where it lies.
pub struct Aiding {
    /// As on the command line.
    pub options: AidingOptions,
    fixes: Option<Fixes>,
    /// The file of a scene that was given as a dict.
    sensors: Option<PathBuf>,
}

impl Aiding {
    /// From keywords, which are taken out.
    pub fn take(given: &Bound<'_, PyDict>, folder: &TempDir) -> Answer<Self> {
        let mut aiding = Self { options: AidingOptions::default(), fixes: None, sensors: None };
        for name in NAMES {
            let Some(value) = given.get_item(name)? else { continue };
            given.del_item(name)?;
            if value.is_none() {
                continue;
            }
            if name != "gnss" && aiding.fixes.is_none() {
                let option = options::dashed(name);
                let accepted = "--gnss";
                return Err(Fault::argument(
                    &option,
                    "is of use with another option alone",
                    accepted,
                ));
            }
            aiding.set(name, &value, folder)?;
        }
        Ok(aiding)
    }

    fn set(&mut self, name: &str, value: &Bound<'_, PyAny>, folder: &TempDir) -> Answer<()> {
        let told = |complaint| Fault::option(&options::dashed(name), complaint);
        let options = &mut self.options;
        match name {
            "gnss" => {
                let fixes = Fixes::new(value, folder)?;
                options.gnss = Some(fixes.path.clone());
                self.fixes = Some(fixes);
            }
            "lever_arm" => {
                options.lever_arm = Some(LeverArm::parse(&words(value)?).map_err(told)?);
            }
            "gnss_lag" => options.gnss_lag = options::number(name, value, &GNSS_LAG_S)?,
            "velocity_lag" => {
                let text = value.str()?.to_string();
                options.velocity_lag = VelocityLag::parse(&text).map_err(told)?;
            }
            "gnss_sigma" => options.gnss_sigma = Sigmas::parse(&words(value)?).map_err(told)?,
            "smooth" => {
                let smooth: bool = value.extract()?;
                options.smooth = smooth.then(|| folder.path().join("smoothed.csv"));
            }
            "time_tag" => options.time_tag = Some(value.extract()?),
            "sensors" => self.options.sensors = Some(self.sensors(value, folder)?),
            _ => options.withhold = spans(value)?,
        }
        Ok(())
    }

    /// The name or path of a scene; a dict goes to a file of ours.
    fn sensors(&mut self, given: &Bound<'_, PyAny>, folder: &TempDir) -> Answer<String> {
        let text = match given.cast::<PyMapping>() {
            Ok(table) => toml::document(table, &mut Logs::default())?,
            Err(_) => match given.extract::<String>() {
                Ok(text) if text.contains(['\n', '=']) => text,
                Ok(name) => return Ok(name),
                Err(_) => return Ok(given.extract::<PathBuf>()?.to_string_lossy().into_owned()),
            },
        };
        let path = folder.path().join("sensors.toml");
        std::fs::write(&path, text).map_err(|error| kept(&error))?;
        Ok(self.sensors.insert(path).to_string_lossy().into_owned())
    }

    /// An error about a file of ours, as one about what was given.
    pub fn told(&self, mut error: InputError) -> InputError {
        let is_own = |file: &String| self.sensors.as_ref().is_some_and(|path| path == file);
        if error.file.take_if(|file| is_own(file)).is_some() {
            error.line = None;
            error.key =
                Some(error.key.map_or("sensors".to_owned(), |key| format!("sensors.{key}")));
        }
        match &self.fixes {
            Some(fixes) => fixes.told(error),
            None => error,
        }
    }

    /// What the program says, without files of ours.
    pub fn named(&self, text: &str) -> String {
        let smoothed = self.options.smooth.as_ref();
        let written = smoothed.map(|path| format!(", written to {}", path.display()));
        let text = written.map_or(text.to_owned(), |written| text.replace(&written, ""));
        self.fixes.as_ref().map_or(text.clone(), |fixes| fixes.named(&text))
    }
}

/// Pairs of times, s.
fn spans(value: &Bound<'_, PyAny>) -> Answer<Vec<Span>> {
    let refuse = |_| {
        let complaint = Complaint::new("is no list of spans", "[(from, to), …], seconds");
        Fault::option("--withhold", complaint)
    };
    let spans: Vec<[f64; 2]> = value.extract().map_err(refuse)?;
    spans.into_iter().map(|span_s| options::span("--withhold", span_s).map(Span)).collect()
}
