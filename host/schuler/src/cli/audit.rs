//! The commands of `schuler audit`.

use super::{FlightOptions, Handling, NavigatorOptions, load, options};
use crate::audit::tolerance::Rule;
use clap::{Args, Subcommand};
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::scene::Scene;
use std::path::PathBuf;

/// What can be audited.
#[derive(Clone, Debug, PartialEq, Subcommand)]
pub enum AuditCommand {
    /// Record scenes into chains: every stage, every kind of navigator
    Record(RecordArgs),
    /// Fly recorded chains again: the same bits?
    Verify(VerifyArgs),
    /// Where do two chains, or folders of them, first part?
    Compare(CompareArgs),
    /// What does one unit in the last place of each input do to the outputs?
    Sensitivity(SensitivityArgs),
}

/// Options of `audit record`.
#[derive(Args, Clone, Debug, PartialEq)]
#[command(
    after_help = "Example:\n  schuler audit record paper hard --duration 60 --out out/chains"
)]
pub struct RecordArgs {
    /// Built-in scenes (`schuler scenes` lists them) or paths of TOML files
    #[arg(required = true, value_parser = options::name())]
    pub scene: Vec<String>,
    /// Folder for the chains: a folder for each scene
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Only these navigators, as their files are named; may be repeated [default: all]
    #[arg(long, value_name = "NAME")]
    pub configuration: Vec<String>,
    /// Samples from checkpoint to checkpoint
    #[arg(long, value_name = "K", default_value = "64", allow_negative_numbers = true, value_parser = checkpoint)]
    pub checkpoint: u64,
    /// Keep every row up to this sample, later only those at checkpoints [default: every row]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = rows)]
    pub rows: Option<u64>,
    /// What replaces the scenes' own values.
    #[command(flatten)]
    pub flight: FlightOptions,
}

/// Options of `audit verify`.
#[derive(Args, Clone, Debug, PartialEq)]
#[command(after_help = "Example:\n  schuler audit verify tests/golden")]
pub struct VerifyArgs {
    /// A folder that `audit record` wrote
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
    /// Folder for audit.json and audit.html
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// Options of `audit compare`.
#[derive(Args, Clone, Debug, PartialEq)]
#[command(after_help = "Examples:\n  \
    schuler audit compare tests/golden/paper mine/paper\n  \
    schuler audit compare golden.chain mine.chain --ulps 4 --within velocity=1e-9")]
pub struct CompareArgs {
    /// A chain, or a folder of chains
    pub a: PathBuf,
    /// Another
    pub b: PathBuf,
    /// Let every field be off by so many units in the last place, or one field; may be repeated
    #[arg(long, value_name = "[FIELD=]N", value_parser = Rule::ulps)]
    pub ulps: Vec<Rule>,
    /// The same in the field's unit; of a field with both limits one is enough
    #[arg(long, value_name = "[FIELD=]M", allow_negative_numbers = true, value_parser = Rule::within)]
    pub within: Vec<Rule>,
    /// Folder for audit.json and audit.html
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// Options of `audit sensitivity`.
#[derive(Args, Clone, Debug, PartialEq)]
#[command(after_help = "Example:\n  schuler audit sensitivity hard --precision f32 --after 60")]
pub struct SensitivityArgs {
    /// A built-in scene or the path of a TOML file, flown with perfect sensors [default: paper]
    #[arg(value_parser = options::name())]
    pub scene: Option<String>,
    /// Seconds of flight, to the nearest sample, after which to look; may be repeated [default: 1, 10, 100,
    /// 1000 and the end]
    #[arg(long, value_name = "S", allow_negative_numbers = true, value_parser = options::time_s)]
    pub after: Vec<f64>,
    /// Folder for audit.json and audit.html
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// What replaces the scene's own values.
    #[command(flatten)]
    pub flight: FlightOptions,
    /// How to navigate.
    #[command(flatten)]
    pub navigator: NavigatorOptions,
}

impl SensitivityArgs {
    /// The scene, with every option applied.
    pub fn scene(&self) -> Result<Scene, InputError> {
        load(self.scene.as_deref(), &self.flight, &self.navigator, &Handling::default())
            .and_then(schuler_simulator::scene::unaided)
    }
}

fn checkpoint(text: &str) -> Result<u64, Complaint> {
    options::whole(text, 1..=u64::MAX)
}

fn rows(text: &str) -> Result<u64, Complaint> {
    options::whole(text, 0..=u64::MAX)
}
