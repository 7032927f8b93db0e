//! `schuler run`: the main job.

use crate::cli::RunArgs;
use crate::report::{self, DriftCsv, FlightFiles, drift_csv, rows};
use schuler_simulator::flight::Flight;
use schuler_simulator::output::{large_table, say};
use schuler_simulator::progress::Progress;
use schuler_simulator::recording::navigation::COLUMNS;
use schuler_simulator::scene::Scene;
use schuler_simulator::simulate::{FlightError, Simulation};
use std::path::{Path, PathBuf};

/// Flies a scene, prints the drift table and writes the files, as far as the flight goes.
pub fn run(args: &RunArgs) -> Result<(), FlightError> {
    let scene = args.scene()?;
    let directory = args.out.clone().unwrap_or_else(|| PathBuf::from("out").join(&scene.name));
    let (flight, end) = fly(args, &scene, &directory).inspect_err(|_| {
        if let Some(note) = report::files::of_earlier(&directory) {
            eprintln!("{note}");
        }
    })?;
    let neglected = flight.neglected.map(|neglected| neglected.line()).unwrap_or_default();
    let notes = report::planned(&flight) + &neglected;
    say(&format!("{}{notes}written to {}\n", report::table(&flight), directory.display()))?;
    end
}

/// Flies, and puts the files in their places: what was flown, and what ended it early, if anything.
fn fly(
    args: &RunArgs,
    scene: &Scene,
    directory: &Path,
) -> Result<(Flight, Result<(), FlightError>), FlightError> {
    let simulation = Simulation::new(scene, args.force_all)?;
    let progress = Progress::new(scene.samples());
    let mut files = FlightFiles::create(directory, args.wanted())?;
    let rows = scene.samples();
    let rows = args.every.map_or(rows, |every| every.kept(rows, 1.0 / scene.rate_hz));
    let columns = DriftCsv::columns(simulation.expects_scatter());
    let [nav, truth] = rows::NAMES;
    let tables = [(drift_csv::NAME, columns), (nav, COLUMNS.len()), (truth, COLUMNS.len())];
    for (name, columns) in tables.into_iter().take(if args.rows { 3 } else { 1 }) {
        if let Some(much) = large_table(&directory.join(name), rows, columns) {
            eprintln!("{much}");
        }
    }
    let (flight, end) = simulation
        .fly_as_far(&mut |instant| files.row(instant), &|sample| progress.reach(sample))?;
    progress.finish();
    files.finish(&flight)?;
    Ok((flight, end))
}
