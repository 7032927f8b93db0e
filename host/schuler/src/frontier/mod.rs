//! `schuler frontier`: run time against error, over algorithm, window, frame, precision and rate.
//!
//! A scene gives its motion and its length; sensors are perfect and the start is exact. Errors are the
//! largest over every row. Times are of navigation alone, at block ends without reading rows. A scene's
//! front has the points that no other point beats both in time per second of flight (ns per sample × rate) and in
//! the largest position error.

pub mod case;
pub mod chunk;
pub mod csv;
pub mod front;
pub mod measure;
pub mod pace;
pub mod page;
pub mod plot;
#[cfg(test)]
mod sample;
pub mod table;
pub mod task;

use crate::cli::FrontierArgs;
use case::Case;
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::number::parameter;
use schuler_simulator::output::{OutputFile, say};
use schuler_simulator::progress::Progress;
use schuler_simulator::simulate::FlightError;
use std::io;
use std::path::{Path, PathBuf};

/// How often each case is timed.
const PASSES: usize = 25;
/// The same for `--quick`.
const QUICK_PASSES: usize = 9;

/// One case, measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// The scene's name.
    pub scene: String,
    /// Seconds flown.
    pub duration_s: f64,
    /// Samples per second.
    pub rate_hz: f64,
    /// How it is navigated.
    pub case: Case,
    /// Median time per sample, ns.
    pub ns_per_sample: f64,
    /// From the first to the third quartile of the times, ns per sample.
    pub ns_spread: f64,
    /// Largest position error, m.
    pub max_position_m: f64,
    /// Largest velocity error, m/s.
    pub max_velocity_m_s: f64,
    /// Largest attitude error, arcsec.
    pub max_attitude_arcsec: f64,
    /// Whether no other point of the scene beats it.
    pub on_front: bool,
}

impl Point {
    /// Time per second of flight, µs: what the front weighs against the error.
    pub fn cost_us_per_s(&self) -> f64 {
        1e-3 * self.ns_per_sample * self.rate_hz
    }

    /// The case with its rate, for people.
    pub fn name(&self) -> String {
        format!("{} {} Hz", self.case, parameter(self.rate_hz))
    }
}

/// One case that cannot be measured.
#[derive(Clone, Debug, PartialEq)]
pub struct LeftOut {
    /// The scene's name.
    pub scene: String,
    /// Samples per second.
    pub rate_hz: f64,
    /// How it would be navigated.
    pub case: Case,
    /// What stands in the way.
    pub why: String,
}

/// Measures, writes `frontier.csv`, `frontier.png` and `frontier.html`, prints the table.
pub fn frontier(args: &FrontierArgs) -> Result<(), FlightError> {
    let tasks = task::tasks(args)?;
    let directory = args.out.clone().unwrap_or_else(|| PathBuf::from("out").join("frontier"));
    // What cannot be written is found before the long work, not after it.
    let table_file = OutputFile::create(directory.join("frontier.csv"))?;
    let picture_file = OutputFile::create(directory.join("frontier.png"))?;
    let page_file = OutputFile::create(directory.join(page::NAME))?;
    let cases = Case::all();
    let passes = if args.quick { QUICK_PASSES } else { PASSES };
    let timed = |task: &task::Task| -> u64 {
        task.at_rates().map(|scene| scene.samples().min(pace::SAMPLES)).sum()
    };
    let samples: u64 = tasks.iter().map(|task| task.samples() + passes as u64 * timed(task)).sum();
    let progress = Progress::new(samples * cases.len() as u64);
    let mut done = 0;
    let (mut points, mut left_out) = (Vec::new(), Vec::new());
    for task in &tasks {
        let begin = points.len();
        for scene in task.at_rates() {
            let (measured, left) = measure::measure(&scene, &cases, passes, &mut |samples| {
                done += samples;
                // The bar moves at whole blocks of samples only.
                progress.reach(done / 4096 * 4096);
            })?;
            points.extend(measured);
            left_out.extend(left);
        }
        front::mark(&mut points[begin..]);
    }
    progress.finish();
    table_file.fill(csv::bytes(&points))?;
    picture_file.fill(plot::png(&points).map_err(|error| cannot_be_drawn(&directory, &error))?)?;
    let mut text = table::table(&points);
    text += &table::left_out(&tasks, &cases, &left_out);
    page_file.fill(page::page(&points, &text))?;
    text += &format!("\nwritten to {}\n", directory.display());
    say(&text)?;
    Ok(())
}

fn cannot_be_drawn(directory: &Path, error: &io::Error) -> InputError {
    let path = directory.join("frontier.png");
    let complaint = Complaint::new(format!("cannot be drawn: {error}"), "");
    InputError::file(&path.display().to_string(), complaint)
}
