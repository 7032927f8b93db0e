//! `schuler audit matrix`: the audit program on every target of this machine, all to the same bits.
//!
//! | file | what |
//! |---|---|
//! | `target` | the rows: what is built how, and what runs it |
//! | `tools` | what this machine has |
//! | `build` | building and running |
//! | `output` | the digests that are printed |
//! | `golden` | the digests that are stored |
//! | `judge` | the rows compared |
//! | `show` | the table |

mod build;
mod golden;
mod judge;
mod output;
mod show;
mod target;
mod tools;

use crate::cli::MatrixArgs;
use crate::input::{Complaint, InputError};
use build::Place;
use golden::Golden;
use output::Output;
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::Instant;
use target::{TARGETS, Target};
use tools::Machine;

pub use show::{ended, tables};

/// Folders that cargo builds in, one target after the other in each: a target is always built in the same,
/// with what others left there.
const LANES: usize = 2;

/// The whole table.
#[derive(Clone, Debug, Serialize)]
pub struct Matrix {
    /// A row for each target.
    pub rows: Vec<Row>,
    /// The digests at the end of every stage, as the first row has them.
    pub flights: Vec<Flight>,
    /// How many digests the first row printed.
    pub digests: usize,
    /// How many of them are golden.
    pub golden: usize,
}

/// One target.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// Its name.
    pub target: &'static str,
    /// The compiler's name of it.
    pub triple: String,
    /// The compiler.
    pub compiler: String,
    /// How it was built.
    pub flags: String,
    /// What ran it.
    pub runner: String,
    /// How long building and running took, s.
    pub time_s: f64,
    /// One digest over everything that it printed.
    pub digest: Option<String>,
    /// What it came to; absent until it is compared.
    pub verdict: Option<Verdict>,
}

/// What a row came to.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// It is what the others are compared with.
    First,
    /// The same bits as the first row's.
    Equal,
    /// The first place at which it parts from the first row.
    Parts(String),
    /// The first place at which it parts from the golden chains.
    PartsFromGolden(String),
    /// What went wrong when it was built or run.
    Failed(String),
    /// What this machine lacks for it.
    Missing(String),
}

/// The digest of a stage at its end.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Flight {
    /// Scene and configuration, or scene and stage.
    pub flight: String,
    /// The stage.
    pub stage: String,
    /// Its samples.
    pub samples: String,
    /// The digest.
    pub digest: String,
}

impl Matrix {
    /// Rows that keep the promise.
    pub fn equal(&self) -> usize {
        let kept = |row: &&Row| matches!(row.verdict, Some(Verdict::First | Verdict::Equal));
        self.rows.iter().filter(kept).count()
    }

    /// Rows that break it, or that could not be had though they were required; digests that are not
    /// golden, where all is required, count as one more.
    pub fn failed(&self, require_all: bool) -> usize {
        let failed = |row: &&Row| match row.verdict {
            Some(Verdict::First | Verdict::Equal) => false,
            Some(Verdict::Missing(_)) => require_all,
            _ => true,
        };
        let lacks_golden = require_all && self.golden != self.digests;
        self.rows.iter().filter(failed).count() + usize::from(lacks_golden)
    }
}

/// Builds and runs the audit program on every target; `done` hears of each row as it ends.
pub fn matrix(args: &MatrixArgs, done: &(dyn Fn(&Row) + Sync)) -> Result<Matrix, InputError> {
    let source = source(args.source.as_deref())?;
    let targets = chosen(&args.target, args.debug)?;
    let stored = args.golden.clone().unwrap_or_else(|| source.join("tests/golden"));
    if args.golden.is_some() && !stored.is_dir() {
        let complaint = Complaint::new("is no folder", "one that schuler audit record wrote");
        return Err(InputError::file(&stored.display().to_string(), complaint));
    }
    let stored = Golden::read(&stored)?;
    let machine = Machine::look().ok_or_else(|| {
        let complaint = Complaint::new("there is no rustc and cargo", "https://rustup.rs");
        InputError::option("audit matrix", complaint)
    })?;
    let builds = std::env::var_os("CARGO_TARGET_DIR").map(PathBuf::from);
    let place = Place {
        program: source.join("tests/audit"),
        builds: builds.unwrap_or_else(|| source.join("target")).join("audit"),
    };

    let finished = Mutex::new(Vec::new());
    let work = |lanes: &[usize]| {
        for &(number, target) in &targets {
            let lane = number % LANES;
            if lanes.contains(&lane) {
                let (row, output) = fly(&target, lane, &machine, &place);
                done(&row);
                if let Ok(mut finished) = finished.lock() {
                    finished.push((number, row, output));
                }
            }
        }
    };
    // Most of a build is one long crate, so two at a time keep two processors busy.
    if std::thread::available_parallelism().map_or(1, usize::from) < LANES {
        work(&[0, 1]);
    } else {
        std::thread::scope(|scope| {
            scope.spawn(|| work(&[0]));
            work(&[1]);
        });
    }
    let mut finished = finished.into_inner().unwrap_or_default();
    finished.sort_by_key(|(number, ..)| *number);
    let rows = finished.into_iter().map(|(_, row, output)| (row, output)).collect();
    Ok(judge::judged(rows, &stored))
}

