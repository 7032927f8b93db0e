//! The runs of a scene, aligned on its first samples.

use super::{table, toml};
use crate::cli::{AlignArgs, Method};
use schuler::aiding::alignment::verdict::AlignmentFault;
use schuler_simulator::alignment::coarse::{self, Coarse};
use schuler_simulator::alignment::outcome::{self, Outcome};
use schuler_simulator::alignment::setup::Setup;
use schuler_simulator::alignment::spread::Spread;
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::output::{say, write};
use schuler_simulator::parallel;
use schuler_simulator::progress::Progress;
use schuler_simulator::recording::navigation::NavigationRow;
use schuler_simulator::scene::{Base, Scene};
use schuler_simulator::simulate::FlightError;
use schuler_simulator::source::Source;
use schuler_simulator::units::DEGREE;

/// Aligns runs of a scene, prints what they are off by, and writes where the first ends.
pub fn align(args: &AlignArgs, name: &str) -> Result<(), FlightError> {
    let (scene, alignment) = args.scene(name)?;
    let source = Source::new(&scene, false)?;
    let setup = Setup::new(&scene, &source, alignment)?;
    let runs = args.runs.unwrap_or(1);
    say(&head(&scene, &setup, args.method, runs))?;
    let coarse = match args.method {
        Method::Auto | Method::Fine => None,
        Method::Inertial => Some(Coarse::Inertial),
        Method::TwoVector => Some(Coarse::TwoVector),
    };
    let row = match coarse {
        Some(method) => {
            let one = |run| coarse::of_run(&setup, &source, run, method);
            let refused = |error: &dyn std::fmt::Display| {
                InputError::option(name, Complaint::new(error.to_string(), "--method fine"))
            };
            let found = all(runs, &one).map_err(|(_, error)| refused(&error))?;
            let errors: Vec<_> = found.iter().map(|(error, _)| *error).collect();
            if let Some((_, attitude)) = found.first() {
                say(&table::attitude(
                    if method == Coarse::Inertial { "inertial" } else { "two-vector" },
                    attitude,
                ))?;
            }
            say(&table::spread(&Spread::of_errors(&setup, &errors)))?;
            found.first().map(|(_, attitude)| {
                (row(&source.truth(setup.samples), &setup, Some(*attitude)), None)
            })
        }
        None => {
            let off = args.off.map(|degrees| degrees * DEGREE);
            let one = |run| outcome::of_run(&setup, &source, run, off);
            let outcomes = all(runs, &one)
                .map_err(|(run, (sample, fault))| failed(&scene, run, sample, fault))?;
            let spread = Spread::new(&setup, &outcomes);
            match outcomes.first() {
                Some(outcome) if runs == 1 => say(&table::one(outcome, spread.axes[2].limit))?,
                _ => say(&table::spread(&spread))?,
            }
            if let (Some(wanted), Some(outcome)) = (args.sigma, outcomes.first()) {
                good_enough(wanted * DEGREE, outcome, &setup)?;
            }
            outcomes.first().map(|one| (row(&one.solution, &setup, None), Some(one.aligned)))
        }
    };
    if let (Some(out), Some((row, aligned))) = (&args.out, row) {
        write(out, toml::initial(&row, aligned.as_ref()))?;
    }
    Ok(())
}

/// What is aligned.
fn head(scene: &Scene, setup: &Setup<'_>, method: Method, runs: u64) -> String {
    let base = setup.alignment().base;
    let method = match method {
        Method::Auto | Method::Fine => "fine",
        Method::Inertial => "inertial",
        Method::TwoVector => "two-vector",
    };
    let seconds = setup.samples as f64 / scene.rate_hz;
    let runs = if runs == 1 { "one run".to_owned() } else { format!("{runs} runs") };
    let still = if base == Base::Still { ", taken for still" } else { "" };
    let base = if base == Base::Still { String::new() } else { format!(", {}", base.name()) };
    format!("{}: {runs} of {seconds} s, {method}{base}{still}\n", scene.name)
}

/// What every run gives, in their order; or the first that fails, with its number.
fn all<T: Send, E: Send>(
    runs: u64,
    one: &(dyn Fn(u64) -> Result<T, E> + Sync),
) -> Result<Vec<T>, (u64, E)> {
    let progress = Progress::new(runs);
    let results = parallel::all(0..runs, parallel::processors(), one, &|done| progress.reach(done));
    progress.finish();
    results
}

/// Why a run cannot be aligned.
fn failed(scene: &Scene, run: u64, sample: u64, fault: AlignmentFault) -> FlightError {
    let at = match sample {
        0 => String::new(),
        _ => format!(" at sample {sample}, {} s", sample as f64 / scene.rate_hz),
    };
    let accepted = match fault {
        AlignmentFault::Pole => "a place below 84° of latitude",
        AlignmentFault::Unseen => {
            "a longer --for, in which the vehicle speeds up, slows down or turns"
        }
        AlignmentFault::Moved | AlignmentFault::Diverged => {
            "a base that is as the vehicle is: --base swaying or moving"
        }
        _ => "",
    };
    let complaint = Complaint::new(format!("run {run}{at}: {fault}"), accepted);
    FlightError::Stopped(InputError::option(&scene.name, complaint))
}

/// Refuses a heading that is poorer than wanted, with the time that would do where theory has it.
fn good_enough(wanted: f64, outcome: &Outcome, setup: &Setup<'_>) -> Result<(), InputError> {
    let sigma = outcome.aligned.heading_sigma;
    if sigma <= wanted {
        return Ok(());
    }
    let what = format!(
        "{} s give the heading to {:.4}° (1σ), not to {:.4}°",
        outcome.aligned.seconds,
        sigma / DEGREE,
        wanted / DEGREE
    );
    let still = setup.alignment().base == Base::Still;
    let seconds = still.then(|| setup.sensors.seconds(&setup.surroundings(), wanted)).flatten();
    let accepted = match seconds {
        Some(seconds) => format!("--for {:.0}", seconds.ceil()),
        None if still => {
            "a larger one: with the biases of these sensors no time would do".to_owned()
        }
        None => "a larger one, or a longer --for".to_owned(),
    };
    Err(InputError::option("--sigma", Complaint::new(what, accepted)))
}

/// Where the first run ends.
fn row(
    solution: &schuler::solution::Solution<f64>,
    setup: &Setup<'_>,
    attitude: Option<schuler::solution::Euler<f64>>,
) -> NavigationRow {
    NavigationRow {
        time_s: setup.time_s(),
        position: solution.position.map(|coordinate| coordinate.hi),
        velocity_ned: solution.velocity_ned.map(|v| v.hi),
        attitude: attitude.unwrap_or_else(|| solution.euler()),
    }
}
