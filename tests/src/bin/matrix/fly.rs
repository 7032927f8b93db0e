//! Every target built and run, two at a time.

use super::arguments::MatrixArgs;
use super::build::Place;
use super::golden::Golden;
use super::judge;
use super::output::Output;
use super::target::{TARGETS, Target};
use super::tools::{self, Machine};
use super::verdict::{Matrix, Row, Verdict};
use schuler_simulator::input::{Complaint, InputError};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::Instant;

/// Folders that cargo builds in, one target after the other in each: a target is always built in the same,
/// with what others left there.
const LANES: usize = 2;

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
        InputError::option("matrix", complaint)
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
