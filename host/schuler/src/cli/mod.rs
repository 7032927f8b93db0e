//! The command line: commands, their options, and what they do to a scene.

mod aiding;
mod align;
mod allan;
mod apart;
mod audit;
mod emulate;
mod ensemble;
mod hil;
mod options;
mod replay;
mod scenes;
mod start;

pub use crate::report::every::Every;
pub use aiding::{AidingOptions, GNSS_LAG_S, LeverArm, Sigmas, VelocityLag};
pub use align::{AlignArgs, Method};
pub use allan::{AllanArgs, DatasheetArgs, Span};
pub use audit::{AuditCommand, CompareArgs, RecordArgs, SensitivityArgs, VerifyArgs};
pub use emulate::EmulateArgs;
pub use ensemble::{EnsembleArgs, EnsembleCommand, MergeArgs, Shard, Times, threads};
pub use hil::HilArgs;
pub use options::{FlightOptions, Handling, NavigatorOptions, Window, runs};
pub use replay::{Height, Lag, ReplayArgs};
pub use scenes::{ScenesArgs, TrajectoryArgs};

use crate::report::Wanted;
use crate::report::files::NAMES as FLIGHT_FILES;
use apart::Written;
use clap::{Args, CommandFactory, Parser, Subcommand};
use schuler_simulator::input::InputError;
use schuler_simulator::input::name::path_of;
use schuler_simulator::scene::{self, Scene, builtin, limits};
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
    Replay(Box<ReplayArgs>),
    /// Find level, north and biases of a vehicle that stands still
    Align(Box<AlignArgs>),
    /// Describe a scene's flight, and write its path for other tools
    Trajectory(TrajectoryArgs),
    /// Measure run time against error
    Frontier(FrontierArgs),
    /// Run the table of numerical stability, each row against its bound
    Stress(StressArgs),
    /// Fly many runs of a scene: does their drift scatter as theory says?
    Ensemble(Box<EnsembleArgs>),
    /// Identify a sensor at rest by its Allan deviation, or check a scene's terms against it
    Allan(AllanArgs),
    /// Turn the numbers of a data sheet into a scene's sensor sections
    Datasheet(DatasheetArgs),
    /// Digests of flights, and where two of them first part
    #[command(subcommand)]
    Audit(AuditCommand),
    /// Fly a scene with a target and its twin in step, every bit compared
    Hil(HilArgs),
    /// Serve as the target of `hil --device twin`
    #[command(hide = true, after_help = "Example:\n  schuler twin")]
    Twin,
    /// List the built-in scenes, print one, or every key of a scene
    Scenes(ScenesArgs),
}

/// Options of `run`.
#[derive(Args, Clone, Debug, Default, PartialEq)]
#[command(
    after_help = "Example:\n  schuler run manoeuvre --duration 20 --window 2,4,2 --out out/turns"
)]
pub struct RunArgs {
    /// A built-in scene (`schuler scenes` lists them) or the path of a TOML file [default: paper]
    #[arg(value_parser = options::name())]
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
    /// The vertical channel and missing samples.
    #[command(flatten)]
    pub handling: Handling,
    /// Fly the run of this number, as an ensemble has it
    #[arg(long = "run", value_name = "N", default_value = "0", allow_negative_numbers = true, value_parser = options::run)]
    pub number: u64,
    /// Skip nothing, even what the scene does not need
    #[arg(long)]
    pub force_all: bool,
    /// Write no report.html and no drift.png
    #[arg(long)]
    pub no_report: bool,
    /// Write drift.svg, too: the charts of drift.png for documents
    #[arg(long)]
    pub svg: bool,
    /// Write nav.csv and truth.csv, too: the computed and the true motion, row by row
    #[arg(long)]
    pub rows: bool,
    /// Write ROS 2 messages, too: /imu, /truth and /computed (Imu, NavSatFix, PoseStamped)
    #[arg(long, value_name = "FILE")]
    pub mcap: Option<PathBuf>,
    /// Rows of drift.csv (and of --rows) to write: every N-th sample, or one each S seconds, as in 10s [default: all]
    #[arg(long, value_name = "N|S", allow_negative_numbers = true, value_parser = Every::parse)]
    pub every: Option<Every>,
}

