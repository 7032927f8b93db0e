//! An ensemble of aided runs: their errors beside what their filters say, and whether that is consistent.
//!
//! | file | what |
//! |---|---|
//! | [`findings`] | all that is found out |
//! | [`table`], [`csv`], `charts`, [`page`] | how it is told |
//! | `files` | the files |

mod charts;
pub mod csv;
mod files;
pub mod findings;
pub mod page;
pub mod table;

use super::conclusion::{Merged, command, threads};
use super::files::Extra;
use super::findings::Share;
use super::flying::{self, Begun, Flown};
use super::summary::{NAME, Told};
use crate::cli::{EnsembleArgs, Shard};
use crate::report::files::tell_replaced_by;
use files::Files;
use findings::Findings;
use schuler_simulator::aided::batches::{Means, fly_range};
use schuler_simulator::aided::budget::{by_switching_off, of_scene};
use schuler_simulator::aided::kept::AidedRuns;
use schuler_simulator::aided::runs::Scenes;
use schuler_simulator::ensemble::group::{Ground, Unit};
use schuler_simulator::ensemble::part::header::Header;
use schuler_simulator::number::{rounded, short};
use schuler_simulator::output::{GrowingFile, say};
use schuler_simulator::progress::Progress;
use schuler_simulator::scene::Scene;
use schuler_simulator::simulate::FlightError;
use std::path::PathBuf;

/// Failed runs that are named, at most.
const NAMED: usize = 20;

/// Flies the runs of the whole or of a shard.
pub fn ensemble(
    args: &EnsembleArgs,
    ground: &Ground,
    stops: &[u64],
    folder: PathBuf,
) -> Result<(), FlightError> {
    let Shard(shard) = args.shard.unwrap_or(Shard([1, 1]));
    let header = Header::new(ground, args.whole(), args.runs, shard, stops);
    let path = flying::part(&folder, args.shard);
    let begun = Begun::<AidedRuns>::new(args, path.clone(), header)?;
    let left = begun.left();
    let threads = threads(args.threads, Unit::Alone, left.end - left.start);
    let means = Means { threads, stops, batch: args.batch };
    let conclusion = Conclusion {
        ground,
        whole: args,
        means,
        extra: Extra { keep: args.keep, svg: args.svg },
        budget: args.budget,
        folder,
    };
    if args.shard.is_some() {
        let Flown { kept, now: (flown, took) } = fly(begun, ground, means)?;
        let what = (&kept.numbers, kept.failed.len());
        let text = super::shard_text(&path, shard, what, [flown, args.runs], took);
        return say(&text).map_err(Into::into);
    }
    // A file that cannot be written is found before the long work.
    let files = conclusion.files()?;
    let Flown { kept, now: (flown, took) } = fly(begun, ground, means)?;
    let seconds = took.as_secs_f64();
    let note = match flown {
        0 => String::new(),
        _ => format!(
            "{flown} runs in {} s: {} per second, on {threads} {}\n",
            rounded(seconds, 3),
            short(flown as f64 / seconds),
            if threads == 1 { "core" } else { "cores" }
        ),
    };
    conclusion.conclude(files, kept, &note, &[path])
}

/// The same of parts that were put together.
pub fn conclude(merged: Merged, kept: AidedRuns) -> Result<(), FlightError> {
    let Merged { args, whole, ground, stops } = merged;
    let threads = threads(args.threads, Unit::Alone, kept.numbers.end);
    let conclusion = Conclusion {
        ground,
        whole,
        means: Means { threads, stops, batch: None },
        extra: Extra { keep: args.keep, svg: args.svg },
        budget: args.budget,
        folder: super::folder(args.out.as_deref(), ground.scene),
    };
    let files = conclusion.files()?;
    conclusion.conclude(files, kept, "", &[])
}

fn fly(
    begun: Begun<AidedRuns>,
    ground: &Ground,
    means: Means,
) -> Result<Flown<AidedRuns>, FlightError> {
    begun.fly(|left, done| {
        let progress = Progress::new(left.end - left.start);
        let scenes = Scenes::of(ground.scene, ground.source);
        fly_range(scenes, left, means, &|flown| progress.reach(flown), done)?;
        progress.finish();
        Ok(())
    })
}

