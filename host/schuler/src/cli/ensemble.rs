//! Options of `ensemble` and of `ensemble merge`.

use super::options::{self, FlightOptions, Handling, NavigatorOptions};
use super::{Cli, Command};
use clap::{Args, Parser as _, Subcommand};
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::number::exact;
use schuler_simulator::scene::{Scene, Vertical, WindowShape, builtin};
use std::path::PathBuf;

/// Runs that are flown with each error term switched off, unless told.
const BUDGET: &str = "256";

/// Options of `ensemble`.
#[derive(Args, Clone, Debug, PartialEq)]
#[command(
    args_conflicts_with_subcommands = true,
    after_help = "Examples:\n  schuler ensemble paper --runs 1000 --budget\n  \
        schuler ensemble paper --runs 100000 --shard 3/8 --resume --out shards\n  \
        schuler ensemble merge shards/*.part --out out/paper"
)]
pub struct EnsembleArgs {
    /// What else there is to do
    #[command(subcommand)]
    pub command: Option<EnsembleCommand>,
    /// A built-in scene with random errors, or the path of a TOML file [default: paper]
    #[arg(value_parser = options::name())]
    pub scene: Option<String>,
    /// How many runs to fly, numbered from 0: what `run` flies is the first
    #[arg(long, value_name = "N", default_value = "64", allow_negative_numbers = true, value_parser = options::runs)]
    pub runs: u64,
    /// When to read them: so many equally spaced times, or times in seconds, as in 60s,600s; the end is always read
    #[arg(long, value_name = "N|S,…", default_value = "8", allow_negative_numbers = true, value_parser = Times::parse)]
    pub at: Times,
    /// Folder for the tables, ensemble.json and ensemble.html, and for the part of a shard [default: out/ and the name of the scene]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Write runs.csv, too: the drift of every run at the times that are read (of shards, `merge` does)
    #[arg(long, conflicts_with = "shard")]
    pub keep: bool,
    /// Fly this many runs with each error term switched off, too: what it contributes [default with the option: 256]
    #[arg(long, value_name = "N", num_args = 0..=1, default_missing_value = BUDGET, conflicts_with = "shard", allow_negative_numbers = true, value_parser = options::runs)]
    pub budget: Option<u64>,
    /// Fly the K-th of N parts only, for `ensemble merge`
    #[arg(long, value_name = "K/N", allow_negative_numbers = true, value_parser = shard)]
    pub shard: Option<Shard>,
    /// Go on with what was flown before it was stopped
    #[arg(long)]
    pub resume: bool,
    /// Runs to fly between two savings of what was flown [default: as many as take some seconds]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = batch)]
    pub batch: Option<u64>,
    /// Threads to fly on [default: as many as there are processors]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = threads)]
    pub threads: Option<usize>,
    /// What replaces the scene's own values.
    #[command(flatten)]
    pub flight: FlightOptions,
    /// How to navigate.
    #[command(flatten)]
    pub navigator: NavigatorOptions,
    /// The vertical channel: free, or held to the truth's height
    #[arg(long, value_name = "V", value_parser = options::named(Vertical::NAMES))]
    pub vertical: Option<Vertical>,
}

/// What else there is to do with an ensemble.
#[derive(Clone, Debug, PartialEq, Subcommand)]
pub enum EnsembleCommand {
    /// Make the whole of an ensemble's parts: the same files, byte for byte, as if it had been flown at once
    Merge(MergeArgs),
}

/// Options of `ensemble merge`.
#[derive(Args, Clone, Debug, PartialEq)]
#[command(after_help = "Example:\n  schuler ensemble merge shards/*.part --out out/paper")]
pub struct MergeArgs {
    /// The parts, in any order: files that `ensemble --shard` wrote
    #[arg(required = true, value_name = "PART")]
    pub parts: Vec<PathBuf>,
    /// The scene that they were flown with, where its file is elsewhere now
    #[arg(long, value_name = "SCENE", value_parser = options::name())]
    pub scene: Option<String>,
    /// Folder for the tables, ensemble.json and ensemble.html [default: out/ and the name of the scene]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Write runs.csv, too: the drift of every run at the times that are read
    #[arg(long)]
    pub keep: bool,
    /// Fly this many runs with each error term switched off: what it contributes [default with the option: 256]
    #[arg(long, value_name = "N", num_args = 0..=1, default_missing_value = BUDGET, allow_negative_numbers = true, value_parser = options::runs)]
    pub budget: Option<u64>,
    /// Threads to fly on [default: as many as there are processors]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = threads)]
    pub threads: Option<usize>,
}

/// K of N.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard(pub [u64; 2]);

/// When runs are read.
#[derive(Clone, Debug, PartialEq)]
pub enum Times {
    /// At so many equally spaced times.
    Equal(u64),
    /// At these, s, and at the end.
    Seconds(Vec<f64>),
}

/// Times at which runs are read, at most.
const MOST_TIMES: u64 = 1000;

