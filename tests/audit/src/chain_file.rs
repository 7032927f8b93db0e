//! A flight's whole chain as a text that `schuler audit` reads.

use crate::aided;
use crate::configuration;
use crate::recording::{EVERY, Reader, Words};
use crate::scene::{MOST_SAMPLES, SCENES, SEED, Scene};
use crate::truth::{self, Refused};
use schuler::digest::Checkpoint;
use schuler::flight::configuration::{Configuration, Precision};
use schuler::sample::Increment;
use std::fmt::Write;

/// The chain of a flight; `None` if there is none of this name.
pub fn of(flight: &str) -> Option<Result<String, Refused>> {
    let (scene, rest) = flight.split_once('/')?;
    if scene == aided::SCENE.name {
        return aided_of(rest);
    }
    let scene = SCENES.iter().find(|s| s.name == scene)?;
    let mut configuration = None;
    configuration::each(|one| {
        if one.to_string().replace([' ', ','], "-") == rest {
            configuration = Some(*one);
        }
    });
    if configuration.is_none() && !["trajectory", "increments", "noise"].contains(&rest) {
        return None;
    }
    Some(fly(scene, configuration.as_ref(), rest))
}

/// The chain of an aided flight.
fn aided_of(name: &str) -> Option<Result<String, Refused>> {
    let mut found = None;
    aided::each(|configuration| {
        if configuration.to_string().replace([' ', ','], "-") == name {
            let is_single = configuration.precision != Precision::F64;
            let mut chain = ChainFile { is_single, ..ChainFile::default() };
            let flown = aided::fly(configuration, &mut chain);
            found = Some(flown.map(|()| chain.text(aided::SCENE, Some(configuration))));
        }
    });
    found
}

fn fly(
    scene: &Scene,
    configuration: Option<&Configuration>,
    stage: &str,
) -> Result<String, Refused> {
    let mut samples = [Increment::ZERO; MOST_SAMPLES];
    let mut chain = ChainFile { only: Some(stage), ..ChainFile::default() };
    let flown = truth::fly(scene, &mut samples, &mut chain)?;
    if let Some(configuration) = configuration {
        let is_single = configuration.precision != Precision::F64;
        chain = ChainFile { is_single, ..ChainFile::default() };
        configuration::fly(configuration, &flown, &mut chain)?;
    }
    Ok(chain.text(scene, configuration))
}

/// A chain as it is written.
#[derive(Default)]
struct ChainFile<'a> {
    /// The one stage that is wanted; else all of them are.
    only: Option<&'a str>,
    is_single: bool,
    stages: Vec<(&'static str, Vec<&'static str>)>,
    rows: String,
}

impl ChainFile<'_> {
    fn is_wanted(&self, stage: &str) -> bool {
        self.only.is_none_or(|only| only == stage)
    }

    fn line(&mut self, line: std::fmt::Arguments) {
        // A string takes everything.
        let _ = self.rows.write_fmt(line);
        self.rows.push('\n');
    }

    fn text(&self, scene: &Scene, configuration: Option<&Configuration>) -> String {
        let mut text = format!(
            "schuler chain 1\nscene: {}\nduration_s: {}\nrate_hz: {}\nseed: {SEED}\n",
            scene.name, scene.duration_s, scene.rate_hz
        );
        if let Some(configuration) = configuration {
            text += &format!("configuration: {configuration}\n");
        }
        text += &format!("checkpoint: {EVERY}\nrows: {}\n", scene.samples());
        let width = if self.is_single { "f32" } else { "f64" };
        for (stage, fields) in &self.stages {
            text += &format!("stage: {stage} {width} {}\n", fields.join(" "));
        }
        text + "\n" + &self.rows
    }
}

impl Reader for ChainFile<'_> {
    fn row(&mut self, stage: &'static str, sample: u64, words: Words) {
        if !self.is_wanted(stage) {
            return;
        }
        if self.stages.iter().all(|(name, _)| *name != stage) {
            let mut fields = Vec::new();
            words(&mut |name, _| fields.push(name));
            self.stages.push((stage, fields));
        }
        let digits = if self.is_single { 8 } else { 16 };
        let mut line = format!("{stage} {sample}");
        words(&mut |_, bits| line += &format!(" {bits:0digits$x}"));
        self.line(format_args!("{line}"));
    }

    fn checkpoint(&mut self, stage: &'static str, Checkpoint { sample, digest }: Checkpoint) {
        if self.is_wanted(stage) {
            self.line(format_args!("{stage} # {sample} {digest:016x}"));
        }
    }

    fn end(&mut self, stage: &'static str, Checkpoint { sample, digest }: Checkpoint) {
        if self.is_wanted(stage) {
            self.line(format_args!("{stage} = {sample} {digest:016x}"));
        }
    }
}
