//! The command line: commands, their options, and what they do to a scene.

mod audit;
mod every;
mod hil;
mod options;
mod start;

pub use audit::{AuditCommand, CompareArgs, RecordArgs, SensitivityArgs, VerifyArgs};
pub use every::{Every, Sieve};
pub use hil::HilArgs;
pub use options::{FlightOptions, NavigatorOptions, Window};

use clap::{Args, CommandFactory, Parser, Subcommand};
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::recording::foreign::{Columns, Given};
use schuler_simulator::recording::mounting::Mounting;
use schuler_simulator::rest::units::Units;
use schuler_simulator::scene::{self, Gap, Scene, builtin};
use std::path::{Path, PathBuf};

const ABOUT: &str = "Flies a strapdown inertial navigation system through a scene: \
    true motion, sensors with errors, navigation, and its drift beside theory";

/// The `schuler` program. Without a command it runs a scene.
#[derive(Clone, Debug, Parser)]
#[command(name = "schuler", version, about = ABOUT, args_conflicts_with_subcommands = true)]
#[command(after_help = "Examples:\n  schuler                     the paper's flight\n  \
    schuler scenes              what else there is to fly\n  schuler run hard --seed 7")]
pub struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
    #[command(flatten)]
    run: RunArgs,
}

impl Cli {
    /// The command that was given, or the one that none stands for.
    pub fn command(self) -> Command {
        self.command.unwrap_or(Command::Run(self.run))
    }
}

/// What the program can do.
#[derive(Clone, Debug, PartialEq, Subcommand)]
pub enum Command {
    /// Fly a scene: emulate the sensors, navigate, compare (the default command)
    Run(RunArgs),
    /// Write the sensors' stream of a scene
    Emulate(EmulateArgs),
    /// Navigate a recorded stream
    Replay(ReplayArgs),
    /// Measure run time against error
    Frontier(FrontierArgs),
    /// Run the table of numerical stability, each row against its bound
    Stress(StressArgs),
    /// Fly many runs of a scene: does their drift scatter as theory says?
    Ensemble(EnsembleArgs),
    /// Digests of flights, and where two of them first part
    #[command(subcommand)]
    Audit(AuditCommand),
    /// Fly a scene with a target and its twin in step, every bit compared
    Hil(HilArgs),
    /// Serve as the target of `hil --device twin`
    #[command(hide = true, after_help = "Example:\n  schuler twin")]
    Twin,
    /// List the built-in scenes
    #[command(after_help = "Example:\n  schuler scenes")]
    Scenes,
}

/// Options of `run`.
#[derive(Args, Clone, Debug, Default, PartialEq)]
#[command(
    after_help = "Example:\n  schuler run manoeuvre --duration 20 --window 2,4,2 --out out/turns"
)]
pub struct RunArgs {
    /// A built-in scene (`schuler scenes` lists them) or the path of a TOML file [default: paper]
    pub scene: Option<String>,
    /// Folder for summary.json, drift.csv, drift.png and report.html [default: out/ and the name of the scene]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// What replaces the scene's own values.
    #[command(flatten)]
    pub flight: FlightOptions,
    /// How to navigate.
    #[command(flatten)]
    pub navigator: NavigatorOptions,
    /// Skip nothing, even what the scene does not need
    #[arg(long)]
    pub force_all: bool,
    /// Write no report.html and no drift.png
    #[arg(long)]
    pub no_report: bool,
    /// Rows of drift.csv to write: every N-th sample, or one each S seconds, as in 10s [default: all]
    #[arg(long, value_name = "N|S", allow_negative_numbers = true, value_parser = Every::parse)]
    pub every: Option<Every>,
}

impl RunArgs {
    /// The scene, with every option applied.
    pub fn scene(&self) -> Result<Scene, InputError> {
        // A command with a slip of the pen is taken for a scene.
        let program = <Cli as CommandFactory>::command();
        let commands: Vec<_> = program.get_subcommands().map(clap::Command::get_name).collect();
        load_beside(self.scene.as_deref(), &commands, &self.flight, &self.navigator)
    }
}

/// Options of `emulate`.
#[derive(Args, Clone, Debug, PartialEq)]
#[command(after_help = "Example:\n  schuler emulate hard --out imu.csv --perfect")]
pub struct EmulateArgs {
    /// A built-in scene (`schuler scenes` lists them) or the path of a TOML file [default: paper]
    pub scene: Option<String>,
    /// The file to write
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
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
        if builtin::scene(name).is_none() {
            spare(&self.out, "the scene is read from", Path::new(name))?;
        }
        if self.perfect {
            scene.gyro = Default::default();
            scene.accelerometer = Default::default();
        }
        Ok(scene)
    }
}

