//! `schuler run`: the main job.

use crate::cli::RunArgs;
use crate::output::say;
use crate::progress::Progress;
use crate::report::{self, DriftCsv};
use crate::simulate::{FlightError, Simulation};
use std::path::PathBuf;

/// Flies a scene, prints the drift table and writes the files.
pub fn run(args: &RunArgs) -> Result<(), FlightError> {
    let scene = args.scene()?;
    let directory = args.out.clone().unwrap_or_else(|| PathBuf::from("out").join(&scene.name));
    let simulation = Simulation::new(&scene, args.force_all)?;
    let progress = Progress::new(scene.samples());
    let mut drift = DriftCsv::create(&directory.join("drift.csv"))?;
    let flight =
        simulation.fly(&mut |instant| drift.row(instant), &|sample| progress.reach(sample))?;
    progress.finish();
    drift.finish()?;
    if args.no_report {
        report::remove_pages(&directory)?;
        report::summary::write(&flight, &directory)?;
    } else {
        report::write(&flight, &directory)?;
    }
    let chosen = report::planned(&flight);
    say(&format!("{}{chosen}written to {}\n", report::table(&flight), directory.display()))?;
    Ok(())
}
