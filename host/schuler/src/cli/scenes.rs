//! Options of `scenes` and `trajectory`.

use super::apart::{self, Written};
use super::options::{self, FlightOptions};
use clap::Args;
use schuler_simulator::input::InputError;
use schuler_simulator::scene::{self, Scene, builtin};
use std::path::{Path, PathBuf};

/// Options of `scenes`.
#[derive(Args, Clone, Debug, Default, PartialEq, Eq)]
#[command(after_help = "Examples:\n  schuler scenes\n  \
    schuler scenes circuit > mine.toml\n  schuler scenes --keys")]
pub struct ScenesArgs {
    /// The built-in scene to print, a commented TOML file to start from
    pub name: Option<String>,
    /// Print every key that a scene may have
    #[arg(long, conflicts_with = "name")]
    pub keys: bool,
}

/// Options of `trajectory`.
#[derive(Args, Clone, Debug, Default, PartialEq)]
#[command(after_help = "Example:\n  schuler trajectory circuit --out circuit.kml")]
pub struct TrajectoryArgs {
    /// A built-in scene (`schuler scenes` lists them) or the path of a TOML file [default: paper]
    #[arg(value_parser = options::name())]
    pub scene: Option<String>,
    /// The file to write: .csv (columns of nav.csv), .kml, .gpx, .geojson or .mcap (ROS 2 messages)
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Rows per second of the file [default: the scene's rate, for a map 1]
    #[arg(long, value_name = "HZ", allow_negative_numbers = true, value_parser = options::rate_hz)]
    pub rate: Option<f64>,
    /// Length, seconds
    #[arg(long, value_name = "S", allow_negative_numbers = true, value_parser = options::duration_s)]
    pub duration: Option<f64>,
}

impl TrajectoryArgs {
    /// The scene, with its length.
    pub fn scene(&self) -> Result<Scene, InputError> {
        let name = self.scene.as_deref().unwrap_or(builtin::DEFAULT);
        let mut scene = scene::load(name)?;
        let length = FlightOptions { duration: self.duration, ..FlightOptions::default() };
        length.apply(&mut scene)?;
        let log = scene.trajectory.route.as_ref().and_then(|route| route.from.file());
        let read: Vec<_> = builtin::scene(name)
            .is_none()
            .then_some(("the scene is read from", Path::new(name)))
            .into_iter()
            .chain(log.map(|log| ("the scene's log is read from", Path::new(log))))
            .collect();
        let written = self.out.as_deref().map(|out| Written::named("--out", out));
        apart::check(written.as_slice(), &read)?;
        Ok(scene)
    }
}
