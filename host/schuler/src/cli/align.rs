//! Options of `align`.

use super::apart::{self, Written};
use super::{Handling, Lag, NavigatorOptions, ReplayArgs, options};
use clap::{Args, ValueEnum};
use schuler_simulator::input::InputError;
use schuler_simulator::recording::foreign::Columns;
use schuler_simulator::recording::mounting::Mounting;
use schuler_simulator::rest::units::Units;
use std::path::PathBuf;

/// How to align.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Method {
    /// By a filter that finds biases, too
    #[default]
    Fine,
    /// By the means of gyros and accelerometers alone
    TwoVector,
}

/// Options of `align`.
#[derive(Args, Clone, Debug, PartialEq)]
#[command(after_help = "Example:\n  \
    schuler align --imu car.imu --from 540 --for 120 --out align.toml")]
pub struct AlignArgs {
    /// The stream of a vehicle that stands still: any that replay reads
    #[arg(long, value_name = "FILE")]
    pub imu: PathBuf,
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
    /// How long to stand still
    #[arg(long = "for", value_name = "S", default_value = "120", allow_negative_numbers = true, value_parser = options::length_s)]
    pub length: f64,
    /// How to align
    #[arg(long, value_name = "METHOD", default_value = "fine")]
    pub method: Method,
    /// The standard deviation of the heading that is wanted, degrees: a poorer one is refused
    #[arg(long, value_name = "DEG", allow_negative_numbers = true, value_parser = options::length_s)]
    pub sigma: Option<f64>,
    /// The file to write: an initial.toml for replay, with standard deviations and biases as comments
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
}

impl AlignArgs {
    /// The replay that would begin with this alignment.
    pub fn as_replay(&self) -> Result<ReplayArgs, InputError> {
        if let Some(out) = &self.out {
            apart::check(&[Written::named("--out", out)], &[("--imu reads", self.imu.as_path())])?;
        }
        Ok(ReplayArgs {
            imu: self.imu.clone(),
            map: self.map.clone(),
            columns: self.columns.clone(),
            axes: self.axes,
            initial: self.initial.clone(),
            out: self.out.clone().unwrap_or_default(),
            reference: None,
            mcap: None,
            lag: Lag::Seconds(0.0),
            start: self.from,
            align: Some(self.length),
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
