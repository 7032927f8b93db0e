//! `schuler run`: the main job.

use crate::cli::RunArgs;
use crate::input::{Complaint, InputError};
use crate::progress::Progress;
use crate::report::{self, DriftCsv, WriteError};
use crate::simulate::{self, FlightError};
use std::path::PathBuf;

/// Flies a scene, prints the drift table and writes the files.
pub fn run(args: &RunArgs) -> Result<(), FlightError> {
    let scene = args.scene()?;
    let directory = args.out.clone().unwrap_or_else(|| PathBuf::from("out").join(&scene.name));
    std::fs::create_dir_all(&directory).map_err(|error| {
        let complaint = Complaint::new(format!("cannot be created: {error}"), "");
        InputError::file(&directory.display().to_string(), complaint)
    })?;
    let progress = Progress::new(scene.samples());
    let mut drift = DriftCsv::create(&directory.join("drift.csv")).map_err(unwritten)?;
    let flight = simulate::fly(
        &scene,
        args.force_all,
        &mut |instant| drift.row(instant).map_err(unwritten),
        &|sample| progress.reach(sample),
    )?;
    progress.finish();
    drift.finish().map_err(unwritten)?;
    if args.no_report {
        report::summary::write(&flight, &directory).map_err(unwritten)?;
    } else {
        report::write(&flight, &directory).map_err(unwritten)?;
    }
    print!("{}", report::table(&flight));
    println!("written to {}", directory.display());
    Ok(())
}

fn unwritten(error: WriteError) -> InputError {
    let complaint = Complaint::new(format!("cannot be written: {}", error.source), "");
    InputError::file(&error.path.display().to_string(), complaint)
}