/// An ensemble about to end.
struct Conclusion<'a> {
    ground: &'a Ground<'a>,
    whole: &'a EnsembleArgs,
    means: Means<'a>,
    extra: Extra,
    budget: Option<u64>,
    folder: PathBuf,
}

impl Conclusion<'_> {
    /// The files, not yet in their places; says whose they will replace.
    fn files(&self) -> Result<Files, FlightError> {
        let smoothed = self.ground.scene.aiding.filter.smoother;
        let files = Files::create(&self.folder, smoothed, self.extra)?;
        let program = std::iter::once("schuler".to_owned());
        let command: Vec<_> = program.chain(command(self.whole, self.extra, self.budget)).collect();
        tell_replaced_by(&self.folder, NAME, &command);
        Ok(files)
    }

    /// Finds out what there is to be found out, writes it, prints it, and takes away parts that have served.
    fn conclude(
        self,
        files: Files,
        kept: AidedRuns,
        note: &str,
        served: &[PathBuf],
    ) -> Result<(), FlightError> {
        let Self { ground, whole, means, extra, budget, folder } = self;
        let (scene, runs) = (ground.scene, kept.numbers.end);
        let progress = Progress::new(budget.map_or(0, |_| of_scene(scene).len() as u64));
        let shares = shares(scene, &kept, budget, means, &|done| progress.reach(done))?;
        progress.finish();
        let failed = kept.failed.len();
        let findings = Findings::new(&kept, scene.rate_hz, shares);
        let sentences = findings.sentences();
        let verdict = findings.verdict;
        let command = command(whole, extra, budget);
        let told = Told {
            scene,
            command: &command,
            window: ground.plan.window,
            runs: [runs, failed as u64],
            saturated: findings.saturated,
            tests: [0; 3],
            together: [verdict.tests, verdict.failed],
            accuracy: findings.accuracy.last(),
            sentences: &sentences,
            measurements: Some(&findings.report),
        };
        files.finish(&told, &findings)?;
        served.iter().try_for_each(|part| GrowingFile::remove(part))?;
        let text = text(scene, &kept, &findings, &sentences);
        say(&format!("{text}{note}written to {}\n", folder.display()))?;
        match findings.too_sure() {
            _ if failed > 0 => Err(FlightError::Runs { failed, runs }),
            0 => Ok(()),
            failed => Err(FlightError::Failed { failed, checks: verdict.tests }),
        }
    }
}

/// What each error term contributes, by flying so many runs without it; `progress` gets how many terms are done.
pub fn shares(
    scene: &Scene,
    kept: &AidedRuns,
    budget: Option<u64>,
    means: Means,
    progress: &dyn Fn(u64),
) -> Result<Vec<Share>, FlightError> {
    let Some(runs) = budget.filter(|_| !kept.ended.is_empty()) else { return Ok(Vec::new()) };
    let mut shares = Vec::new();
    for term in of_scene(scene) {
        let runs = by_switching_off::<FlightError>(scene, &term, kept, runs, means)?;
        shares.push(Share { name: term.name, theory: Vec::new(), runs });
        progress(shares.len() as u64);
    }
    Ok(shares)
}

/// What is said of them.
pub fn text(scene: &Scene, kept: &AidedRuns, findings: &Findings, sentences: &[String]) -> String {
    format!(
        "{}: {} runs\n\n{}{}",
        scene.name,
        kept.numbers.end,
        table::text(findings, sentences),
        failures(kept, scene.seed, scene.rate_hz)
    )
}

/// The runs that did not reach their end: which, where and why.
fn failures(kept: &AidedRuns, seed: u64, rate_hz: f64) -> String {
    let failed = &kept.failed;
    if failed.is_empty() {
        return String::new();
    }
    let mut text = format!(
        "of the {} runs of {} that reached their end:\n",
        kept.ended.len(),
        kept.numbers.end
    );
    for one in failed.iter().take(NAMED) {
        let time_s = one.sample as f64 / rate_hz;
        let (run, sample, why) = (one.run, one.sample, one.why);
        text += &format!("run {run} of seed {seed} ended at sample {sample}, {time_s} s: {why}\n");
    }
    if failed.len() > NAMED {
        text += &format!("and {} more\n", failed.len() - NAMED);
    }
    text
}
