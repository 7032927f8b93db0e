//! Options of `emulate`.

use super::apart::{self, Written};
use super::{FlightOptions, options};
use clap::Args;
use schuler_simulator::input::InputError;
use schuler_simulator::scene::{self, Scene, builtin};
use std::path::{Path, PathBuf};

/// Options of `emulate`.
#[derive(Args, Clone, Debug, PartialEq)]
#[command(after_help = "Examples:\n  schuler emulate hard --out imu.csv --perfect\n  \
    schuler emulate paper --out imu.csv --truth truth.csv\n  \
    schuler emulate aided-drive --out imu.csv --gnss gnss.csv")]
pub struct EmulateArgs {
    /// A built-in scene (`schuler scenes` lists them) or the path of a TOML file [default: paper]
    #[arg(value_parser = options::name())]
    pub scene: Option<String>,
    /// The file to write; the state that navigation starts from goes to initial.toml beside it
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
    /// Write the true motion, too: the columns of nav.csv, the start and a row per sample
    #[arg(long, value_name = "FILE")]
    pub truth: Option<PathBuf>,
    /// Write what the scene's receiver and its other aiding sensors deliver, too, in the order of arrival
    #[arg(long, value_name = "FILE")]
    pub gnss: Option<PathBuf>,
    /// Write ROS 2 messages, too: /imu (means over each sample) and /truth (NavSatFix, PoseStamped)
    #[arg(long, value_name = "FILE")]
    pub mcap: Option<PathBuf>,
    /// The stream and the start of the run of this number, as an ensemble has them
    #[arg(long = "run", value_name = "N", default_value = "0", allow_negative_numbers = true, value_parser = options::run)]
    pub number: u64,
    /// Without the scene's sensor errors
    #[arg(long)]
    pub perfect: bool,
    /// Instantaneous rates instead of increments
    #[arg(long)]
    pub rates: bool,
    /// What replaces the scene's own values.
    #[command(flatten)]
    pub flight: FlightOptions,
}

impl EmulateArgs {
    /// The scene, with every option applied.
    pub fn scene(&self) -> Result<Scene, InputError> {
        let name = self.scene.as_deref().unwrap_or(builtin::DEFAULT);
        let mut scene = scene::load(name)?;
        self.flight.apply(&mut scene)?;
        self.check(name)?;
        if self.perfect {
            scene.gyro = Default::default();
            scene.accelerometer = Default::default();
        }
        Ok(scene)
    }

    /// Where the start goes: beside the stream, unless that is a pipe or a device.
    pub fn initial(&self) -> Option<PathBuf> {
        let is_file = !self.out.exists() || self.out.is_file();
        is_file.then(|| self.out.with_file_name("initial.toml"))
    }

    /// No file is written over the scene, nor over another.
    fn check(&self, scene: &str) -> Result<(), InputError> {
        let mut written = vec![Written::named("--out", &self.out)];
        written.extend(self.truth.as_deref().map(|truth| Written::named("--truth", truth)));
        written.extend(self.gnss.as_deref().map(|gnss| Written::named("--gnss", gnss)));
        written.extend(self.mcap.as_deref().map(|mcap| Written::named("--mcap", mcap)));
        let what = "initial.toml beside it";
        written.extend(self.initial().map(|path| Written { option: "--out", what, path }));
        let is_file = builtin::scene(scene).is_none();
        let read = is_file.then_some(("the scene is read from", Path::new(scene)));
        apart::check(&written, read.as_slice())
    }
}
