//! `schuler run`: the main job.

use crate::aided;
use crate::align::table;
use crate::cli::RunArgs;
use crate::report::messages::Messages;
use crate::report::{self, DriftCsv, FlightFiles, drift_csv, rows};
use schuler_simulator::flight::{Flight, Instant};
use schuler_simulator::output::{large_table, say, say_error};
use schuler_simulator::progress::Progress;
use schuler_simulator::recording::navigation::COLUMNS;
use schuler_simulator::scene::Scene;
use schuler_simulator::simulate::{FlightError, Simulation};
use schuler_simulator::source::Source;
use std::path::Path;

/// Flies a scene, prints the drift table and writes the files, as far as the flight goes.
pub fn run(args: &RunArgs) -> Result<(), FlightError> {
    let scene = args.scene()?;
    let directory = args.folder(&scene);
    report::files::tell_replaced(&directory);
    let (flight, end) = fly(args, &scene, &directory).inspect_err(|_| {
        if let Some(note) = report::files::of_earlier(&directory) {
            say_error(&note);
        }
    })?;
    let messages = args.mcap.as_deref().map(|file| format!(" and {}", file.display()));
    let messages = messages.unwrap_or_default();
    say(&format!("{}written to {}{messages}\n", text(&flight), directory.display()))?;
    end
}

/// What is said of a flight.
pub fn text(flight: &Flight) -> String {
    let neglected = flight.neglected.map(|neglected| neglected.line()).unwrap_or_default();
    let aligned = flight.aligned.as_ref().map(table::begun).unwrap_or_default();
    let aided = flight.aided.as_ref().map(aided::lines).unwrap_or_default();
    report::table(flight) + &aligned + &aided + &report::planned(flight) + &neglected
}

/// Flies, and puts the files in their places: what was flown, and what ended it early, if anything.
fn fly(
    args: &RunArgs,
    scene: &Scene,
    directory: &Path,
) -> Result<(Flight, Result<(), FlightError>), FlightError> {
    let simulation = Simulation::of_run(scene, args.force_all, args.number)?;
    let progress = Progress::new(scene.samples());
    let mut files = FlightFiles::create(directory, args.wanted(scene))?;
    let rows = scene.samples();
    let rows = args.every.map_or(rows, |every| every.kept(rows, 1.0 / scene.rate_hz));
    let columns = DriftCsv::columns(simulation.expects_scatter());
    let [nav, truth] = rows::NAMES;
    let tables = [(drift_csv::NAME, columns), (nav, COLUMNS.len()), (truth, COLUMNS.len())];
    for (name, columns) in tables.into_iter().take(if args.rows { 3 } else { 1 }) {
        if let Some(much) = large_table(&directory.join(name), rows, columns) {
            say_error(&much);
        }
    }
    let source = args.mcap.as_ref().map(|_| Source::new(scene, args.force_all)).transpose()?;
    let mut messages = match (&args.mcap, &source) {
        (Some(file), Some(source)) => {
            Some(Messages::create(file, source, args.number, args.every)?)
        }
        _ => None,
    };
    let mut row = |instant: &Instant| {
        files.row(instant)?;
        messages.as_mut().map_or(Ok(()), |messages| messages.row(instant))
    };
    let (flight, end) = simulation.fly_as_far(&mut row, &|sample| progress.reach(sample))?;
    progress.finish();
    let messages = messages.map(Messages::into_file).transpose()?;
    files.finish(&flight, messages.into_iter().collect(), None)?;
    Ok((flight, end))
}