impl Times {
    /// From its text.
    pub fn parse(text: &str) -> Result<Self, Complaint> {
        const ACCEPTED: &str =
            "a number of times from 1 to 1000, such as 16, or times in seconds, such as 60s,600s";
        let times = match text.parse() {
            Ok(count) if (1..=MOST_TIMES).contains(&count) => Some(Self::Equal(count)),
            Ok(_) => None,
            Err(_) => {
                let seconds = |time: &str| -> Option<f64> {
                    let time_s: f64 = time.trim().strip_suffix('s')?.parse().ok()?;
                    (time_s.is_finite() && time_s > 0.0).then_some(time_s)
                };
                let times: Option<Vec<f64>> = text.split(',').map(seconds).collect();
                times.filter(|times| times.len() as u64 <= MOST_TIMES).map(Self::Seconds)
            }
        };
        times.ok_or_else(|| Complaint::new("is neither a number of times nor times", ACCEPTED))
    }

    fn text(&self) -> String {
        match self {
            Self::Equal(count) => count.to_string(),
            Self::Seconds(times) => {
                times.iter().map(|time_s| format!("{time_s}s")).collect::<Vec<_>>().join(",")
            }
        }
    }
}

impl EnsembleArgs {
    /// The scene, with every option applied.
    pub fn scene(&self) -> Result<Scene, InputError> {
        let handling = Handling { vertical: self.vertical, gap: None };
        let scene = super::load(self.scene.as_deref(), &self.flight, &self.navigator, &handling)?;
        self.check(&scene)?;
        Ok(scene)
    }

    /// Whether shards and times fit the scene.
    pub fn check(&self, scene: &Scene) -> Result<(), InputError> {
        if let Some(Shard([_, shards])) = self.shard.filter(|Shard([_, n])| *n > self.runs) {
            let what = format!("of {} runs there are no {shards} shards", self.runs);
            let accepted = format!("K/N with N up to {}", self.runs);
            return Err(InputError::option("--shard", Complaint::new(what, accepted)));
        }
        if let Times::Seconds(times) = &self.at
            && let Some(late) = times.iter().find(|&&time_s| time_s > scene.duration_s)
        {
            let what = format!("{late} s is after the end");
            let accepted = format!("times up to {} s", scene.duration_s);
            return Err(InputError::option("--at", Complaint::new(what, accepted)));
        }
        Ok(())
    }

    /// The command that flies the whole, an argument each: all that decides on the runs, and nothing else.
    pub fn whole(&self) -> Vec<String> {
        let scene = self.scene.clone().unwrap_or_else(|| builtin::DEFAULT.to_owned());
        let mut command = vec!["ensemble".to_owned(), scene];
        let mut add = |option: &str, value: Option<String>| {
            command.extend(value.into_iter().flat_map(|value| [option.to_owned(), value]));
        };
        add("--runs", Some(self.runs.to_string()));
        add("--at", Some(self.at.text()));
        let FlightOptions { seed, duration, rate } = self.flight;
        add("--seed", seed.map(|seed| seed.to_string()));
        add("--duration", duration.map(exact));
        add("--rate", rate.map(exact));
        let NavigatorOptions { frame, precision, algorithm, window } = self.navigator;
        add("--frame", frame.map(|frame| frame.name().to_owned()));
        add("--precision", precision.map(|precision| precision.name().to_owned()));
        add("--algorithm", algorithm.map(|algorithm| algorithm.name().to_owned()));
        let shape = |WindowShape { history, block, lookahead }: WindowShape| {
            format!("{history},{block},{lookahead}")
        };
        add("--window", window.map(|window| window.0.map_or("auto".to_owned(), shape)));
        add("--vertical", self.vertical.map(|vertical| vertical.name().to_owned()));
        command
    }

    /// Back from [`EnsembleArgs::whole`]; `None` of what no such command is.
    pub fn of_whole(command: &[String]) -> Option<Self> {
        let arguments = ["schuler".to_owned()].into_iter().chain(command.iter().cloned());
        match Cli::try_parse_from(arguments).ok()?.command() {
            Command::Ensemble(args) if args.command.is_none() => Some(*args),
            _ => None,
        }
    }
}

fn shard(text: &str) -> Result<Shard, Complaint> {
    const ACCEPTED: &str = "K/N with K from 1 to N, such as 3/8";
    let numbers = text.split_once('/').and_then(|(k, n)| Some([k.parse().ok()?, n.parse().ok()?]));
    match numbers {
        Some([k, n]) if 1 <= k && k <= n => Ok(Shard([k, n])),
        _ => Err(Complaint::new("is no shard", ACCEPTED)),
    }
}

fn batch(text: &str) -> Result<u64, Complaint> {
    const ACCEPTED: &str = "an integer from 1 up";
    let batch = text.parse().ok().filter(|&batch| batch > 0);
    batch.ok_or_else(|| Complaint::new("is not a number of runs", ACCEPTED))
}

/// How many threads to fly on.
pub fn threads(text: &str) -> Result<usize, Complaint> {
    const ACCEPTED: &str = "an integer from 1 to 1024";
    let threads = text.parse().ok().filter(|threads| (1..=1024).contains(threads));
    threads.ok_or_else(|| Complaint::new("is not a number of threads", ACCEPTED))
}
