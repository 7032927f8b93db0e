//! Options of `allan` and `datasheet`.

use super::apart::{self, Written};
use super::options::{self, FlightOptions};
use clap::Args;
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::rest::units::Units;
use schuler_simulator::scene::{self, Scene, builtin};
use std::path::{Path, PathBuf};

/// Options of `allan`.
#[derive(Args, Clone, Debug, Default, PartialEq)]
#[command(after_help = "Examples:\n  schuler allan paper --duration 7200\n  \
    schuler allan --imu still.csv --out out/still\n  \
    schuler allan --imu car.imu --span 1020..1500\n  \
    schuler allan mine.toml --imu still.csv     (is this the sensor that the scene describes?)")]
pub struct AllanArgs {
    /// A built-in scene or the path of a TOML file, whose terms are compared [default without --imu: paper]
    #[arg(value_parser = options::name())]
    pub scene: Option<String>,
    /// A recording at rest, instead of the scene's own errors: an imu.csv or a PSINS .imu
    #[arg(long, value_name = "FILE")]
    pub imu: Option<PathBuf>,
    /// The part of the recording that is at rest, seconds of its own time
    #[arg(long, value_name = "A..B", requires = "imu", allow_hyphen_values = true, value_parser = span)]
    pub span: Option<Span>,
    /// What the recording's numbers are in, as for `replay`
    #[arg(long, value_name = "WORDS", requires = "imu", value_parser = Units::parse)]
    pub units: Option<Units>,
    /// Folder for allan.csv, allan.html and sensors.toml [default: none is written]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Write allan.svg, too: the charts for documents
    #[arg(long, requires = "out")]
    pub svg: bool,
    /// What replaces the scene's own values; --rate states that of a recording.
    #[command(flatten)]
    pub flight: FlightOptions,
}

/// From and to, s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span(pub [f64; 2]);

pub(super) fn span(text: &str) -> Result<Span, Complaint> {
    let accepted = "A..B, seconds of the recording's own time, A before B";
    let complaint = || Complaint::new("is not a span", accepted);
    let (from, to) = text.split_once("..").ok_or_else(complaint)?;
    let [from_s, to_s] = [options::time_s(from)?, options::time_s(to)?];
    if from_s < to_s { Ok(Span([from_s, to_s])) } else { Err(complaint()) }
}

impl AllanArgs {
    /// The scene that is compared; none where a recording stands alone.
    pub fn scene(&self) -> Result<Option<Scene>, InputError> {
        let name = match (&self.scene, &self.imu) {
            (None, Some(_)) => return Ok(None),
            (name, _) => name.as_deref().unwrap_or(builtin::DEFAULT),
        };
        let mut scene = scene::load(name)?;
        if self.imu.is_none() {
            self.flight.apply(&mut scene)?;
        } else if self.flight.seed.is_some() || self.flight.duration.is_some() {
            let complaint =
                Complaint::new("is of the scene, and --imu takes its place", "--rate alone");
            let option = if self.flight.seed.is_some() { "--seed" } else { "--duration" };
            return Err(InputError::option(option, complaint));
        }
        Ok(Some(scene))
    }

    /// The files that are written, into a folder.
    pub fn files(&self) -> Result<Option<Vec<PathBuf>>, InputError> {
        let Some(folder) = &self.out else { return Ok(None) };
        let names = ["allan.csv", "allan.html", "sensors.toml", "allan.svg"];
        let names = &names[..if self.svg { 4 } else { 3 }];
        let files: Vec<_> = names.iter().map(|name| folder.join(name)).collect();
        let written: Vec<_> = files
            .iter()
            .zip(names)
            .map(|(path, what)| Written { option: "--out", what, path: path.clone() })
            .collect();
        let mut read: Vec<(&str, &Path)> = Vec::new();
        read.extend(self.imu.as_deref().map(|imu| ("--imu reads", imu)));
        let scene = self.scene.as_deref().filter(|name| builtin::scene(name).is_none());
        read.extend(scene.map(|name| ("the scene is read from", Path::new(name))));
        apart::check(&written, &read)?;
        Ok(Some(files))
    }
}

/// Options of `datasheet`.
#[derive(Args, Clone, Debug, PartialEq, Eq)]
#[command(after_help = "Example:\n  schuler datasheet adis.toml >> scene.toml\n\n\
    The file has tables [gyro] and [accelerometer] with data-sheet keys; `schuler datasheet --keys` lists them.")]
pub struct DatasheetArgs {
    /// A TOML file with the data sheet's numbers
    #[arg(required_unless_present = "keys")]
    pub file: Option<String>,
    /// Print every key that the file may have
    #[arg(long, conflicts_with = "file")]
    pub keys: bool,
}
