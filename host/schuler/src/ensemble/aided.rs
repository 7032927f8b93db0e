//! An ensemble of aided runs: their errors beside what their filters say, and whether that is consistent.

use crate::aided;
use crate::cli::EnsembleArgs;
use schuler_simulator::aided::report::Count;
use schuler_simulator::aided::runs::{self, Ended, GROUPS, Run, Together};
use schuler_simulator::flight::Nine;
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::number::rounded;
use schuler_simulator::output::{OutputFile, place, say};
use schuler_simulator::parallel;
use schuler_simulator::progress::Progress;
use schuler_simulator::scene::Scene;
use schuler_simulator::simulate::FlightError;
use schuler_simulator::source::Source;
use schuler_simulator::units::ARCSECOND;
use std::path::Path;

/// Rows of the table.
const ROWS: usize = 12;

/// Flies the runs, prints the table, and writes aided.csv.
pub fn ensemble(
    args: &EnsembleArgs,
    scene: &Scene,
    source: &Source,
    stops: &[u64],
    folder: &Path,
) -> Result<(), FlightError> {
    refuse(args)?;
    let mut file = OutputFile::create(folder.join("aided.csv"))?;
    let progress = Progress::new(args.runs);
    let one = |run| runs::fly(scene, source, run, stops);
    let flown = parallel::all(args.runs, &one, &|done| progress.reach(done));
    progress.finish();
    let flown = flown.map_err(|(run, ended)| stopped(scene, run, ended))?;
    let together = runs::together(&flown);
    file.put(csv(&together))?;
    place(vec![file], &[])?;
    let counts = runs::counts(&flown);
    say(&format!(
        "{}: {} runs\n\n{}\n{}{}written to {}\n",
        scene.name,
        flown.len(),
        table(&together),
        verdict(&together),
        measurements(&counts, &flown),
        folder.display()
    ))?;
    Ok(())
}

/// Refuses options that are of ensembles without aiding.
fn refuse(args: &EnsembleArgs) -> Result<(), InputError> {
    let options = [
        (args.shard.is_some(), "--shard"),
        (args.resume, "--resume"),
        (args.keep, "--keep"),
        (args.budget.is_some(), "--budget"),
    ];
    match options.iter().find(|(given, _)| *given) {
        Some((_, option)) => {
            let what = "is of an ensemble that is compared with theory, and this scene is aided";
            Err(InputError::option(option, Complaint::new(what, "--runs, --at, --out")))
        }
        None => Ok(()),
    }
}

fn stopped(scene: &Scene, run: u64, ended: Ended) -> FlightError {
    match ended {
        Ended::Start(error) => error.into(),
        Ended::Sample(sample, fault) => {
            let time_s = sample as f64 / scene.rate_hz;
            let complaint =
                Complaint::new(format!("run {run}, sample {sample} at {time_s} s: {fault}"), "");
            FlightError::Stopped(InputError::option(&scene.name, complaint))
        }
    }
}

/// The root of the mean square over a group's three axes.
fn norm(nine: &[f64; 9], group: usize) -> f64 {
    nine[3 * group..3 * group + 3].iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Some instants: rms and σ of position, velocity and attitude, and NEES.
fn table(together: &[Together]) -> String {
    let mut text = format!(
        "{:>7}{:>11}{:>9}{:>11}{:>9}{:>11}{:>9}{:>9}\n{:>7}{:>11}{:>9}{:>11}{:>9}{:>11}{:>9}{:>9}\n",
        "time",
        "position",
        "σ",
        "velocity",
        "σ",
        "attitude",
        "σ",
        "NEES",
        "s",
        "rms m",
        "said",
        "rms m/s",
        "said",
        "rms ″",
        "said",
        "by 9"
    );
    let step = together.len().div_ceil(ROWS).max(1);
    let rows =
        together.iter().enumerate().filter(|(i, _)| (together.len() - 1 - i).is_multiple_of(step));
    for (_, one) in rows {
        let pairs = [1.0, 1.0, 1.0 / ARCSECOND].into_iter().enumerate();
        let cells: String = pairs
            .map(|(group, unit)| {
                let [rms, sigma] =
                    [&one.rms, &one.sigma].map(|nine| rounded(norm(nine, group) * unit, 4));
                format!("{rms:>11}{sigma:>9}")
            })
            .collect();
        let mark = if is_consistent(one, 0) { ' ' } else { '!' };
        text +=
            &format!("{:>7}{cells}{:>8}{mark}\n", rounded(one.time_s, 5), rounded(one.nees[0], 3));
    }
    text
}

/// Whether the errors of a group are as the filters say, by chance in 95 of 100 cases.
fn is_consistent(one: &Together, group: usize) -> bool {
    let [least, most] = one.expected[group];
    (least..=most).contains(&one.nees[group])
}

/// How many of the instants are consistent, in words.
fn verdict(together: &[Together]) -> String {
    let mut text = String::new();
    for (group, name) in GROUPS.iter().enumerate() {
        let inside = together.iter().filter(|one| is_consistent(one, group)).count();
        let n = together.len().max(1) as f64;
        let mean = together.iter().map(|one| one.nees[group]).sum::<f64>() / n;
        let [least, most] = together.last().map_or([0.0; 2], |one| one.expected[group]);
        text += &format!(
            "NEES of {name}: {} of 1 on average; {inside} of {} instants within {} to {} (95 %)\n",
            rounded(mean, 3),
            together.len(),
            rounded(least, 3),
            rounded(most, 3)
        );
    }
    text
}

/// What became of the measurements of all runs.
fn measurements(counts: &[Count], flown: &[Run]) -> String {
    let sum = |value: fn(&Run) -> u32| flown.iter().map(value).sum();
    aided::lines(&schuler_simulator::aided::report::Report {
        sensors: counts.to_vec(),
        again: sum(|run| run.report.again),
        late: sum(|run| run.report.late),
        dropped: sum(|run| run.report.dropped),
        ..Default::default()
    })
}

/// Every instant: rms and σ of the nine, NEES.
fn csv(together: &[Together]) -> String {
    let mut text = "time_s".to_owned();
    for kind in ["rms", "sigma"] {
        for name in Nine::NAMES {
            text += &format!(",{name}_{kind}");
        }
    }
    for group in GROUPS {
        text += &format!(",nees_{group},nees_{group}_least,nees_{group}_most");
    }
    text.push('\n');
    for one in together {
        text += &one.time_s.to_string();
        for nine in [&one.rms, &one.sigma] {
            for (i, x) in nine.iter().enumerate() {
                let unit = if i < 6 { 1.0 } else { 1.0 / ARCSECOND };
                text += &format!(",{}", x * unit);
            }
        }
        for (nees, [least, most]) in one.nees.iter().zip(one.expected) {
            text += &format!(",{nees},{least},{most}");
        }
        text.push('\n');
    }
    text
}
