//! The end of an ensemble, flown at once or merged: findings, files, tables, verdict.

use super::files::{Extra, Files};
use super::findings::Findings;
use super::sentences::sentences;
use super::summary::Outcome;
use super::{figures, summary, table};
use crate::cli::{EnsembleArgs, MergeArgs};
use crate::report::files::tell_replaced_by;
use schuler_simulator::ensemble::batches::Means;
use schuler_simulator::ensemble::group::{Ground, Unit};
use schuler_simulator::ensemble::kept::Kept;
use schuler_simulator::input::InputError;
use schuler_simulator::number::parameter;
use schuler_simulator::output::{GrowingFile, say};
use schuler_simulator::parallel;
use schuler_simulator::simulate::FlightError;
use std::path::PathBuf;

/// What was put together, and how it is to be told.
pub struct Merged<'a> {
    /// What was asked for.
    pub args: &'a MergeArgs,
    /// The command of the whole.
    pub whole: &'a EnsembleArgs,
    /// The scene, and where runs start.
    pub ground: &'a Ground<'a>,
    /// Samples taken at each reading.
    pub stops: &'a [u64],
}

/// An ensemble about to end.
pub struct Conclusion<'a> {
    /// The scene, and where runs start.
    pub ground: &'a Ground<'a>,
    /// The command of the whole.
    pub whole: &'a EnsembleArgs,
    /// How runs fly.
    pub means: Means<'a>,
    /// What is written besides.
    pub extra: Extra,
    /// Runs that are flown with each error term switched off.
    pub budget: Option<u64>,
    /// For the files.
    pub folder: PathBuf,
}

impl Conclusion<'_> {
    /// The files, not yet in their places; says whose they will replace.
    pub fn files(&self) -> Result<Files, InputError> {
        let files = Files::create(&self.folder, self.extra)?;
        let program = std::iter::once("schuler".to_owned());
        let command: Vec<_> = program.chain(command(self.whole, self.extra, self.budget)).collect();
        tell_replaced_by(&self.folder, summary::NAME, &command);
        Ok(files)
    }

    /// Finds out what there is to be found out, writes it, prints it with a `note` of how it was flown, and takes
    /// away parts that have served.
    pub fn conclude(
        self,
        files: Files,
        kept: Kept,
        note: String,
        served: &[PathBuf],
    ) -> Result<(), FlightError> {
        let Self { ground, whole, means, extra, budget, folder } = self;
        let command = command(whole, extra, budget);
        let (scene, runs) = (ground.scene, kept.runs.end);
        let findings = Findings::new(ground, &kept, budget, means)?;
        let sentences = sentences(&findings);
        let failed = kept.flown.failed.len();
        let outcome = Outcome {
            scene,
            command: &command,
            window: ground.plan.window,
            runs: [runs, failed as u64],
            saturated: kept.flown.saturated,
            findings: &findings,
            sentences: &sentences,
        };
        let time_s = |sample: u64| ground.source.time_s(sample);
        files.finish(&outcome, &kept, time_s)?;
        served.iter().try_for_each(|part| GrowingFile::remove(part))?;
        let mut text = text(ground, &kept, &findings, &sentences);
        text += &note;
        text += &format!("written to {}\n", folder.display());
        say(&text)?;
        let (verdict, together) = (findings.verdict, findings.together);
        match verdict.failed + together.failed {
            _ if failed > 0 => Err(FlightError::Runs { failed, runs }),
            0 => Ok(()),
            failed => Err(FlightError::Failed { failed, checks: verdict.tests + together.tests }),
        }
    }
}

/// The command of the whole, with what was done beside flying it: an argument each, after the program's name.
pub fn command(whole: &EnsembleArgs, extra: Extra, budget: Option<u64>) -> Vec<String> {
    let mut command = whole.whole();
    for (is_wanted, option) in [(extra.keep, "--keep"), (extra.svg, "--svg")] {
        command.extend(is_wanted.then(|| option.to_owned()));
    }
    if let Some(budget) = budget {
        command.extend(["--budget".to_owned(), budget.to_string()]);
    }
    command
}

/// What is said of it: tables, sentences, and what was left out.
pub fn text(ground: &Ground, kept: &Kept, findings: &Findings, sentences: &[String]) -> String {
    let (scene, runs) = (ground.scene, kept.runs.end);
    let time_s = |sample: u64| ground.source.time_s(sample);
    let mut text = table::table(&findings.comparisons, findings.ended);
    text += &figures::together(findings);
    for sentence in sentences {
        text += sentence;
        text.push('\n');
    }
    if let Some((time_s, outside)) = findings.outside {
        let time_s = parameter(time_s);
        text += &format!("not comparable at {time_s} s: the linear model ends where {outside}\n");
    }
    if findings.left_out > 0 {
        let (precision, all) = (scene.navigator.precision.name(), findings.comparisons.len());
        let left_out = findings.left_out;
        text += &format!(
            "not compared: {left_out} of {all}, where rounding in {precision} is above a third of the mean's \
             standard error\n"
        );
    }
    text += &table::failures(&kept.flown.failed, scene.seed, runs, time_s);
    if kept.flown.saturated > 0 {
        let samples = kept.flown.saturated;
        text +=
            &format!("a sensor was at its limit in {samples} samples, which theory leaves out\n");
    }
    text += &figures::accuracy(findings);
    text += &figures::budget(findings);
    text
}

/// Threads for so many runs: those that are asked for, or as many as there are processors.
pub fn threads(wanted: Option<usize>, unit: Unit, runs: u64) -> usize {
    let groups = usize::try_from(runs.div_ceil(unit.runs() as u64)).unwrap_or(usize::MAX);
    wanted.unwrap_or_else(parallel::processors).min(groups).max(1)
}
