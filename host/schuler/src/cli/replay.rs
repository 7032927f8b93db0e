//! Options of `replay`.

use super::apart::{self, Written};
use super::{AidingOptions, Every, Handling, NavigatorOptions, options};
use crate::replay::places::Places;
use clap::Args;
use schuler_simulator::input::{Complaint, InputError, Range};
use schuler_simulator::recording::foreign::{Columns, Given};
use schuler_simulator::recording::mounting::Mounting;
use schuler_simulator::recording::navigation::RANGES;
use schuler_simulator::rest::units::Units;
use schuler_simulator::scene::{Vertical, builtin};
use std::path::{Path, PathBuf};

/// Options of `replay`.
#[derive(Args, Clone, Debug, PartialEq)]
#[command(after_help = "Examples:\n  \
    schuler replay --imu imu.csv --initial initial.toml --out nav.csv\n  \
    schuler replay --imu imu.csv --initial initial.toml --reference truth.csv --out out/again/\n  \
    schuler replay --imu car.imu --start 540 --align 120 --until 960 --out nav.csv\n  \
    schuler replay --imu phone.csv --units g,deg/s --initial here.toml --align 20 --heading 40 --out nav.csv\n  \
    schuler replay --imu log.csv --map map.toml --initial rtk.pos --align 20 --heading 40 --out nav.csv\n  \
    schuler replay --imu log.csv --columns 7,4,5,6,1,2,3 --units g,deg/s,ms --axes forward-left-up \
    --initial rtk.pos --align 20 --heading 40 --out nav.csv\n  \
    schuler replay --imu imu.csv --gnss gnss.csv --sensors aided-drive --initial initial.toml --out nav.csv")]
pub struct ReplayArgs {
    /// The stream: an imu.csv, a PSINS .imu, a log of another known format, or any other by --map or --columns
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
    /// The state to start from: a TOML file with the columns of nav.csv as keys, or with --align a .pos, NMEA, GPX
    /// or KML file of positions; a PSINS .imu brings its own
    #[arg(long, value_name = "FILE")]
    pub initial: Option<PathBuf>,
    /// The file to write, or a folder for nav.csv: one that is there, or a name that ends with a slash
    #[arg(long, value_name = "FILE|DIR")]
    pub out: PathBuf,
    /// What the motion really was: a CSV file with the columns of nav.csv, or its time and position alone; or an
    /// RTKLIB .pos, NMEA, GPX or KML file with times and heights.
    /// The drift from it is printed; summary.json, drift.csv, drift.png and report.html go to the folder of
    /// --out, or to NAME-report beside the file NAME.csv
    #[arg(long, value_name = "FILE")]
    pub reference: Option<PathBuf>,
    /// Write drift.svg to the report's folder, too: the picture of the drift for documents
    #[arg(long, requires = "reference")]
    pub svg: bool,
    /// Write ROS 2 messages, too: the rows of nav.csv as /computed (NavSatFix, PoseStamped)
    #[arg(long, value_name = "FILE")]
    pub mcap: Option<PathBuf>,
    /// How late the reference's stamps are, seconds, or auto: the lag that fits best. That is printed in any case
    #[arg(long, value_name = "S", requires = "reference", default_value = "0", allow_negative_numbers = true, value_parser = Lag::parse)]
    pub lag: Lag,
    /// Skip to this time of the recording
    #[arg(long, value_name = "S", allow_negative_numbers = true, value_parser = options::time_s)]
    pub start: Option<f64>,
    /// First stand still this long to find level and north
    #[arg(long, value_name = "S", allow_negative_numbers = true, value_parser = options::length_s)]
    pub align: Option<f64>,
    /// Align by the means alone (two vectors), without the filter that finds biases, too
    #[arg(long, requires = "align")]
    pub coarse: bool,
    /// The heading to start from with --align, degrees from north to the east: gyros then need not find it
    #[arg(long, value_name = "DEG", requires = "align", allow_negative_numbers = true, value_parser = options::heading_deg)]
    pub heading: Option<f64>,
    /// What the stream's numbers are in where that is not m/s², rad/s and s (increments: m/s and rad): words
    /// with commas between, as in g,deg/s,ms; `increments` or `rates` overrules the header
    #[arg(long, value_name = "WORDS", value_parser = Units::parse)]
    pub units: Option<Units>,
    /// End at this time of the recording
    #[arg(long, value_name = "S", allow_negative_numbers = true, value_parser = options::time_s)]
    pub until: Option<f64>,
    /// Samples per second, instead of what the time stamps say
    #[arg(long, value_name = "HZ", allow_negative_numbers = true, value_parser = options::rate_hz)]
    pub rate: Option<f64>,
    /// The vertical channel and missing samples.
    #[command(flatten)]
    pub handling: Handling,
    /// The altitude that the vertical is held to: metres, or a CSV file with the columns time_s and altitude_m,
    /// as nav.csv and truth.csv have them; holds it [with --vertical held alone: that of the start]
    #[arg(long, value_name = "M|FILE", allow_negative_numbers = true, value_parser = Height::parse)]
    pub height: Option<Height>,
    /// Write every N-th row, or a row each S seconds (10s, 0.5s), and the last [default: every row]
    #[arg(long, value_name = "N|S", value_parser = Every::parse)]
    pub every: Option<Every>,
    /// What aids it.
    #[command(flatten)]
    pub aiding: AidingOptions,
    /// How to navigate.
    #[command(flatten)]
    pub navigator: NavigatorOptions,
}

