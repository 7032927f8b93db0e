//! `schuler run`: the main job.

use crate::cli::RunArgs;
use crate::progress::Progress;
use crate::report::{self, DriftCsv};
use crate::simulate::{self, FlightError};
use std::path::PathBuf;

/// Flies a scene, prints the drift table and writes the files.
pub fn run(args: &RunArgs) -> Result<(), FlightError> {
    let scene = args.scene()?;
    let directory = args.out.clone().unwrap_or_else(|| PathBuf::from("out").join(&scene.name));
    let progress = Progress::new(scene.samples());
    let mut drift = DriftCsv::create(&directory.join("drift.csv"))?;
    let flight =
        simulate::fly(&scene, args.force_all, &mut |instant| drift.row(instant), &|sample| {
            progress.reach(sample)
        })?;
    progress.finish();
    drift.finish()?;
    if args.no_report {
        report::summary::write(&flight, &directory)?;
    } else {
        report::write(&flight, &directory)?;
    }
    print!("{}", report::table(&flight));
    println!("written to {}", directory.display());
    Ok(())
}
