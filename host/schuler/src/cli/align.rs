//! Options of `align`.

use super::apart::{self, Written};
use super::{AidingOptions, Handling, Lag, NavigatorOptions, ReplayArgs, options};
use clap::{Args, ValueEnum};
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::recording::foreign::Columns;
use schuler_simulator::recording::mounting::Mounting;
use schuler_simulator::rest::units::Units;
use schuler_simulator::scene;
use schuler_simulator::scene::{Alignment, Base, Scene, builtin};
use std::path::{Path, PathBuf};

/// How long an alignment takes unless something else is said, s.
const DEFAULT_S: f64 = 120.0;

/// How to align.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Method {
    /// Fine where samples come at a constant rate, two-vector else
    #[default]
    Auto,
    /// By a filter that finds biases, too
    Fine,
    /// By velocities in two inertial frames: for a vehicle that rotates about its place
    Inertial,
    /// By the means of gyros and accelerometers alone
    TwoVector,
}

/// Options of `align`.
#[derive(Args, Clone, Debug, PartialEq)]
#[command(after_help = "Examples:\n  \
    schuler align --imu car.imu --from 540 --for 120 --out align.toml\n  \
    schuler align align-still --for 300 --runs 200")]
pub struct AlignArgs {
    /// A built-in scene or the path of a TOML file, on whose first samples runs are aligned
    #[arg(conflicts_with = "imu")]
    pub scene: Option<String>,
    /// The stream of a vehicle that stands still: any that replay reads
    #[arg(long, value_name = "FILE")]
    pub imu: Option<PathBuf>,
    /// Of a scene: how many runs, whose errors are compared with their standard deviations and theory
    #[arg(long, value_name = "N", conflicts_with = "imu", allow_negative_numbers = true, value_parser = options::runs)]
    pub runs: Option<u64>,
    /// Of a scene: what is known of the vehicle's motion
    #[arg(long, value_name = "BASE", conflicts_with = "imu", value_parser = options::named(Base::NAMES))]
    pub base: Option<Base>,
    /// Of a scene: begin with a heading that is wrong by so much, of which nothing is known
    #[arg(long, value_name = "DEG", conflicts_with = "imu", allow_negative_numbers = true, value_parser = options::heading_deg)]
    pub off: Option<f64>,
    /// Of a scene: seed of everything random
    #[arg(long, value_name = "N", conflicts_with = "imu", allow_negative_numbers = true, value_parser = options::seed)]
    pub seed: Option<u64>,
    /// What the stream's columns hold: a TOML file, or the name of a known format
    #[arg(long, value_name = "FILE|NAME", conflicts_with = "columns")]
    pub map: Option<String>,
    /// Columns of time, gyros x, y, z and accelerometers x, y, z: names of the header or numbers from 1
    #[arg(long, value_name = "T,X,Y,Z,X,Y,Z", value_parser = Columns::parse)]
    pub columns: Option<Columns>,
    /// Where x, y and z of the unit point, as in forward-left-up
    #[arg(long, value_name = "AXES", value_parser = Mounting::parse)]
    pub axes: Option<Mounting>,
    /// What the stream's numbers are in where that is not m/s², rad/s and s
    #[arg(long, value_name = "WORDS", value_parser = Units::parse)]
    pub units: Option<Units>,
    /// Samples per second, instead of what the time stamps say
    #[arg(long, value_name = "HZ", allow_negative_numbers = true, value_parser = options::rate_hz)]
    pub rate: Option<f64>,
    /// The place: a TOML file with the columns of nav.csv as keys, or a .pos, NMEA, GPX or KML file of positions
    #[arg(long, value_name = "FILE")]
    pub initial: Option<PathBuf>,
    /// Skip to this time of the recording
    #[arg(long, value_name = "S", allow_negative_numbers = true, value_parser = options::time_s)]
    pub from: Option<f64>,
    /// How long to align [default: 120, or as the scene says]
    #[arg(long = "for", value_name = "S", allow_negative_numbers = true, value_parser = options::length_s)]
    pub length: Option<f64>,
    /// How to align
    #[arg(long, value_name = "METHOD", default_value = "auto")]
    pub method: Method,
    /// The standard deviation of the heading that is wanted, degrees: a poorer one is refused
    #[arg(long, value_name = "DEG", allow_negative_numbers = true, value_parser = options::heading_sigma_deg)]
    pub sigma: Option<f64>,
    /// The file to write: an initial.toml for replay, with standard deviations and biases as comments
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
}

impl AlignArgs {
    /// The scene and its alignment, with every option applied.
    pub fn scene(&self, name: &str) -> Result<(Scene, Alignment), InputError> {
        for (there, option) in [
            (self.map.is_some(), "--map"),
            (self.columns.is_some(), "--columns"),
            (self.axes.is_some(), "--axes"),
            (self.units.is_some(), "--units"),
            (self.rate.is_some(), "--rate"),
            (self.initial.is_some(), "--initial"),
            (self.from.is_some(), "--from"),
        ] {
            if there {
                return Err(InputError::option(
                    option,
                    Complaint::new("is of a recording", "--imu FILE"),
                ));
            }
        }
        let mut scene = scene::load(name)?;
        scene.seed = self.seed.unwrap_or(scene.seed);
        let mut alignment = scene.alignment.unwrap_or(Alignment::new(DEFAULT_S));
        alignment.duration_s = self.length.unwrap_or(alignment.duration_s);
        alignment.base = self.base.unwrap_or(alignment.base);
        if self.off.is_some() {
            alignment.heading_sigma_rad = None;
        }
        if let Some(out) = &self.out {
            let read =
                builtin::scene(name).is_none().then(|| ("the scene is read from", Path::new(name)));
            apart::check(&[Written::named("--out", out)], &read.into_iter().collect::<Vec<_>>())?;
        }
        Ok((scene, alignment))
    }

    /// The replay that would begin with this alignment.
    pub fn as_replay(&self, imu: &Path) -> Result<ReplayArgs, InputError> {
        if let Some(out) = &self.out {
            apart::check(&[Written::named("--out", out)], &[("--imu reads", imu)])?;
        }
        Ok(ReplayArgs {
            aiding: AidingOptions::default(),
            imu: imu.to_owned(),
            map: self.map.clone(),
            columns: self.columns.clone(),
            axes: self.axes,
            initial: self.initial.clone(),
            out: self.out.clone().unwrap_or_default(),
            reference: None,
            mcap: None,
            svg: false,
            lag: Lag::Seconds(0.0),
            start: self.from,
            align: Some(self.length.unwrap_or(DEFAULT_S)),
            coarse: self.method == Method::TwoVector,
            heading: None,
            units: self.units,
            until: None,
            rate: self.rate,
            handling: Handling::default(),
            height: None,
            every: None,
            navigator: NavigatorOptions::default(),
        })
    }
}