/// Builds and runs one target.
fn fly(target: &Target, lane: usize, machine: &Machine, place: &Place) -> (Row, Option<Output>) {
    let start = Instant::now();
    let mut row = Row {
        target: target.name,
        triple: target.triple(machine).to_owned(),
        compiler: String::new(),
        flags: target.options(),
        runner: "itself".to_owned(),
        time_s: 0.0,
        digest: None,
        verdict: None,
    };
    let flown = try_to_fly(target, lane, machine, place, &mut row);
    row.time_s = start.elapsed().as_secs_f64();
    match flown {
        Ok(output) => (row, Some(output)),
        Err(verdict) => (Row { verdict: Some(verdict), ..row }, None),
    }
}

fn try_to_fly(
    target: &Target,
    lane: usize,
    machine: &Machine,
    place: &Place,
    row: &mut Row,
) -> Result<Output, Verdict> {
    let toolchain = machine.toolchain(target).map_err(Verdict::Missing)?;
    row.compiler = toolchain.compiler.version.clone();
    if let Some(runner) = target.runner.first() {
        let package = target.package;
        row.runner = tools::version(runner)
            .ok_or_else(|| Verdict::Missing(format!("no {runner}: apt-get install {package}")))?;
    }
    let image = place.build(target, lane, machine, &toolchain).map_err(Verdict::Failed)?;
    let text = place.run(target, &image).map_err(Verdict::Failed)?;
    Output::parse(text).map_err(Verdict::Failed)
}

/// The project's folder.
fn source(given: Option<&Path>) -> Result<PathBuf, InputError> {
    let holds = |folder: &Path| folder.join("tests/audit/Cargo.toml").is_file();
    let missing = |folder: &Path| {
        let complaint = Complaint::new(
            format!("{} holds no tests/audit", folder.display()),
            "the folder of the project's sources",
        );
        InputError::option("--source", complaint)
    };
    let fault = |error: std::io::Error| {
        InputError::option("--source", Complaint::new(error.to_string(), "a folder"))
    };
    if let Some(folder) = given {
        let folder = folder.canonicalize().map_err(fault)?;
        return if holds(&folder) { Ok(folder) } else { Err(missing(&folder)) };
    }
    let here = std::env::current_dir().map_err(fault)?;
    here.ancestors().find(|folder| holds(folder)).map(Path::to_owned).ok_or_else(|| missing(&here))
}

/// The rows that are asked for, numbered, after the first, with which they are compared.
fn chosen(names: &[String], debug: bool) -> Result<Vec<(usize, Target)>, InputError> {
    if let Some(name) = names.iter().find(|name| TARGETS.iter().all(|t| t.name != **name)) {
        let accepted: Vec<_> = TARGETS.iter().map(|target| target.name).collect();
        let complaint = Complaint::new(format!("there is no target {name}"), accepted.join(", "));
        return Err(InputError::option("--target", complaint));
    }
    let wanted = |(number, target): &(usize, &Target)| {
        *number == 0 || names.is_empty() || names.iter().any(|name| name == target.name)
    };
    Ok(TARGETS
        .iter()
        .enumerate()
        .filter(wanted)
        .map(|(number, target)| match number {
            1.. if debug => (number, target.debug()),
            _ => (number, *target),
        })
        .collect())
}