impl ReplayArgs {
    /// What is said of the stream.
    pub fn given(&self) -> Given {
        Given {
            map: self.map.clone(),
            columns: self.columns.clone(),
            units: self.units.unwrap_or_default(),
            axes: self.axes,
            rate_hz: self.rate,
        }
    }

    /// What no option alone can get wrong: nothing is written over a file that is read, and no vertical is
    /// both free and held.
    pub fn check(&self) -> Result<(), InputError> {
        if self.height.is_some() && self.handling.vertical == Some(Vertical::Free) {
            let complaint =
                Complaint::new("holds the vertical, which is to be free", "--vertical held");
            return Err(InputError::option("--height", complaint));
        }
        if self.aiding.gnss.is_some() && self.vertical() == Vertical::Held {
            let option = if self.height.is_some() { "--height" } else { "--vertical" };
            let complaint =
                Complaint::new("holds the vertical, which --gnss aids", "--vertical free");
            return Err(InputError::option(option, complaint));
        }
        let mut read = vec![("--imu reads", self.imu.as_path())];
        read.extend(self.aiding.gnss.as_deref().map(|gnss| ("--gnss reads", gnss)));
        read.extend(self.aiding.time_tag.as_deref().map(|tag| ("--time-tag reads", tag)));
        let sensors = self.aiding.sensors.as_deref();
        let sensors = sensors.filter(|name| builtin::scene(name).is_none()).map(Path::new);
        read.extend(sensors.map(|sensors| ("--sensors reads", sensors)));
        let map = self.map.as_deref().map(Path::new);
        read.extend(map.map(|map| ("--map reads", map)));
        read.extend(self.initial.as_deref().map(|initial| ("--initial reads", initial)));
        read.extend(self.reference.as_deref().map(|reference| ("--reference reads", reference)));
        if let Some(Height::File(file)) = &self.height {
            read.push(("--height reads", file));
        }
        let places = Places::new(&self.out, self.reference.is_some(), self.svg);
        let mut written = vec![Written::named("--out", &places.nav)];
        written.extend(self.mcap.as_deref().map(|mcap| Written::named("--mcap", mcap)));
        let smooth = self.aiding.smooth.as_deref();
        written.extend(smooth.map(|smooth| Written::named("--smooth", smooth)));
        for (what, path) in places.report_files() {
            written.push(Written { option: "--out", what, path });
        }
        apart::check(&written, &read)
    }

    /// The vertical channel: whoever gives a height holds it.
    pub fn vertical(&self) -> Vertical {
        let free = self.handling.vertical.unwrap_or(Vertical::Free);
        if self.height.is_some() { Vertical::Held } else { free }
    }
}

/// The value of `--height`.
#[derive(Clone, Debug, PartialEq)]
pub enum Height {
    /// The same at all times, m.
    Metres(f64),
    /// A column of a file.
    File(PathBuf),
}

impl Height {
    /// A number is metres, all else a file.
    pub fn parse(text: &str) -> Result<Self, Complaint> {
        let [_, _, _, altitude, ..] = RANGES;
        match text.parse() {
            Ok(metres) => altitude.check(metres).map(Self::Metres),
            Err(_) => Ok(Self::File(text.into())),
        }
    }
}

/// The value of `--lag`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Lag {
    /// The one that fits best.
    Auto,
    /// Seconds.
    Seconds(f64),
}

impl Lag {
    /// From `auto` or seconds.
    pub fn parse(text: &str) -> Result<Self, Complaint> {
        let range = Range::from_to(-1e6, 1e6, "seconds, or auto");
        match text {
            "auto" => Ok(Self::Auto),
            _ => options::number(text, &range).map(Self::Seconds),
        }
    }
}