impl RunArgs {
    /// What is written of a flight of the scene.
    pub fn wanted(&self, scene: &Scene) -> Wanted {
        Wanted {
            every: self.every,
            report: !self.no_report,
            rows: self.rows,
            svg: self.svg,
            smoothed: scene.aiding.filter.smoother,
            run: self.number,
        }
    }

    /// The scene, with every option applied.
    pub fn scene(&self) -> Result<Scene, InputError> {
        // A command with a slip of the pen is taken for a scene.
        let program = <Cli as CommandFactory>::command();
        let commands: Vec<_> = program.get_subcommands().map(clap::Command::get_name).collect();
        let name = self.scene.as_deref();
        let scene = load_beside(name, &commands, &self.flight, &self.navigator, &self.handling)?;
        self.check(&scene)?;
        Ok(scene)
    }

    /// The folder of the files.
    pub fn folder(&self, scene: &Scene) -> PathBuf {
        self.out.clone().unwrap_or_else(|| PathBuf::from("out").join(path_of(&scene.name)))
    }

    /// No messages are written over the scene, nor over another file of the run.
    fn check(&self, scene: &Scene) -> Result<(), InputError> {
        let Some(mcap) = &self.mcap else { return Ok(()) };
        let folder = self.folder(scene);
        let names = FLIGHT_FILES.map(|name| Written {
            option: "--out",
            what: name,
            path: folder.join(name),
        });
        let written: Vec<_> = names.into_iter().chain([Written::named("--mcap", mcap)]).collect();
        let name = self.scene.as_deref().unwrap_or(builtin::DEFAULT);
        let is_file = builtin::scene(name).is_none();
        let read = is_file.then_some(("the scene is read from", Path::new(name)));
        apart::check(&written, read.as_slice())
    }
}

/// Options of `frontier`.
#[derive(Args, Clone, Debug, Default, PartialEq)]
#[command(after_help = "Example:\n  schuler frontier --quick --scene paper-perfect --rate 20")]
pub struct FrontierArgs {
    /// A built-in scene or the path of a TOML file, whose motion is flown with perfect sensors; may be repeated
    /// [default: paper-perfect, hard, manoeuvre, vibration, coning, stationary]
    #[arg(long, value_name = "SCENE", value_parser = options::name())]
    pub scene: Vec<String>,
    /// Samples per second; may be repeated [default: of 5 to 1000, those that suit the scene]
    #[arg(long, value_name = "HZ", allow_negative_numbers = true, value_parser = options::rate_hz)]
    pub rate: Vec<f64>,
    /// Fly shorter scenes and repeat less
    #[arg(long)]
    pub quick: bool,
    /// Folder for frontier.csv, frontier.png and frontier.html [default: out/frontier]
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
    /// Folder for stress.csv and stress.html
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// A scene that is to be flown, with options applied.
fn load(
    name: Option<&str>,
    flight: &FlightOptions,
    navigator: &NavigatorOptions,
    handling: &Handling,
) -> Result<Scene, InputError> {
    load_beside(name, &[], flight, navigator, handling)
}

/// The same where a command of these names may have been meant.
fn load_beside(
    name: Option<&str>,
    commands: &[&str],
    flight: &FlightOptions,
    navigator: &NavigatorOptions,
    handling: &Handling,
) -> Result<Scene, InputError> {
    let name = name.unwrap_or(builtin::DEFAULT);
    let mut scene = scene::load_beside(name, commands)?;
    flight.apply(&mut scene)?;
    navigator.apply(&mut scene.navigator)?;
    handling.apply(&mut scene.navigator);
    start::check(&scene, name, navigator.frame)?;
    // Options may have brought what does not go with aiding.
    limits::aiding(&scene).map_err(|(key, complaint)| match key {
        "navigator.vertical" if handling.vertical.is_some() => {
            InputError::option("--vertical", complaint)
        }
        key => InputError::option(key, complaint),
    })?;
    Ok(scene)
}
