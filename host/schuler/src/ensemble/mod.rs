//! `schuler ensemble`: many runs of a scene, whose drift is compared with theory.
//!
//! Runs differ in their random numbers: initial errors, turn-on biases, Gauss-Markov processes, noise. All fly
//! the same motion, whose truth and perfect increments are computed once.
//!
//! | file | what |
//! |---|---|
//! | `check` | what can be flown as an ensemble |
//! | [`flying`], [`merge`] | the runs of the whole, of a shard, of what was stopped; shards put together |
//! | [`values`], [`order`], [`spread`] | the runs at an instant; quantiles; mean, covariance, extremes |
//! | [`circular`], [`accuracy`] | CEP and vertical error, of normal distributions and of runs |
//! | [`statistics`], [`consistency`], [`rounding`] | χ² of mean and spread, NEES; where rounding matters |
//! | [`findings`], [`sentences`] | all of it, and what parts from theory in words |
//! | [`conclusion`] | findings, files, tables, verdict |
//! | [`table`], [`figures`], [`csv`], [`summary`], [`files`] | how it is told |
//! | [`page`], [`charts`] | the page, and its charts |
//! | [`pace`] | what navigation costs |
//! | [`aided`] | aided runs: their errors beside what their filters say |

pub mod accuracy;
pub mod aided;
pub mod charts;
mod check;
pub mod circular;
pub mod conclusion;
pub mod consistency;
pub mod csv;
pub mod figures;
pub mod files;
pub mod findings;
pub mod flying;
pub mod merge;
pub mod order;
pub mod pace;
pub mod page;
pub mod rounding;
pub mod sentences;
pub mod spread;
pub mod statistics;
pub mod summary;
pub mod table;
pub mod values;

pub use check::check;

use crate::cli::{EnsembleArgs, EnsembleCommand, Shard, Times};
use conclusion::{Conclusion, threads};
use files::Extra;
use flying::{Begun, Flown};
use schuler_simulator::ensemble::batches::Means;
use schuler_simulator::ensemble::group::{Ground, Unit};
use schuler_simulator::ensemble::instants;
use schuler_simulator::ensemble::part::header::Header;
use schuler_simulator::input::name::path_of;
use schuler_simulator::lanes::Registers;
use schuler_simulator::number::{rounded, short};
use schuler_simulator::output::say;
use schuler_simulator::scene::Scene;
use schuler_simulator::simulate::FlightError;
use schuler_simulator::source::Source;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Flies an ensemble or a shard of one, or puts shards together.
pub fn ensemble(args: &EnsembleArgs) -> Result<(), FlightError> {
    if let Some(EnsembleCommand::Merge(merge)) = &args.command {
        return merge::merge(merge);
    }
    let scene = args.scene()?;
    check(&scene)?;
    let folder = folder(args.out.as_deref(), &scene);
    let source = Source::new(&scene, false)?;
    let ground = Ground::new(&scene, &source);
    let stops = stops(&ground, &args.at);
    if scene.aiding.is_there() {
        return aided::ensemble(args, &ground, &stops, folder);
    }
    let Shard(shard) = args.shard.unwrap_or(Shard([1, 1]));
    let header = Header::new(&ground, args.whole(), args.runs, shard, &stops);
    let path = flying::part(&folder, args.shard);
    let begun = Begun::new(args, path.clone(), header)?;
    let left = begun.left();
    let runs = left.end - left.start;
    let unit = ground.widest(runs);
    let threads = threads(args.threads, unit, runs);
    let means = Means { unit, threads, stops: &stops, batch: args.batch };
    // A scene that cannot start, or a file that cannot be written, is found before the long work.
    ground.start(Unit::Alone, 0..1)?;
    if args.shard.is_some() {
        let Flown { kept, now: (flown, took) } = flying::fly(begun, &ground, means)?;
        let failed = kept.flown.failed.len();
        let text = shard_text(&path, shard, (&kept.runs, failed), [flown, args.runs], took);
        return say(&text).map_err(Into::into);
    }
    let conclusion = Conclusion {
        ground: &ground,
        whole: args,
        means,
        extra: Extra { keep: args.keep, svg: args.svg },
        budget: args.budget,
        folder,
    };
    let files = conclusion.files()?;
    let Flown { kept, now: (flown, took) } = flying::fly(begun, &ground, means)?;
    let note = match flown {
        0 => String::new(),
        _ => speed(flown, took, unit, means.threads, pace::navigation_ns(&ground, unit)?),
    };
    conclusion.conclude(files, kept, note, &[path])
}

/// Where the files go.
fn folder(out: Option<&Path>, scene: &Scene) -> PathBuf {
    out.map_or_else(|| PathBuf::from("out").join(path_of(&scene.name)), Path::to_owned)
}

/// How many samples are taken at each reading.
pub fn stops(ground: &Ground, times: &Times) -> Vec<u64> {
    match times {
        Times::Equal(count) => instants::equal(ground, *count),
        Times::Seconds(times_s) => instants::at(ground, times_s),
    }
}

/// What a shard is, and how to go on.
fn shard_text(
    path: &Path,
    [k, n]: [u64; 2],
    (kept, failed): (&Range<u64>, usize),
    [flown, runs]: [u64; 2],
    took: Duration,
) -> String {
    let (first, last) = (kept.start, kept.end.saturating_sub(1));
    let path = path.display();
    let failed = match failed {
        0 => String::new(),
        failed => format!(", of which {failed} did not reach their end"),
    };
    let seconds = rounded(took.as_secs_f64(), 3);
    format!(
        "shard {k} of {n}: runs {first} to {last} of {runs}{failed}; {flown} flown now, in {seconds} s\n\
         written to {path}\n`schuler ensemble merge` makes the whole of all {n}\n"
    )
}

/// What it took, and what flying side by side is worth.
fn speed(
    runs: u64,
    took: Duration,
    unit: Unit,
    threads: usize,
    [abreast_ns, alone_ns]: [f64; 2],
) -> String {
    let seconds = took.as_secs_f64();
    let cores = if threads == 1 { "1 core" } else { &format!("{threads} cores") };
    let side = match unit {
        Unit::Alone => "one at a time".to_owned(),
        unit => format!("{} side by side", unit.runs()),
    };
    let registers = match unit {
        Unit::In(Registers::Avx512) => " in AVX-512 registers",
        Unit::In(Registers::Avx2) => " in AVX2 registers",
        Unit::Alone => "",
    };
    let rate = short(runs as f64 / seconds);
    let seconds = rounded(seconds, 3);
    let alone = rounded(alone_ns, 3);
    let navigation = match unit {
        Unit::Alone => format!("navigation: {alone} ns per sample and run\n"),
        _ => format!(
            "navigation: {} ns per sample and run abreast, {alone} alone: {} times the throughput\n",
            rounded(abreast_ns, 3),
            rounded(alone_ns / abreast_ns, 3)
        ),
    };
    format!(
        "{runs} runs in {seconds} s: {rate} per second, {side} on each of {cores}{registers}\n{navigation}"
    )
}
