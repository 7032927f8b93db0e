//! `schuler ensemble`: many runs of a scene, whose drift is compared with theory.
//!
//! Runs differ in their random numbers: turn-on biases, Gauss-Markov processes, noise. All fly
//! the same motion, whose truth and perfect increments are computed once.

mod check;
pub mod csv;
pub mod pace;
pub mod rounding;
pub mod statistics;
pub mod summary;
pub mod table;

pub use check::check;

use crate::cli::EnsembleArgs;
use schuler_simulator::ensemble::group::{Ground, Unit};
use schuler_simulator::lanes::Registers;
use schuler_simulator::number::{parameter, rounded, short};
use schuler_simulator::output::{self, OutputFile, say};
use schuler_simulator::progress::Progress;
use schuler_simulator::simulate::FlightError;
use schuler_simulator::source::{Source, SourceError};
use schuler_simulator::theory::Theory;
use statistics::Verdict;
use std::num::NonZero;
use std::path::PathBuf;
use std::thread;
use std::time::{Duration, Instant};
use summary::Outcome;

/// At how many times the drift is compared.
const INSTANTS: u64 = 8;

/// Flies, prints the comparison and writes `ensemble.csv` and `ensemble.json`.
pub fn ensemble(args: &EnsembleArgs) -> Result<(), FlightError> {
    let scene = args.scene()?;
    check(&scene)?;
    let directory = args.out.clone().unwrap_or_else(|| PathBuf::from("out").join(&scene.name));
    let source = Source::new(&scene, false)?;
    let theory = Theory::new(&scene).map_err(SourceError::Trajectory)?;
    let mut theory = theory.for_runs(args.runs);
    let ground = Ground::new(&scene, &source);
    let unit = ground.widest(args.runs);
    // A scene that cannot start, or a file that cannot be written, is found before the long work.
    ground.start(Unit::Alone, 0..1)?;
    let names = [csv::NAME, summary::NAME];
    let [table, summary] = names.map(|name| OutputFile::create(directory.join(name)));
    let (mut table, mut summary) = (table?, summary?);

    let groups = args.runs.div_ceil(unit.runs() as u64);
    let cores = thread::available_parallelism().map_or(1, NonZero::get);
    let threads = cores.min(usize::try_from(groups).unwrap_or(usize::MAX));
    let progress = Progress::new(scene.samples() * args.runs);
    let begin = Instant::now();
    let flown = schuler_simulator::ensemble::fleet::fly(
        &ground,
        args.runs,
        unit,
        threads,
        INSTANTS,
        &|samples| {
            // The bar moves at whole blocks of samples only.
            progress.reach(samples * args.runs / 4096 * 4096);
        },
    )?;
    let took = begin.elapsed();
    progress.finish();

    let ended = args.runs - flown.failed.len() as u64;
    // Of a single run there is no spread.
    let readings = if ended > 1 { flown.readings.as_slice() } else { &[] };
    let mut comparisons =
        statistics::compare(readings, |sample| source.time_s(sample), &mut theory);
    let rounding = rounding::rounding(&ground, readings, threads, INSTANTS)?;
    let left_out = rounding::leave_out(&mut comparisons, &rounding, ended);
    let verdict = Verdict::new(&comparisons);
    table.put(csv::bytes(&comparisons))?;
    let outcome = Outcome {
        scene: &scene,
        window: ground.plan.window,
        runs: [args.runs, flown.failed.len() as u64],
        saturated: flown.saturated,
        verdict: &verdict,
        left_out,
    };
    summary.put(summary::json(&outcome, &names))?;
    output::place(vec![table, summary], &[])?;
    let outside = statistics::outside(readings, |sample| source.time_s(sample), &mut theory);
    let mut text = table::table(&comparisons, ended);
    if let Some((time_s, outside)) = outside {
        let time_s = parameter(time_s);
        text += &format!("not comparable at {time_s} s: the linear model ends where {outside}\n");
    }
    if left_out > 0 {
        let (precision, all) = (scene.navigator.precision.name(), comparisons.len());
        text += &format!(
            "not compared: {left_out} of {all}, where rounding in {precision} is above a third of the mean's \
             standard error\n"
        );
    }
    text += &table::failures(&flown.failed, scene.seed, args.runs, |sample| source.time_s(sample));
    if flown.saturated > 0 {
        let samples = flown.saturated;
        text +=
            &format!("a sensor was at its limit in {samples} samples, which theory leaves out\n");
    }
    text += &speed(args.runs, took, unit, threads, pace::navigation_ns(&ground, unit)?);
    text += &format!("written to {}\n", directory.display());
    say(&text)?;
    match verdict {
        _ if !flown.failed.is_empty() => {
            Err(FlightError::Runs { failed: flown.failed.len(), runs: args.runs })
        }
        Verdict { failed: 0, .. } => Ok(()),
        Verdict { failed, tests, .. } => Err(FlightError::Failed { failed, checks: tests }),
    }
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