/// Options of `replay`.
#[derive(Args, Clone, Debug, PartialEq)]
#[command(after_help = "Examples:\n  \
    schuler replay --imu imu.csv --initial initial.toml --out nav.csv\n  \
    schuler replay --imu car.imu --start 540 --align 120 --until 960 --out nav.csv\n  \
    schuler replay --imu phone.csv --units g,deg/s --initial here.toml --align 20 --heading 40 --out nav.csv\n  \
    schuler replay --imu log.csv --map map.toml --initial rtk.pos --align 20 --heading 40 --out nav.csv\n  \
    schuler replay --imu log.csv --columns 7,4,5,6,1,2,3 --units g,deg/s,ms --axes forward-left-up \
    --initial rtk.pos --align 20 --heading 40 --out nav.csv")]
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
    /// The file to write
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
    /// Skip to this time of the recording
    #[arg(long, value_name = "S", allow_negative_numbers = true, value_parser = options::time_s)]
    pub start: Option<f64>,
    /// First stand still this long to find level and north
    #[arg(long, value_name = "S", allow_negative_numbers = true, value_parser = options::length_s)]
    pub align: Option<f64>,
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
    /// What missing samples do
    #[arg(long, value_name = "G", value_parser = options::named(Gap::NAMES))]
    pub gap: Option<Gap>,
    /// Write every N-th row, or a row each S seconds (10s, 0.5s), and the last [default: every row]
    #[arg(long, value_name = "N|S", value_parser = Every::parse)]
    pub every: Option<Every>,
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

    /// What no option alone can get wrong: `--out` is none of the files that are read.
    pub fn check(&self) -> Result<(), InputError> {
        spare(&self.out, "--imu reads", &self.imu)?;
        let map = self.map.as_ref().map(Path::new);
        map.map_or(Ok(()), |map| spare(&self.out, "--map reads", map))?;
        self.initial.as_ref().map_or(Ok(()), |initial| spare(&self.out, "--initial reads", initial))
    }
}

/// Refuses to write over a file that is read.
fn spare(out: &Path, reads: &str, file: &Path) -> Result<(), InputError> {
    match (out.canonicalize(), file.canonicalize()) {
        (Ok(out), Ok(file)) if out == file => {
            let what = format!("is the file that {reads}");
            Err(InputError::option("--out", Complaint::new(what, "another file")))
        }
        _ => Ok(()),
    }
}

/// Options of `frontier`.
#[derive(Args, Clone, Debug, Default, PartialEq)]
#[command(after_help = "Example:\n  schuler frontier --quick --scene paper-perfect --rate 20")]
pub struct FrontierArgs {
    /// A built-in scene or the path of a TOML file, whose motion is flown with perfect sensors; may be repeated
    /// [default: paper-perfect, hard, manoeuvre, vibration, coning, stationary]
    #[arg(long, value_name = "SCENE")]
    pub scene: Vec<String>,
    /// Samples per second; may be repeated [default: of 5 to 1000, those that suit the scene]
    #[arg(long, value_name = "HZ", allow_negative_numbers = true, value_parser = options::rate_hz)]
    pub rate: Vec<f64>,
    /// Fly shorter scenes and repeat less
    #[arg(long)]
    pub quick: bool,
    /// Folder for frontier.csv and frontier.png [default: out/frontier]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// Options of `stress`.
#[derive(Args, Clone, Debug, Default, PartialEq)]
#[command(
    after_help = "Examples:\n  schuler stress\n  schuler stress --full --case coning --out out/stress"
)]
pub struct StressArgs {
    /// The long cases, too: some six minutes
    #[arg(long)]
    pub full: bool,
    /// Only the cases with this in their name
    #[arg(long, value_name = "NAME")]
    pub case: Option<String>,
    /// Folder for stress.csv
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// Options of `ensemble`.
#[derive(Args, Clone, Debug, PartialEq)]
#[command(after_help = "Example:\n  schuler ensemble paper --runs 1000")]
pub struct EnsembleArgs {
    /// A built-in scene with random errors, or the path of a TOML file [default: paper]
    pub scene: Option<String>,
    /// How many runs to fly, numbered from 0: what `run` flies is the first
    #[arg(long, value_name = "N", default_value = "64", allow_negative_numbers = true, value_parser = options::runs)]
    pub runs: u64,
    /// Folder for ensemble.csv [default: out/ and the name of the scene]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// What replaces the scene's own values.
    #[command(flatten)]
    pub flight: FlightOptions,
    /// How to navigate.
    #[command(flatten)]
    pub navigator: NavigatorOptions,
}

impl EnsembleArgs {
    /// The scene, with every option applied.
    pub fn scene(&self) -> Result<Scene, InputError> {
        load(self.scene.as_deref(), &self.flight, &self.navigator)
    }
}

/// A scene that is to be flown, with options applied.
fn load(
    name: Option<&str>,
    flight: &FlightOptions,
    navigator: &NavigatorOptions,
) -> Result<Scene, InputError> {
    load_beside(name, &[], flight, navigator)
}

/// The same where a command of these names may have been meant.
fn load_beside(
    name: Option<&str>,
    commands: &[&str],
    flight: &FlightOptions,
    navigator: &NavigatorOptions,
) -> Result<Scene, InputError> {
    let name = name.unwrap_or(builtin::DEFAULT);
    let mut scene = scene::load_beside(name, commands)?;
    flight.apply(&mut scene)?;
    navigator.apply(&mut scene.navigator)?;
    start::check(&scene, name, navigator.frame)?;
    Ok(scene)
}
